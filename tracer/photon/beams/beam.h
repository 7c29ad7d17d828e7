#pragma once
/// A beam: what leaves the light between three neighbouring rays with the same path signature, where it lands.
///
/// The flux between the rays is known exactly, and so is the area that they enclose on the surface: their quotient is
/// the irradiance, without any kernel and without noise [Heckbert and Hanrahan 1984; Watt 1990].

#include <cstdint>
#include <vector>

#include "base/vec3.h"
#include "photon/ledger.h"
#include "photon/photon_map.h"

namespace vitrail {

/// Where one ray lands. 56 bytes.
struct BeamCorner {
  Vec3 position;    // metres
  float normal[3];  // unit, on the side where the light arrived
  float power[3];   // W: what the whole chart would bring if all its rays were like this one
};

/// Three corners and their share of the chart. 16 bytes.
struct Beam {
  std::uint32_t corner[3];  // in the corners of its block or map
  float share;              // of the chart between the three rays
};

/// What beams do not hold of the light that lands.
struct BeamRemainder {
  Rgb as_photons;  // W, landed between rays whose signatures differ, or too wide apart: kept as photons, with their
                   // noise
  Rgb unseen;      // W, on paths that no corner of their cell takes, or that all corners take but not what is between
                   // them: an estimate of the error, from rays through some cells

  BeamRemainder& operator+=(const BeamRemainder& other) {
    as_photons += other.as_photons;
    unseen += other.unseen;
    return *this;
  }
};

/// What one block of a lattice leaves behind.
struct BeamBlock {
  std::vector<BeamCorner> corners;
  std::vector<Beam> beams;
  std::vector<PhotonRecord> photons;  // of the light that no beam holds
  Ledger ledger;
  BeamRemainder remainder;
  std::uint64_t rays = 0, landed_rays = 0;  // all, and those of the lattice that have a corner
};

}  // namespace vitrail
