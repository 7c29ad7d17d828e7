/// Polygons cut along the edges of pixels.

#include <gtest/gtest.h>

#include "build_scene.h"
#include "render/polygon.h"

namespace vitrail {
namespace {

/// Whatever a triangle is, its pieces in all pixels have its area and its centroid between them.
TEST(Polygon, IsTheSumOfItsPiecesInAllPixels) {
  TestNumbers numbers;
  for (int k = 0; k < 200; ++k) {
    Polygon triangle;
    for (int c = 0; c < 3; ++c) triangle.add({numbers.between(0, 9), numbers.between(0, 9)});
    const AreaAndMiddle whole = area_of(triangle);
    double area = 0, x = 0, y = 0;
    for (int row = 0; row < 9; ++row) {
      for (int column = 0; column < 9; ++column) {
        const Polygon piece = between_columns(between_rows(triangle, row, row + 1), column, column + 1);
        const AreaAndMiddle part = area_of(piece);
        EXPECT_LE(part.area, 1 + 1e-12);
        if (part.area > 0) {
          EXPECT_GE(part.middle.x, column);
          EXPECT_LE(part.middle.x, column + 1);
        }
        area += part.area;
        x += part.area * part.middle.x;
        y += part.area * part.middle.y;
      }
    }
    EXPECT_NEAR(area, whole.area, 1e-12);
    EXPECT_NEAR(x, whole.area * whole.middle.x, 1e-11);
    EXPECT_NEAR(y, whole.area * whole.middle.y, 1e-11);
  }
}

TEST(Polygon, WithoutAreaHasTheMiddleOfItsCorners) {
  Polygon line;
  for (const double x : {1.0, 2.0, 6.0}) line.add({x, 4});
  const AreaAndMiddle found = area_of(line);
  EXPECT_EQ(found.area, 0);
  EXPECT_DOUBLE_EQ(found.middle.x, 3);
  EXPECT_DOUBLE_EQ(found.middle.y, 4);
}

}  // namespace
}  // namespace vitrail
