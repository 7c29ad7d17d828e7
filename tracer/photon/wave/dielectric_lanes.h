#pragma once
/// Mirror and refract many rays at once: the formulas of optics/refract and optics/fresnel as vector instructions. A
/// test compares the two, ray by ray.

#include <array>

namespace vitrail {

/// Rays at faces, side by side. The caller fills in the first part.
struct DielectricLanes {
  static constexpr std::size_t kCapacity = 256;
  using Column = std::array<double, kCapacity>;

  std::size_t count = 0;
  alignas(64) std::array<Column, 3> direction, normal;  // unit; the normal against the ray
  alignas(64) Column ior_from, ior_to, ior_step;        // step = to - from

  // What the functions below find.
  alignas(64) std::array<Column, 3> mirrored, refracted;
  alignas(64) Column radicand;  // below zero: total internal reflection, no refracted direction
  alignas(64) Column cos_in, cos_out;
  alignas(64) Column share_R, share_T;  // of a refraction that is not total
};

void reflect(DielectricLanes& lanes);
/// Refracted directions [S eq. 5 corrected, O 1.2].
void refract(DielectricLanes& lanes);
/// Scalar Fresnel shares, after `refract`.
void find_fresnel_shares(DielectricLanes& lanes);

}  // namespace vitrail
