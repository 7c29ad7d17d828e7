#pragma once
/// A rough face as a landscape of small mirrors and panes, and a ray followed from one facet to the next until it
/// leaves the face: multiple scattering over GGX normals [H16]. No light is lost between the facets, and n_o^2 cos(o)
/// p(o to i) = n_i^2 cos(i) p(i to o): photons and camera rays see the same face.

#include "base/random.h"
#include "optics/refract.h"

namespace vitrail {

/// What facets do with light.
enum class FacetLaw {
  mirror,             // reflect all
  mirror_by_fresnel,  // reflect Fresnel's share and keep the rest
  let_through,        // refract all, or reflect it totally
  divide_by_fresnel,  // either, by chance
};

struct Facets {
  double alpha = 0;
  FacetLaw law = FacetLaw::mirror;
  Refraction (*bend)(Vec3, Vec3, const IndexPair&) = refract;
};

/// A ray over the facets, in the frame of the face: z is the normal on the side where the ray is. Behind the face all
/// three axes are turned round, so that both sides obey the same rules.
struct FacetRay {
  Vec3 direction;
  IndexPair index;   // from the ray's side to the other
  double below = 1;  // share of the facets that lie below the ray: 1 above all, 0 under all
  bool behind = false;

  void reflect_at(Vec3 facet) { direction = reflect(direction, facet); }
  void cross(Vec3 refracted);
};

/// Go on to the next facet, or away from the face (false). u: uniform in (0, 1).
bool reach_facet(FacetRay& ray, double alpha, double u);

/// Follow a ray that has just left a facet until it leaves the face. Returns the share of its light that is left;
/// random numbers come from the stream. A ray still caught after some hundred facets leaves as the smooth face would
/// mirror `arrived`.
double leave_facets(FacetRay& ray, const Facets& facets, Vec3 arrived, Stream stream);

}  // namespace vitrail
