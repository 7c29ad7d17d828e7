#include "optics/microsurface.h"

#include <algorithm>
#include <cmath>

#include "optics/fresnel.h"
#include "optics/roughness.h"

namespace vitrail {
namespace {

constexpr std::uint64_t kMostFacets = 256;

// Smith's Lambda of GGX [W07 eq. 34] with heights spread evenly [H16]: a ray above a share c of the facets escapes
// upwards with probability c^Lambda. At most -1 for a ray that goes down and never escapes.
double lambda(double cosine, double alpha) {
  const double squared = cosine * cosine, slope = alpha * alpha * std::max(0.0, 1 - squared) / squared;
  const double root = std::sqrt(1 + slope);
  return cosine > 0 ? slope / (2 * (1 + root)) : -(1 + root) / 2;
}

}  // namespace

void FacetRay::cross(Vec3 refracted) {
  direction = -refracted;
  index = {index.to, index.from, index.to_minus_one, index.from_minus_one};
  below = 1 - below;
  behind = !behind;
}

bool reach_facet(FacetRay& ray, double alpha, double u) {
  if (ray.direction.z == 0) return true;
  const double per_facet = lambda(ray.direction.z, alpha);
  if (per_facet >= 0 && u >= 1 - std::pow(ray.below, per_facet)) return false;
  ray.below = std::min(1.0, ray.below * std::pow(1 - u, -1 / per_facet));
  return true;
}

double leave_facets(FacetRay& ray, const Facets& facets, Vec3 arrived, Stream stream) {
  double left = 1;
  for (std::uint64_t count = 0; count < kMostFacets; ++count) {
    const auto u = [&](std::uint32_t dimension) { return uniform(stream, count, dimension); };
    if (!reach_facet(ray, facets.alpha, u(0))) return left;
    const Vec3 facet = ggx_normal(-ray.direction, {0, 0, 1}, facets.alpha, u(1), u(2));
    if (facets.law == FacetLaw::mirror) {
      ray.reflect_at(facet);
      continue;
    }
    const Refraction refraction = facets.bend(ray.direction, facet, ray.index);
    const double R = facets.law == FacetLaw::let_through ? 0 : fresnel(ray.index, refraction).R;
    if (facets.law == FacetLaw::mirror_by_fresnel) {
      left *= R;
      ray.reflect_at(facet);
    } else if (refraction.total || u(3) < R) {
      ray.reflect_at(facet);
    } else {
      ray.cross(refraction.direction);
    }
  }
  ray.behind = false;
  ray.direction = {arrived.x, arrived.y, -arrived.z};
  return left;
}

}  // namespace vitrail
