#pragma once
/// How caustics are solved, and which solver `auto` stands for.

namespace vitrail {

enum class Solver {
  automatic,   // "auto" in the scene
  photon_map,  // discs of the gather radius
  light_bins,  // each photon in the pixel that sees it
  beams,       // exact flux and area between neighbouring rays
};

/// As in the scene and in the run record.
const char* name_of(Solver solver);

/// From so many photons per pixel on `auto` counts photons in pixels, where no light goes as beams. At 5 photons per
/// pixel the pixels have the smaller error at three scenes of four with sharp light, and the discs on one.
inline constexpr double kPhotonsForBins = 4;

/// What `auto` is settled by.
struct SolverFacts {
  bool rays_alone;  // some light sends one ray alone from each place of it, and all faces are smooth
  double photons_per_pixel;
};

/// The solver that a rendering takes: never `automatic`. `beams` where some light can go as beams; what cannot is
/// counted in pixels then.
Solver resolve(Solver asked, const SolverFacts& facts);

}  // namespace vitrail
