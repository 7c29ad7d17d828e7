/// Every shape alone: hits against closed forms, and the rules that hold for any ray.

#include <gtest/gtest.h>

#include "build_scene.h"
#include "geometry/accel.h"
#include "geometry/primitive.h"

namespace vitrail {
namespace {

/// All solids, small ones about the origin, placed with and without rotation.
std::vector<std::pair<std::string, Shape>> solids() {
  const std::vector<std::array<double, 2>> triangle = {{-1, -0.5}, {1, -0.5}, {0, 1}};
  const std::vector<std::array<double, 2>> arrow = {{0, -1}, {1, 1}, {0, 0.25}, {-1, 1}};
  const std::vector<std::array<double, 2>> cup = {{0, -0.75},  {0.5, -0.75}, {0.125, -0.5}, {0.75, 0.5},
                                                  {0.5, 0.75}, {0.5, 0.5},   {0, -0.25}};
  std::vector<std::pair<std::string, Shape>> list;
  for (const Frame& frame : {Frame{}, turned({0.1, -0.2, 0.05})}) {
    const std::string how = frame.identity ? "" : " turned";
    list.push_back({"box" + how, BoxShape{{-1, -0.5, -0.25}, {0.75, 1, 0.5}, frame}});
    list.push_back({"prism" + how, PrismShape{triangle, 1.5, frame}});
    list.push_back({"arrow" + how, PrismShape{arrow, 1, frame}});
    list.push_back({"biconvex" + how, LensShape{1.5, 1.25, 0.5, 1.25, frame}});
    list.push_back({"biconcave" + how, LensShape{-1.5, -1.25, 0.2, 1.25, frame}});
    list.push_back({"meniscus" + how, LensShape{1.0, -1.5, 0.3, 1.5, frame}});
    list.push_back({"planoconvex" + how, LensShape{0, 1.25, 0.5, 1.25, frame}});
    list.push_back({"rod" + how, LensShape{0.5, 0.5, 2, 1, frame}});
    list.push_back({"lathe" + how, LatheShape{cup, frame}});
  }
  list.push_back({"sphere", SphereShape{{0.25, 0.5, -0.125}, 0.75}});
  list.push_back({"cylinder", CylinderShape{{-0.5, -0.75, 0.25}, {0.5, 0.5, 0.5}, 0.5}});
  list.push_back({"cone", ConeShape{{-0.5, -0.75, 0.25}, {0.5, 0.5, 0.5}, 0.25, 0.75}});
  list.push_back({"torus", TorusShape{{0.125, 0, -0.25}, normalise({1, 2, 3}), 0.625, 0.25}});
  list.push_back({"thick torus", TorusShape{{0, 0, 0}, {0, 1, 0}, 0.5, 0.4921875}});
  list.push_back({"pointed cone", ConeShape{{0, -0.75, 0}, {0, 0.75, 0}, 0.5, 0}});
  return list;
}

class EverySolid : public testing::TestWithParam<int> {
 protected:
  std::string name = solids()[static_cast<std::size_t>(GetParam())].first;
  Primitive solid = make_primitive(solids()[static_cast<std::size_t>(GetParam())].second);
};

TEST_P(EverySolid, IsEnteredAndLeftInTurn) {
  // Walk straight through: sides alternate, the points between agree with the point-in-solid test, and the ray ends
  // outside.
  TestNumbers numbers;
  int met = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 target = numbers.in_cube(1);
    Ray ray{target - numbers.direction() * 4, {}};
    ray.direction = normalise(target - ray.origin);
    Departure left;
    const Departure* departure = nullptr;
    bool inside = false;
    for (int step = 0; step < 12; ++step) {
      ShapeHit hit;
      if (!intersect(solid, ray, departure, hit)) break;
      ++met;
      ASSERT_EQ(hit.entering, !inside) << name << " ray " << i << " step " << step;
      ASSERT_GT(hit.t, 0) << name;  // none of these rays meets an edge
      if (hit.t > 1e-6) {           // well away from both ends the test by points has no rounding to fear
        ASSERT_EQ(contains(solid, ray.at(hit.t / 2)), inside) << name << " ray " << i;
      }
      const SurfacePoint at = surface(solid, ray.at(hit.t), hit.face);
      // A few 1e-16 of the way of 8, divided by the sine of grazing incidence: 1e-3 among this many rays.
      ASSERT_LT(length(at.point - ray.at(hit.t)), 1e-12) << name;
      ASSERT_NEAR(length(at.normal), 1, 1e-15);
      inside = !inside;
      left = {0, hit.face, inside};
      departure = &left;
      ray.origin = at.point;
    }
    ASSERT_FALSE(inside) << name << " ray " << i;
  }
  EXPECT_GT(met, 1000) << name;
}

TEST_P(EverySolid, IsHitOnItsSurfaceFromAfar) {
  // Ten million sizes away a hit is known to 1e-9 along the ray, and across it no worse.
  TestNumbers numbers;
  int met = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 target = numbers.in_cube(1), origin = numbers.direction() * 1e7;
    const Ray ray{origin, normalise(target - origin)};
    ShapeHit hit;
    if (!intersect(solid, ray, nullptr, hit)) continue;
    ++met;
    const Bounds box = bounds(solid);
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_GT(ray.at(hit.t)[axis], box.min[axis] - 1e-7) << name;
      ASSERT_LT(ray.at(hit.t)[axis], box.max[axis] + 1e-7) << name;
    }
    // Rays that graze slide along the surface: ask for the gap and not for the way.
    const SurfacePoint at = surface(solid, ray.at(hit.t), hit.face);
    ASSERT_LT(length(at.point - ray.at(hit.t)) * std::abs(dot(at.normal, ray.direction)), 1e-7) << name;
  }
  EXPECT_GT(met, 100) << name;
}

TEST_P(EverySolid, HasOutwardNormals) {
  TestNumbers numbers;
  for (int i = 0; i < 2000; ++i) {
    const Ray ray{numbers.in_cube(1) - numbers.direction() * 4, numbers.direction()};
    ShapeHit hit;
    if (!intersect(solid, ray, nullptr, hit)) continue;
    const SurfacePoint at = surface(solid, ray.at(hit.t), hit.face);
    // A step off an edge may leave through the next face, so that only rays away from grazing can be asked.
    if (std::abs(dot(at.normal, ray.direction)) < 0.2) continue;
    EXPECT_EQ(dot(at.normal, ray.direction) < 0, hit.entering) << name;
    EXPECT_FALSE(contains(solid, at.point + at.normal * 1e-9)) << name;
  }
}

TEST_P(EverySolid, LiesInItsBox) {
  const Bounds box = bounds(solid);
  TestNumbers numbers;
  for (int i = 0; i < 50000; ++i) {
    const Vec3 p = numbers.in_cube(2);
    if (!contains(solid, p)) continue;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(box.min[axis], p[axis]) << name;
      EXPECT_GE(box.max[axis], p[axis]) << name;
    }
  }
}

TEST_P(EverySolid, IsLeftByRaysThatStartInside) {
  TestNumbers numbers;
  int started = 0;
  for (int i = 0; i < 20000; ++i) {
    const Ray ray{numbers.in_cube(1), numbers.direction()};
    if (!contains(solid, ray.origin)) continue;
    ++started;
    ShapeHit hit;
    ASSERT_TRUE(intersect(solid, ray, nullptr, hit)) << name;
    EXPECT_FALSE(hit.entering) << name;
  }
  EXPECT_GT(started, 100) << name;
}

TEST_P(EverySolid, IsLeftWhereverARayStandsOnIt) {
  // A ray known to go on inside finds a way out in any direction, along the face and a hair outwards too; and then the
  // ray outside does not come in where it stands.
  TestNumbers numbers;
  for (int i = 0; i < 20000; ++i) {
    const Ray ray{numbers.in_cube(1) - numbers.direction() * 4, numbers.direction()};
    ShapeHit hit;
    if (!intersect(solid, ray, nullptr, hit)) continue;
    const SurfacePoint at = surface(solid, ray.at(hit.t), hit.face);
    const Vec3 along = normalise(cross(at.normal, numbers.direction()));
    for (const double lift : {-1e-3, -1e-12, 0.0, 1e-17, 1e-12}) {
      const Departure inside{0, hit.face, true};
      ShapeHit out, again;
      ASSERT_TRUE(intersect(solid, {at.point, normalise(along + at.normal * lift)}, &inside, out)) << name << lift;
      EXPECT_FALSE(out.entering) << name;
      EXPECT_GE(out.t, 0) << name;
      const Departure outside{0, out.face, false};
      const Vec3 there = surface(solid, at.point + along * out.t, out.face).point;
      EXPECT_TRUE(!intersect(solid, {there, along}, &outside, again) || again.t > 0) << name;
    }
  }
}

TEST_P(EverySolid, ScalesByPowersOfTwoToTheBit) {
  const Shape given = solids()[static_cast<std::size_t>(GetParam())].second;
  const double k = 0x1p-30;
  Shape scaled = given;
  std::visit(
      [&](auto& s) {
        using S = std::decay_t<decltype(s)>;
        if constexpr (std::is_same_v<S, SphereShape>) s.center = s.center * k, s.radius *= k;
        if constexpr (std::is_same_v<S, BoxShape>) s.min = s.min * k, s.max = s.max * k;
        if constexpr (std::is_same_v<S, CylinderShape>) s.from = s.from * k, s.to = s.to * k, s.radius *= k;
        if constexpr (std::is_same_v<S, ConeShape>)
          s.from = s.from * k, s.to = s.to * k, s.radius_from *= k, s.radius_to *= k;
        if constexpr (std::is_same_v<S, TorusShape>) s.center = s.center * k, s.radius *= k, s.radius_tube *= k;
        if constexpr (std::is_same_v<S, LatheShape>)
          for (auto& corner : s.profile) corner = {corner[0] * k, corner[1] * k};
        if constexpr (std::is_same_v<S, PrismShape>) {
          for (auto& corner : s.corners) corner = {corner[0] * k, corner[1] * k};
          s.height *= k;
        }
        if constexpr (std::is_same_v<S, LensShape>)
          s.radius_front *= k, s.radius_back *= k, s.thickness *= k, s.diameter *= k;
        if constexpr (requires { s.frame; }) s.frame.origin = s.frame.origin * k;
      },
      scaled);
  const Primitive small = make_primitive(scaled);
  TestNumbers numbers;
  for (int i = 0; i < 2000; ++i) {
    const Ray ray{numbers.in_cube(3), numbers.direction()};
    ShapeHit a, b;
    const bool met = intersect(solid, ray, nullptr, a);
    ASSERT_EQ(met, intersect(small, {ray.origin * k, ray.direction}, nullptr, b)) << name;
    if (!met) continue;
    ASSERT_EQ(a.t * k, b.t) << name;
    ASSERT_EQ(a.face, b.face) << name;
    ASSERT_EQ(surface(solid, ray.at(a.t), a.face).point * k, surface(small, ray.at(a.t) * k, b.face).point) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Solids, EverySolid, testing::Range(0, 24));

}  // namespace
}  // namespace vitrail
