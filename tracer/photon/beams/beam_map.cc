#include "photon/beams/beam_map.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>

// A bounding volume hierarchy over triangles, asked with points in place of rays: which beams cover this place? The
// tree is complete and implicit (the children of node k are 2k and 2k + 1), built bottom-up over beams in Morton order,
// so it needs no pointers and no partitioning. Beams of one size are kept together first, since one wide beam would
// widen the boxes of all its neighbours.

namespace vitrail {
namespace {

constexpr std::size_t kBeamsPerLeaf = 4;

// On a curved surface a place lies off the plane through the corners by up to edge^2 / (8 radius), and the normals at
// the ends of an edge are edge / radius apart. Twice that much room covers surfaces that bend unevenly.
constexpr double kRoomPerTurn = 2.0 / 8;

// What rounding may do to a place, of its distance from the origin.
constexpr double kRounding = 0x1p-40;

// The sides of a surface agree if their normals are less than about 75 degrees apart, as for photons.
constexpr double kNormalAgreement = 0.25;

// Interleave the leading 21 bits of three coordinates.
std::uint64_t spread_bits(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

Vec3 normal_of(const BeamCorner& corner) { return {corner.normal[0], corner.normal[1], corner.normal[2]}; }

bool comes_first(Vec3 p, Vec3 q) { return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z); }

// Whether a place lies on the side of the edge from p to q on which r is, seen along a normal. Two beams share an edge:
// both look at it from the same end, so that a place on it belongs to one of them.
bool is_beside(Vec3 place, Vec3 p, Vec3 q, Vec3 r, Vec3 normal) {
  if (!comes_first(p, q)) std::swap(p, q);
  const bool wanted = dot(cross(q - p, r - p), normal) > 0;
  return (dot(cross(q - p, place - p), normal) > 0) == wanted;
}

double longest_side(Vec3 p, Vec3 q, Vec3 r) { return std::max({length(q - p), length(r - q), length(p - r)}); }

}  // namespace

void BeamMap::Box::include(const Box& other) {
  for (int a = 0; a < 3; ++a) {
    low[a] = std::min(low[a], other.low[a]);
    high[a] = std::max(high[a], other.high[a]);
  }
}

BeamMap::BeamMap(std::vector<BeamBlock> blocks) {
  for (BeamBlock& block : blocks) {
    const auto before = static_cast<std::uint32_t>(corners_.size());
    corners_.insert(corners_.end(), block.corners.begin(), block.corners.end());
    for (Beam beam : block.beams) {
      for (std::uint32_t& corner : beam.corner) corner += before;
      beams_.push_back(beam);
    }
    block = {};
  }
  if (beams_.empty()) return;
  sort_along_curve();
  build_boxes();
}

// Put the beams into the order of their sizes, by powers of two, and those of a size into the order of a curve through
// their middles that stays near every place for long [Morton 1966]: a box with a wide beam in it keeps no narrow ones.
void BeamMap::sort_along_curve() {
  const auto middle = [&](const Beam& beam) {
    return (corners_[beam.corner[0]].position + corners_[beam.corner[1]].position + corners_[beam.corner[2]].position) /
           3;
  };
  Vec3 low = middle(beams_[0]), high = low;
  for (const Beam& beam : beams_) {
    const Vec3 m = middle(beam);
    for (int a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], m[a]);
      high[a] = std::max(high[a], m[a]);
    }
  }
  const double extent = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  const double scale = extent > 0 ? (std::exp2(21) - 1) / extent : 0;
  std::vector<std::tuple<int, std::uint64_t, std::uint32_t>> order;
  order.reserve(beams_.size());
  for (std::size_t i = 0; i < beams_.size(); ++i) {
    const Beam& beam = beams_[i];
    const Vec3 m = (middle(beam) - low) * scale;
    const int size = std::ilogb(sides_of(beam).longest);
    const auto bits = [](double c) { return spread_bits(static_cast<std::uint64_t>(c)); };
    order.emplace_back(size, bits(m.x) | bits(m.y) << 1 | bits(m.z) << 2, static_cast<std::uint32_t>(i));
  }
  std::sort(order.begin(), order.end());
  std::vector<Beam> sorted;
  sorted.reserve(beams_.size());
  for (const auto& [size, code, index] : order) sorted.push_back(beams_[index]);
  beams_ = std::move(sorted);
}

BeamMap::Sides BeamMap::sides_of(const Beam& beam) const {
  const BeamCorner &p = corners_[beam.corner[0]], &q = corners_[beam.corner[1]], &r = corners_[beam.corner[2]];
  const double longest = longest_side(p.position, q.position, r.position);
  return {p.position, q.position, r.position, longest,
          longest * longest_side(normal_of(p), normal_of(q), normal_of(r)) * kRoomPerTurn};
}

BeamMap::Box BeamMap::box_of(const Beam& beam) const {
  const auto [p, q, r, longest, room] = sides_of(beam);
  Box box;
  for (int a = 0; a < 3; ++a) {
    // A float is good to 2^-24 of its size; two steps outwards cover that and the rounding of a place on the surface.
    const double low = std::min({p[a], q[a], r[a]}) - room, high = std::max({p[a], q[a], r[a]}) + room;
    box.low[a] = static_cast<float>(low - std::abs(low) * 0x1p-22);
    box.high[a] = static_cast<float>(high + std::abs(high) * 0x1p-22);
  }
  return box;
}

void BeamMap::build_boxes() {
  leaves_ = std::bit_ceil((beams_.size() + kBeamsPerLeaf - 1) / kBeamsPerLeaf);
  constexpr float kFar = std::numeric_limits<float>::infinity();
  boxes_.assign(2 * leaves_, Box{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}});
  for (std::size_t i = 0; i < beams_.size(); ++i) boxes_[leaves_ + i / kBeamsPerLeaf].include(box_of(beams_[i]));
  for (std::size_t k = leaves_; k-- > 1;) {
    boxes_[k] = boxes_[2 * k];
    boxes_[k].include(boxes_[2 * k + 1]);
  }
}

std::size_t BeamMap::predicted_bytes(std::size_t corners) {
  // Corners stand in their block and in the map; of a beam there are its own copy, its sorted one, its place in the
  // order and its part of the boxes.
  constexpr std::size_t kPerCorner = 2 * sizeof(BeamCorner);
  constexpr std::size_t kPerBeam = 3 * sizeof(Beam) + 24 + 2 * sizeof(Box) / kBeamsPerLeaf;
  return corners * (kPerCorner + 2 * kPerBeam);
}

Rgb BeamMap::irradiance(const GatherQuery& query) const {
  Rgb sum;
  if (beams_.empty()) return sum;
  const std::array<double, 3> place{query.position.x, query.position.y, query.position.z};
  std::array<std::size_t, 2 * 64> pending;
  std::size_t count = 0;
  pending[count++] = 1;
  while (count > 0) {
    const std::size_t k = pending[--count];
    if (!boxes_[k].holds(place)) continue;
    if (k < leaves_) {
      pending[count++] = 2 * k + 1;
      pending[count++] = 2 * k;
      continue;
    }
    const std::size_t first = (k - leaves_) * kBeamsPerLeaf, last = std::min(first + kBeamsPerLeaf, beams_.size());
    for (std::size_t i = first; i < last; ++i) sum += irradiance_of(beams_[i], query);
  }
  return sum;
}

Rgb BeamMap::irradiance_of(const Beam& beam, const GatherQuery& query) const {
  const BeamCorner* corner[3];
  for (int k = 0; k < 3; ++k) corner[k] = &corners_[beam.corner[k]];
  for (const BeamCorner* c : corner) {
    if (!(dot(normal_of(*c), query.normal) > kNormalAgreement)) return {};
  }

  // The place must lie between the rays, seen along the normal of their plane, and near that plane.
  const auto [p, q, r, longest, room] = sides_of(beam);
  const Vec3 twice_area = cross(q - p, r - p);
  const double squared = dot(twice_area, twice_area);
  if (!(squared > 0)) return {};
  const double off_plane = std::abs(dot(query.position - p, twice_area)) / std::sqrt(squared);
  if (off_plane > room + kRounding * (longest + length(query.position))) return {};
  const double weight[3] = {dot(cross(r - q, query.position - q), twice_area) / squared,
                            dot(cross(p - r, query.position - r), twice_area) / squared,
                            dot(cross(q - p, query.position - p), twice_area) / squared};
  const Vec3 place = query.position;
  const bool within = is_beside(place, q, r, p, twice_area) && is_beside(place, r, p, q, twice_area) &&
                      is_beside(place, p, q, r, twice_area);
  if (!within) return {};
  Rgb power;
  for (int k = 0; k < 3; ++k) {
    power += Rgb{corner[k]->power[0], corner[k]->power[1], corner[k]->power[2]} * weight[k];
  }
  return power * (static_cast<double>(beam.share) / (std::sqrt(squared) / 2));
}

}  // namespace vitrail
