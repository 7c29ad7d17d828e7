#pragma once
/// How rough faces scatter: the paper's equation 8, and microfacets.

#include <array>

#include "base/vec3.h"

namespace vitrail {

/// Deflect a unit direction by equation 8 in its corrected form: (1 - gamma) d + gamma rho, with gamma = u lambda / 2
/// and rho the part across d of a vector uniform on the unit sphere [S eq. 8, O 1.3]. The position that the printed
/// form adds and subtracts is left out. A result on the other side of the surface is mirrored back at it, so no light
/// is lost: `facing` is the normal on the side where the light is to stay. u: uniform in (0, 1). lambda 0 returns d
/// itself.
Vec3 deflect(Vec3 direction, double lambda, Vec3 facing, const std::array<double, 3>& u);

/// Deflect light by equation 8 so that Lambert's law stays as it is. `deflect` takes a look as far from the normal as
/// towards it; light that did so would end up grazing more often than it began, and glass that catches it would show
/// more than the furnace around it [O 1.3]. So light follows its deflection with probability min(1, cos after / cos
/// before) and else goes straight on: the acceptance of Metropolis and Hastings [MH], which makes the law reciprocal
/// because the deflection itself is the same to and fro. keep: uniform in (0, 1).
Vec3 deflect_light(Vec3 direction, double lambda, Vec3 facing, const std::array<double, 3>& u, double keep);

/// A microfacet normal as seen from `toward_viewer`, GGX with roughness alpha [W07 eq. 33], sampled among the visible
/// ones [Heitz 2018]. The viewer may be anywhere above or, among the facets, below the mean plane across `normal`.
Vec3 ggx_normal(Vec3 toward_viewer, Vec3 normal, double alpha, double u, double v);

}  // namespace vitrail
