#pragma once
/// Rough faces for many rays at once: optics/roughness and the first facet of optics/microsurface as vector
/// instructions. A test compares the two, ray by ray.

#include "photon/wave/dielectric_lanes.h"

namespace vitrail {

/// Random numbers in (0, 1) for rays at rough faces, side by side; `keep` for equation 8 alone.
struct RoughSamples {
  alignas(64) std::array<DielectricLanes::Column, 3> u;
  alignas(64) DielectricLanes::Column keep;
};

/// Deflect unit directions by equation 8, in place. `side` times the normal is on the side where the light is to stay.
/// If `reciprocal`, light keeps Lambert's law by the acceptance of `keep`.
void deflect(const RoughSamples& samples, std::size_t count, double strength, bool reciprocal,
             const std::array<DielectricLanes::Column, 3>& normal, double side,
             std::array<DielectricLanes::Column, 3>& direction);

/// Rays that meet their first facet, in the frames of their faces (z along the normal).
struct FacetLanes {
  DielectricLanes at;                                       // `direction` is the arriving ray, `normal` the facet's
  alignas(64) std::array<DielectricLanes::Column, 3> u, v;  // of the frames, in the world
  alignas(64) DielectricLanes::Column below;                // share of the facets below the ray
};

/// Bring rays from `lanes` into the frames of their faces, and choose the facets that they meet.
void find_facets(const DielectricLanes& lanes, const RoughSamples& samples, double alpha, FacetLanes& facets);

/// Whether rays that leave their first facet leave the face at once: 1, else 0. `z` is the height of a direction over
/// the side that it is on, `below` the share of that side's facets under it, `u` uniform in (0, 1).
void escape_facets(std::size_t count, double alpha, const DielectricLanes::Column& z,
                   const DielectricLanes::Column& below, const DielectricLanes::Column& u,
                   DielectricLanes::Column& escapes);

/// Turn directions from the frames of their faces into the world, in place, and keep each on its side of the face:
/// `behind` is 1 for those behind it, else 0.
void turn_to_world(const FacetLanes& facets, const std::array<DielectricLanes::Column, 3>& normal,
                   const DielectricLanes::Column& behind, std::array<DielectricLanes::Column, 3>& direction);

}  // namespace vitrail
