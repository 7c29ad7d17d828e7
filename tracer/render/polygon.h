#pragma once
/// Convex polygons of a few corners in the image, cut along the edges of pixels [Sutherland and Hodgman 1974].

#include <array>

namespace vitrail {

struct Polygon {
  struct Corner {
    double x = 0, y = 0;
  };
  std::array<Corner, 8> corners;  // a triangle cut by four lines has at most seven
  int size = 0;

  void add(Corner corner) {
    if (size < 8) corners[size++] = corner;
  }
};

struct AreaAndMiddle {
  double area = 0;  // square pixels, never negative
  Polygon::Corner middle;
};

/// The part with x (y) between two values.
Polygon between_columns(const Polygon& polygon, double low, double high);
Polygon between_rows(const Polygon& polygon, double low, double high);

/// Area and centroid; the mean of the corners where there is no area.
AreaAndMiddle area_of(const Polygon& polygon);

}  // namespace vitrail
