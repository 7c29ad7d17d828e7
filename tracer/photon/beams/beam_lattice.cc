#include "photon/beams/beam_lattice.h"

#include <algorithm>
#include <cmath>

#include "material/roughen.h"

// For readers of pbrt: there is no counterpart. A photon map estimates irradiance as flux of random photons over the
// area of a disc; here the rays are neighbours on a lattice, and irradiance is the known flux between three of them
// over the area of the triangle that they enclose where they land [Heckbert and Hanrahan 1984; Watt 1990]: no kernel,
// no noise.
//
// This holds while the three rays have the same path signature: the same faces and lobes. LatticeRays therefore follows
// each lattice ray through all its branches and keeps where every branch lands and under which signature; BeamTracer
// joins the landings of a cell's two triangles signature by signature. The flux between the rays is never estimated: a
// triangle's share of the chart times the power that each corner would carry if the whole chart were like it.

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
// per cell are enough for them, and what is discontinuous from there on goes as photons.
constexpr std::uint64_t kMostRaysPerCell = 8;

// So many blocks say how much of the light is torn.
constexpr std::uint64_t kBlocksTried = 4;

}  // namespace

const char* unfit_for_beams(const Scene& scene, const Chart& chart) {
  const bool rough = scene.plan.roughness && std::any_of(scene.materials.begin(), scene.materials.end(),
                                                         [](const Material& m) { return is_rough(m.roughness); });
  if (rough) return "a face is rough";
  return needs_four(chart) ? "the light has an extent" : nullptr;
}

BeamLattice::BeamLattice(const PhotonPass& pass, const Chart& chart, Stream stream)
    : pass_(pass), chart_(chart), stream_(within(stream, 1)) {
  const double most = std::sqrt(static_cast<double>(chart.count) / kRaysPerCell);
  const double drawn = most * (1 - kDrawnShare * uniform(stream, 0, 0));
  shape_.cells = 2 * std::max(kFewestCells / 2, static_cast<std::uint32_t>(drawn / 2));
  shape_.halvings =
      std::clamp(static_cast<int>(std::lround(std::log2(shape_.cells / kCellsPerPiece))), 1, kMostHalvings);
}

std::uint64_t BeamLattice::blocks() const { return (shape_.cells + kRowsPerBlock - 1) / kRowsPerBlock; }

BeamPilot BeamLattice::pilot(const std::function<bool(const BeamPilot&)>& is_enough) const {
  const std::uint64_t step = std::max<std::uint64_t>(1, blocks() / kBlocksTried);
  double emitted = 0, torn = 0;
  std::size_t landings = 0, rays = 0;
  BeamPilot found;
  for (std::uint64_t b = step / 2; b < blocks() && !is_enough(found); b += step) {
    const BeamBlock block = trace(b);
    emitted += largest_channel(block.ledger.emitted);
    torn += largest_channel(block.remainder.as_photons);
    landings += block.corners.size();
    rays += block.landed_rays;
    if (emitted > 0) found.torn = torn / emitted;
    if (rays > 0) found.landings = static_cast<double>(landings) / static_cast<double>(rays);
  }
  return found;
}

BeamBlock BeamLattice::trace(std::uint64_t block) const {
  BeamBlock result;
  const std::uint64_t most_rays = kMostRaysPerCell * kRowsPerBlock * shape_.cells;
  BeamTracer tracer(pass_, chart_, shape_, most_rays, within(stream_, block), result);
  const auto first = static_cast<std::uint32_t>(block) * kRowsPerBlock;
  for (std::uint32_t j = first; j < std::min(shape_.cells, first + kRowsPerBlock); ++j) {
    for (std::uint32_t i = 0; i < shape_.cells; ++i) tracer.cell(i, j);
  }
  return result;
}

}  // namespace vitrail
