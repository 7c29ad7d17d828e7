#pragma once
/// A rough surface: the smooth interaction with its two ways on scattered by one random choice.

#include <array>

#include "material/surface.h"

namespace vitrail {

/// Numbers in (0, 1) for one scattering.
using RoughSample = std::array<double, 3>;

/// What a path transports: importance, backwards from the camera, or flux, forwards from a light. (pbrt names these
/// modes after what they measure: its TransportMode::Radiance is the importance here.)
enum class Transported { importance, flux };

bool is_rough(const Roughness& roughness);

/// Scatter the branches of `event`, which `interact` has filled in for this hit. Equation 8 deflects both directions,
/// those of light so that Lambert's law stays as it is (unless the paper is read by the letter); GGX follows the light
/// from facet to facet, each with its own Fresnel share and total reflection, until it leaves the face: the branches
/// keep their weights, but either may end on either side. By the letter (tir drop) only the first facet drops light.
/// Surface, albedo and emission stay as they are. A smooth surface is left alone, to the bit.
void roughen(const Scene& scene, const Incidence& incidence, const RoughSample& sample, Transported transported,
             Interaction& event);

}  // namespace vitrail
