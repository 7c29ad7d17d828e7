#pragma once
/// Radiance from everywhere as an image: looked up by direction, and drawn from in proportion to what it sends.

#include <vector>

#include "base/vec3.h"

namespace vitrail {

/// A lat-long image with the axes of OpenEXR's environment maps: row 0 is up (+y), the middle is +z, a quarter to the
/// left of it +x, the left and right edges -z. Each pixel has one radiance, W / (sr m2).
class SkyImage {
 public:
  /// `radiance` in rows from the top, width x height of them, none negative.
  SkyImage(int width, int height, std::vector<Rgb> radiance);

  Rgb towards(Vec3 direction) const;

  /// A direction with the density per solid angle that it was drawn with, and the radiance there.
  struct Draw {
    Vec3 direction;
    Rgb radiance;
    double density = 0;  // 1/sr; 0 if the sky is black
  };
  Draw draw(double u, double v) const;

  /// Radiance integrated over all directions.
  Rgb total() const { return total_; }

 private:
  double top_cosine(int row) const;  // of the angle from +y at the upper edge of a row

  int width_, height_;
  std::vector<Rgb> radiance_;
  std::vector<double> row_power_;    // cumulative, height + 1 of them
  std::vector<double> pixel_power_;  // cumulative within each row, width + 1 for each
  Rgb total_;
};

}  // namespace vitrail
