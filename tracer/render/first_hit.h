#pragma once
/// The first surface that the camera sees through a place of the image, for light that is counted in pixels.

#include "material/surface.h"

namespace vitrail {

struct FirstHit {
  Arrival arrival;
  // Without meaning if the ray escaped:
  double cosine = 0;     // between the ray and the surface normal
  double ior_ratio = 1;  // of the camera's medium to the surface's
};

class FirstHitFinder {
 public:
  FirstHitFinder(const World& world, const Picture& picture);

  /// What is seen through (x, y) in pixels from the top left corner.
  FirstHit through(double x, double y) const;

 private:
  const World& world_;
  const Picture& picture_;
  MediumSet media_;  // around a camera that looks from one place
};

}  // namespace vitrail
