#include "photon/beams/beam_lattice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "material/roughen.h"
#include "photon/photon_tree.h"

// For readers of pbrt: there is no counterpart. A photon map estimates irradiance as flux of random photons over the
// area of a disc; here the rays are neighbours on a lattice, and irradiance is the known flux between three of them
// over the area of the triangle that they enclose where they land [Heckbert and Hanrahan 1984; Watt 1990]: no kernel,
// no noise.
//
// This holds while the three rays have the same path signature: the same faces and lobes. The tracer therefore follows
// each lattice ray through all its branches (PhotonTree), keeps where every branch lands and under which signature, and
// joins the landings of a cell's two triangles signature by signature. Where a signature is missing at a corner - the
// silhouette of a lens, the critical angle - the triangle is cut in four and the midpoints are traced; after
// `halvings_` cuts what remains is counted as truncated. The flux between the rays is never estimated: a triangle's
// share of the chart times the power that each corner would carry if the whole chart were like it.

namespace vitrail {
namespace {

constexpr std::uint32_t kRowsPerBlock = 8;

// By how much two lattices may differ in their cells: enough that nothing falls into the same places.
constexpr double kDrawnShare = 1.0 / 8;

constexpr std::uint32_t kFewestCells = 4;

// Half of the rays are kept for the cells at discontinuities.
constexpr double kRaysPerCell = 2;

// A discontinuity crosses about 4 cells per row. Halving a cell k times traces 2^k rays along it, so up to cells / 16
// the rays at discontinuities are no more than those of the lattice, and what is left undecided falls with the square
// of the cells.
constexpr double kCellsPerPiece = 16;
constexpr int kMostHalvings = 10;

// Thin glass sends light on along paths of hundreds of signatures, each with discontinuities of its own: so many rays
// per cell are enough for them, and what is discontinuous from there on is not refined.
constexpr std::uint64_t kMostRaysPerCell = 8;

// Light that lands so many radii of the scene away, near the horizon of an infinite floor, is too thin to be seen.
constexpr double kFarInRadii = 100;

}  // namespace

bool suits_beams(const Scene& scene, const Chart& chart) {
  const bool rough = scene.plan.roughness && std::any_of(scene.materials.begin(), scene.materials.end(),
                                                         [](const Material& m) { return is_rough(m.roughness); });
  return !rough && !needs_four(chart);
}

BeamLattice::BeamLattice(const PhotonPass& pass, const Chart& chart, Stream stream) : pass_(pass), chart_(chart) {
  const double most = std::sqrt(static_cast<double>(chart.count) / kRaysPerCell);
  const double drawn = most * (1 - kDrawnShare * uniform(stream, 0, 0));
  cells_ = 2 * std::max(kFewestCells / 2, static_cast<std::uint32_t>(drawn / 2));
  halvings_ = std::clamp(static_cast<int>(std::lround(std::log2(cells_ / kCellsPerPiece))), 1, kMostHalvings);
}

std::uint64_t BeamLattice::blocks() const { return (cells_ + kRowsPerBlock - 1) / kRowsPerBlock; }

/// Traces the rays of one block as they are asked for, and puts beams between them.
class BeamTracer : private LandingSink {
 public:
  BeamTracer(const BeamLattice& lattice, BeamBlock& block)
      : lattice_(lattice),
        block_(block),
        tree_(lattice.pass_, lattice.chart_.target, Stream{0}, *this, ledger_of_ray_),
        pieces_(1u << lattice.halvings_),
        most_rays_(kMostRaysPerCell * kRowsPerBlock * lattice.cells_) {}

  void cell(std::uint32_t i, std::uint32_t j) {
    const std::uint32_t a = i * pieces_, b = j * pieces_, c = a + pieces_, d = b + pieces_;
    const Triangle::value_type corner[4] = {ray(a, b), ray(c, b), ray(c, d), ray(a, d)};

    // Cut the cell along the diagonal of the chart that it may lie on: there the map onto a disc has its creases.
    const bool rising = (i < lattice_.cells_ / 2) == (j < lattice_.cells_ / 2);
    const int k = rising ? 0 : 1;
    triangle({corner[k], corner[k + 1], corner[k + 2]}, lattice_.halvings_, {});
    triangle({corner[k], corner[k + 2], corner[(k + 3) % 4]}, lattice_.halvings_, {});
  }

 private:
  // A place on a surface that a ray reaches.
  struct End {
    PathSignature signature;
    std::uint32_t corner;
    bool far;
    Rgb kept;
  };
  struct LatticeRay {
    std::uint32_t a, b;  // in the finest pieces of the cells
    double x, y;         // in the unit square
    std::uint32_t first_end, end_count;
    Ledger ledger;
  };
  using Triangle = std::array<std::uint32_t, 3>;
  using Signatures = std::vector<PathSignature>;

  std::uint32_t ray(std::uint32_t a, std::uint32_t b) {
    const auto [found, is_new] =
        index_.try_emplace(static_cast<std::uint64_t>(a) << 32 | b, static_cast<std::uint32_t>(rays_.size()));
    if (is_new) rays_.push_back(traced(a, b));
    return found->second;
  }

  // Follow a ray to all its ends, in the order of their signatures.
  LatticeRay traced(std::uint32_t a, std::uint32_t b) {
    const double all = static_cast<double>(lattice_.cells_) * pieces_;
    LatticeRay result{a, b, a / all, b / all, 0, 0, {}};
    result.first_end = static_cast<std::uint32_t>(ends_.size());
    ledger_of_ray_ = {};
    ++block_.rays;
    const UnitPoint point = unit_point(result.x, result.y);
    const Emission emission = emit(lattice_.chart_, {point, {}});
    if (!is_black(emission.power)) {
      const MediumSet media = lattice_.pass_.intersector.media_at(emission.ray.origin);
      tree_.follow({.path = {.ray = emission.ray, .media = media, .weight = emission.power},
                    .least = kLeastPhotonShare * largest_channel(emission.power)});
    }
    result.ledger = ledger_of_ray_;
    result.end_count = static_cast<std::uint32_t>(ends_.size()) - result.first_end;
    std::sort(ends_.begin() + result.first_end, ends_.end(),
              [](const End& x, const End& y) { return x.signature < y.signature; });
    return result;
  }

  void land(const Landing& landing) override {
    const auto as_floats = [](const auto& v, float* to) {
      for (int c = 0; c < 3; ++c) to[c] = static_cast<float>(v[c]);
    };
    BeamCorner corner{landing.position, {}, {}};
    as_floats(landing.normal, corner.normal);
    as_floats(landing.flux, corner.power);
    const double away = length(landing.position - lattice_.pass_.frame.origin);
    const bool far = away > kFarInRadii * lattice_.pass_.radius_m;
    ends_.push_back({landing.signature, static_cast<std::uint32_t>(block_.corners.size()), far, landing.kept});
    block_.corners.push_back(corner);
  }

  const End* end_of(std::uint32_t ray, PathSignature signature) const {
    const LatticeRay& from = rays_[ray];
    const auto first = ends_.begin() + from.first_end, last = first + from.end_count;
    const auto found =
        std::lower_bound(first, last, signature, [](const End& end, PathSignature s) { return end.signature < s; });
    return found != last && found->signature == signature ? &*found : nullptr;
  }

  double share_of(const Triangle& t) const {
    const LatticeRay &p = rays_[t[0]], &q = rays_[t[1]], &r = rays_[t[2]];
    return std::abs((q.x - p.x) * (r.y - p.y) - (r.x - p.x) * (q.y - p.y)) / 2;
  }

  // Put a beam on every signature that all three rays have, and refine where one of them does not. `done` are the
  // signatures that have their beam from a larger triangle.
  void triangle(const Triangle& t, int halvings, Signatures done) {
    Signatures discontinuous;
    bool matters = false;
    for (const std::uint32_t ray : t) {
      const LatticeRay& from = rays_[ray];
      for (std::uint32_t e = from.first_end; e < from.first_end + from.end_count; ++e) {
        const PathSignature signature = ends_[e].signature;
        if (std::find(done.begin(), done.end(), signature) != done.end()) continue;
        if (std::find(discontinuous.begin(), discontinuous.end(), signature) != discontinuous.end()) continue;
        if (beam(t, signature)) {
          done.push_back(signature);
        } else {
          discontinuous.push_back(signature);
          matters = matters || !ends_[e].far;
        }
      }
    }
    if (!matters || halvings == 0 || block_.rays >= most_rays_) {
      enter_in_ledger(t, discontinuous);
      return;
    }
    const Triangle middle{between(t[0], t[1]), between(t[1], t[2]), between(t[2], t[0])};
    triangle({t[0], middle[0], middle[2]}, halvings - 1, done);
    triangle({middle[0], t[1], middle[1]}, halvings - 1, done);
    triangle({middle[2], middle[1], t[2]}, halvings - 1, done);
    triangle(middle, halvings - 1, done);
  }

  std::uint32_t between(std::uint32_t p, std::uint32_t q) {
    return ray((rays_[p].a + rays_[q].a) / 2, (rays_[p].b + rays_[q].b) / 2);
  }

  bool beam(const Triangle& t, PathSignature signature) {
    Beam beam{{}, static_cast<float>(share_of(t))};
    for (int k = 0; k < 3; ++k) {
      const End* end = end_of(t[k], signature);
      if (end == nullptr) return false;
      beam.corner[k] = end->corner;
    }
    block_.beams.push_back(beam);
    return true;
  }

  // Each ray stands for a third of the triangle; what landed under a discontinuous signature is in no beam.
  void enter_in_ledger(const Triangle& t, const Signatures& discontinuous) {
    const double third = share_of(t) / 3;
    for (const std::uint32_t ray : t) {
      Ledger ledger = rays_[ray].ledger;
      for (const PathSignature signature : discontinuous) {
        if (const End* end = end_of(ray, signature)) {
          ledger.stored = ledger.stored - end->kept;
          (end->far ? ledger.escaped : ledger.truncated) += end->kept;
          if (!end->far) block_.at_discontinuities += end->kept * third;
        }
      }
      block_.ledger += ledger.scaled(third);
    }
  }

  const BeamLattice& lattice_;
  BeamBlock& block_;
  Ledger ledger_of_ray_;
  PhotonTree tree_;
  std::uint32_t pieces_;
  std::uint64_t most_rays_;
  std::vector<LatticeRay> rays_;
  std::vector<End> ends_;
  std::unordered_map<std::uint64_t, std::uint32_t> index_;  // of rays, by their place
};

BeamBlock BeamLattice::trace(std::uint64_t block) const {
  BeamBlock result;
  BeamTracer tracer(*this, result);
  const auto first = static_cast<std::uint32_t>(block) * kRowsPerBlock;
  for (std::uint32_t j = first; j < std::min(cells_, first + kRowsPerBlock); ++j) {
    for (std::uint32_t i = 0; i < cells_; ++i) tracer.cell(i, j);
  }
  return result;
}

}  // namespace vitrail
