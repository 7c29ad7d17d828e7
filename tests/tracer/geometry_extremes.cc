/// Distances, sizes and thicknesses at which fixed thresholds and textbook roots fail [O part 2].

#include <gtest/gtest.h>

#include "build_scene.h"
#include "geometry/primitive.h"

namespace vitrail {
namespace {

TEST(Sphere, IsHitOnItsSurfaceFromAHundredMillionRadiiAway) {
  const Sphere sphere({{0, 0, 0}, 1});
  TestNumbers numbers;
  for (double distance : {1e3, 1e6, 1e8}) {
    for (int i = 0; i < 200; ++i) {
      const Vec3 away = numbers.direction();
      const Vec3 origin = away * distance, target = numbers.in_cube(0.5);
      ShapeHit hit;
      const Ray ray{origin, normalise(target - origin)};
      ASSERT_TRUE(sphere.intersect(ray, nullptr, hit));
      EXPECT_NEAR(length(sphere.surface(ray.at(hit.t), 0).point), 1, 4e-16) << distance;
      // The first crossing is on the near side, 1e-8 at most from the right place after 1e8 metres of rounding.
      EXPECT_GT(dot(sphere.surface(ray.at(hit.t), 0).point, away), 0);
    }
  }
}

TEST(Sphere, OfAPlanetIsFlatWithoutLoss) {
  // Radius 1e9 below the origin: at x the ground lies at -x^2 / 2r; near the top that is known to 1e-15 and not to
  // 1e-7.
  const double r = 1e9;
  const Sphere ground({{0, -r, 0}, r});
  for (double x : {0.0, 0.3, 7.0, 100.0})
    for (double height : {1e-6, 0.1, 3.0}) {
      const Ray ray{{x, height, 0}, {0, -1, 0}};
      ShapeHit hit;
      ASSERT_TRUE(ground.intersect(ray, nullptr, hit));
      EXPECT_NEAR(hit.t, height + x * x / (2 * r), 1e-15 * (1 + height + x)) << x << " " << height;
      const SurfacePoint at = ground.surface(ray.at(hit.t), 0);
      EXPECT_NEAR(at.point.y, -x * x / (2 * r), 2e-15 * (1 + x));

      // Going up again it is never met; a slanted ray downwards was met once and leaves at the far root only.
      const Departure outside{0, 0, false};
      EXPECT_FALSE(ground.intersect({at.point, normalise({1, 1e-9, 0})}, &outside, hit));
    }
}

TEST(Sphere, IsLeftAtTheFarRoot) {
  const Sphere ball({{0.3, -0.2, 0.1}, 1e-9});
  const Vec3 d = normalise({1, 2, 3});
  ShapeHit in, out;
  ASSERT_TRUE(ball.intersect({Vec3{0.3, -0.2, 0.1} - d, d}, nullptr, in));
  const Vec3 start = ball.surface(Vec3{0.3, -0.2, 0.1} - d + d * in.t, 0).point;
  const Departure left{0, 0, true};
  ASSERT_TRUE(ball.intersect({start, d}, &left, out));
  EXPECT_FALSE(out.entering);
  EXPECT_GT(out.t, 0);
  EXPECT_LE(out.t, 2e-9 * (1 + 1e-6));  // the ball is known to 1e-16 / 1e-9 of its radius at this place
}

TEST(Box, OfANanometreIsEnteredAndLeft) {
  const Box slab({{-1, 0, -1}, {1, 1e-9, 1}, {}});
  for (double angle : {0.0, 45.0, 89.0, 89.99}) {
    const Vec3 d{std::sin(radians(angle)), -std::cos(radians(angle)), 0};
    ShapeHit in, out;
    ASSERT_TRUE(slab.intersect({Vec3{0, 1e-9, 0} - d * 0.5, d}, nullptr, in)) << angle;
    ASSERT_TRUE(in.entering);
    const Vec3 start = slab.surface(Vec3{0, 1e-9, 0} - d * 0.5 + d * in.t, in.face).point;
    const Departure left{0, in.face, true};
    ASSERT_TRUE(slab.intersect({start, d}, &left, out));
    EXPECT_NEAR(out.t, 1e-9 / std::cos(radians(angle)), 1e-22 / std::cos(radians(angle)) + 1e-9 * 1e-12) << angle;
    EXPECT_EQ(out.face, 2u);
  }
}

TEST(Box, IsCrossedAlongAFaceThatIsNotLeft) {
  // Standing on the lower face and known to be inside, with a direction that rounding has turned a hair outwards.
  const Box box({{-1, 0, -1}, {1, 1, 1}, {}});
  const Departure inside{0, 2, true};
  ShapeHit hit;
  ASSERT_TRUE(box.intersect({{0.5, 0, 0}, {1, -1e-17, 0}}, &inside, hit));
  EXPECT_EQ(hit.face, 1u);
  EXPECT_EQ(hit.t, 0.5);

  // Standing on an edge, a hair beside it: the way out is the other face, here and now.
  ASSERT_TRUE(box.intersect({{1 + 1e-15, 0, 0}, normalise({1, 1, 0})}, &inside, hit));
  EXPECT_EQ(hit.face, 1u);
  EXPECT_EQ(hit.t, 0);
}

TEST(Lens, FocusesWhereItsRadiiSay) {
  // Vertex of a biconvex lens on the axis at +-thickness / 2, of a biconcave one too; the rim at radius diameter / 2.
  for (double radius : {1.5, -1.5, 0.0}) {
    const Lens lens({radius, radius, 0.4, 1.0, {}});
    ShapeHit hit;
    ASSERT_TRUE(lens.intersect({{0, 0, -3}, {0, 0, 1}}, nullptr, hit));
    EXPECT_NEAR(hit.t, 2.8, 1e-15);
    EXPECT_EQ(hit.face, 0u);
    ASSERT_TRUE(lens.intersect({{0, 0, 0}, {0, 0, 1}}, nullptr, hit));
    EXPECT_NEAR(hit.t, 0.2, 1e-15);
    EXPECT_EQ(hit.face, 1u);
    ASSERT_TRUE(lens.intersect({{3, 0, 0}, {-1, 0, 0}}, nullptr, hit));
    EXPECT_NEAR(hit.t, 2.5, 1e-15);
    EXPECT_EQ(hit.face, 2u);
  }
}

TEST(Lens, IsHitTwiceInItsBowl) {
  // A grazing ray in the bowl of a concave face: across the rim edge into the hollow, then into the glass opposite.
  const Lens lens({-0.6, -0.6, 0.1, 1.0, {}});
  const double edge = 0.05 + 0.6 - std::sqrt(0.36 - 0.25);
  ShapeHit hit;
  const Ray across{{0, 0, -(edge - 0.05)}, normalise({1, 0, 0})};
  ASSERT_TRUE(lens.intersect(across, nullptr, hit));
  EXPECT_TRUE(hit.entering);
  EXPECT_EQ(hit.face, 0u);

  // From a point of the bowl to another one of the same face.
  const SurfacePoint at = lens.surface(across.at(hit.t), 0);
  const Departure outside{0, 0, false};
  ShapeHit again;
  ASSERT_TRUE(lens.intersect({at.point, {-1, 0, 0}}, &outside, again));
  EXPECT_NEAR(again.t, 2 * at.point.x, 1e-15);
  EXPECT_EQ(again.face, 0u);
}

TEST(Prism, IsNotLeftThroughACorner) {
  // Rays exactly at corners and along sides still come out as often as they go in.
  const Prism prism({{{-1, 0}, {1, 0}, {0, 1}}, 2, {}});
  for (const Vec3 d : {Vec3{1, 0, 0}, Vec3{0, -1, 0}, normalise({1, 1, 0}), normalise({-1, -1, 0})}) {
    for (const Vec3 target : {Vec3{-1, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}) {
      Ray ray{target - d * 3, d};
      Departure left;
      const Departure* departure = nullptr;
      bool inside = false;
      ShapeHit hit;
      for (int step = 0; step < 8 && prism.intersect(ray, departure, hit); ++step) {
        ASSERT_EQ(hit.entering, !inside);
        inside = !inside;
        left = {0, hit.face, inside};
        departure = &left;
        ray.origin = prism.surface(ray.at(hit.t), hit.face).point;
      }
      EXPECT_FALSE(inside);
    }
  }
}

TEST(Flat, HasTheSurfaceCoordinatesOfTheSceneLanguage) {
  const Plane floor({{1, 0, 2}, {0, 1, 0}});
  const SurfacePoint at = floor.surface({1.5, 1e-9, 4}, 0);
  EXPECT_EQ(at.point.y, 0);
  EXPECT_NEAR(at.s, 0.5, 1e-15);
  EXPECT_NEAR(at.q, -2, 1e-15);
  const Rectangle sheet({{0, 1, 0}, {2, 0, 0}, {0, 0, -3}});
  EXPECT_NEAR(sheet.surface({0.5, 1, -1}, 0).q, 1, 1e-15);
  EXPECT_EQ(sheet.surface({0.5, 1, -1}, 0).normal, (Vec3{0, 1, 0}));
}

}  // namespace
}  // namespace vitrail
