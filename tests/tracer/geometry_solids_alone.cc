/// Which solids share no place with another, so that a ray inside one need not ask the others.

#include <gtest/gtest.h>

#include "build_scene.h"
#include "geometry/solids_alone.h"

namespace vitrail {
namespace {

std::vector<bool> alone(const std::vector<Shape>& shapes, const std::vector<std::uint32_t>& left_out = {}) {
  std::vector<Primitive> primitives;
  for (const Shape& shape : shapes) primitives.push_back(make_primitive(shape));
  return solids_alone(primitives, left_out);
}

using Alone = std::vector<bool>;

TEST(SolidsAlone, AreThoseWhoseBoxesMeetNoOther) {
  const SphereShape ball{{0, 0, 0}, 1}, beside{{3, 0, 0}, 1}, through{{3.5, 0.5, 0}, 1};
  EXPECT_EQ(alone({ball, beside}), (Alone{true, true}));
  EXPECT_EQ(alone({ball, beside, through}), (Alone{true, false, false}));
  EXPECT_EQ(alone({through, ball, beside}), (Alone{false, true, false}));
}

/// Rounding may bring touching faces in either order.
TEST(SolidsAlone, DoNotTouch) {
  const BoxShape box{{0, 0, 0}, {1, 1, 1}, {}};
  EXPECT_EQ(alone({box, BoxShape{{1, 0, 0}, {2, 1, 1}, {}}}), (Alone{false, false}));
  EXPECT_EQ(alone({box, BoxShape{{1 + 1e-9, 0, 0}, {2, 1, 1}, {}}}), (Alone{false, false}));
  EXPECT_EQ(alone({box, BoxShape{{1.001, 0, 0}, {2, 1, 1}, {}}}), (Alone{true, true}));
}

/// The wall of a bubble holds a ball of air: a ray in the air is alone with it, a ray in the wall is not.
TEST(SolidsAlone, MayStandInAnother) {
  const SphereShape outer{{0, 0, 0}, 2}, inner{{0, 0, 0}, 1}, near{{0, 0, 0}, 1.9};
  EXPECT_EQ(alone({outer, inner}), (Alone{false, true}));
  EXPECT_EQ(alone({outer, near}), (Alone{false, false}));  // its box reaches out of the ball
  EXPECT_EQ(alone({BoxShape{{-2, -2, -2}, {2, 2, 2}, turned()}, inner}), (Alone{false, true}));
}

TEST(SolidsAlone, AreNoSheets) {
  const RectangleShape sheet{{5, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(alone({sheet, SphereShape{{0, 0, 0}, 1}}), (Alone{false, true}));
  EXPECT_EQ(alone({sheet, SphereShape{{5, 0, 0}, 1}}), (Alone{false, false}));
}

TEST(SolidsAlone, IgnoreWhatEveryRayAsks) {
  const PlaneShape floor{{0, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(alone({floor, SphereShape{{0, 0, 0}, 1}}, {0}), (Alone{false, true}));
}

}  // namespace
}  // namespace vitrail
