#pragma once
/// How caustics are solved, and which solver `auto` stands for.

#include <cstdint>

namespace vitrail {

enum class Solver {
  automatic,   // "auto" in the scene
  photon_map,  // discs of the gather radius
  light_bins,  // each photon in the pixel that sees it
  beams,       // exact flux and area between neighbouring rays
};

/// As in the scene and in the run record.
const char* name_of(Solver solver);

/// From so many photons per pixel on `auto` counts photons in pixels. On the ball lens the map with its usual radius
/// (which shrinks as the cube root of the photons) has .24, .45 and .76 of the bins' error at .6, 6 and 61 photons per
/// pixel: the ratio grows as their fourth root and passes 1 near 190.
inline constexpr double kPhotonsForBins = 200;

/// The solver that a rendering takes: never `automatic`.
Solver resolve(Solver asked, std::uint64_t photons, double pixels);

}  // namespace vitrail
