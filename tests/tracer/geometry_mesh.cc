/// Triangles: closed surfaces without leaks, the same hits by list and by tree.

#include <gtest/gtest.h>

#include <sstream>

#include "build_mesh.h"
#include "geometry/accel.h"
#include "geometry/mesh.h"

namespace vitrail {
namespace {

/// Go straight through; whatever is met on the way, the end is outside.
void expect_no_leak(const Intersector& intersector, Ray ray, int& hits) {
  Departures left;
  bool inside = false;
  for (int step = 0; step < 20; ++step) {
    Hit hit;
    if (!intersector.closest(ray, left, hit)) break;
    ++hits;
    inside = hit.crossings[0].entering;
    ray.origin = hit.point;
    left = hit.through();
  }
  ASSERT_FALSE(inside);
}

TEST(Mesh, DoesNotLeakAtEdgesAndCorners) {
  const std::string ball = ball_text(12);
  const MeshData data = data_of(ball);
  for (const Frame& frame : {Frame{}, turned({100, -20, 3})}) {
    const Scene scene = scene_of(mesh_of(ball, false, frame));
    const Intersector intersector(scene);
    TestNumbers numbers;
    int hits = 0;
    for (int i = 0; i < 40000; ++i) {
      // Aim exactly at a vertex, at the middle of an edge, or anywhere.
      const auto& corners = data.triangles[static_cast<std::size_t>(numbers.unit() * data.triangles.size())];
      const Vec3 a = data.vertices[corners[0]], b = data.vertices[corners[1]];
      const Vec3 target = frame.point_to_world(i % 3 == 0 ? a : i % 3 == 1 ? (a + b) * 0.5 : numbers.in_cube(1));
      const Vec3 origin = frame.point_to_world(numbers.direction() * 4);
      expect_no_leak(intersector, {origin, normalise(target - origin)}, hits);
    }
    EXPECT_GT(hits, 40000);
  }
}

TEST(Mesh, DoesNotLeakAlongItsFaces) {
  // Rays in the planes and along the edges of a cube, the worst that a triangle can be asked.
  const Scene scene = scene_of(mesh_of(kCube));
  const Intersector intersector(scene);
  int hits = 0;
  for (double x : {-1.0, 0.0, 1.0})
    for (double y : {-1.0, -0.5, 0.0, 1.0})
      for (const Vec3 d : {Vec3{0, 0, 1}, normalise({1, 0, 1}), normalise({1, 1, 1}), normalise({0, 1, 1})})
        expect_no_leak(intersector, {Vec3{x, y, 0} - d * 5, d}, hits);
  EXPECT_GT(hits, 20);
}

/// The cube, and a second one above it from y = 3 to 5.
std::string two_cubes() {
  std::string text = kCube;
  std::istringstream lines(kCube);
  char line[80];
  std::string kind;
  for (int a, b, c, d; lines >> kind;) {
    if (kind == "v") {
      lines >> a >> b >> c;
      std::snprintf(line, sizeof line, "v %d %d %d\n", a, b + 4, c);
    } else {
      lines >> a >> b >> c >> d;
      std::snprintf(line, sizeof line, "f %d %d %d %d\n", a + 8, b + 8, c + 8, d + 8);
    }
    text += line;
  }
  return text;
}

TEST(Mesh, IsLeftOnItsEdgeBeforeAnotherPartIsEntered) {
  // Inside by departure, on an edge, going outwards: there may be no triangle left to meet on the way out.
  const Scene scene = scene_of(mesh_of(two_cubes()));
  for (Search search : {Search::list, Search::embree}) {
    const Intersector intersector(scene, search);
    Hit side;
    ASSERT_TRUE(intersector.closest({{5, 0.5, 0.1}, {-1, 0, 0}}, {}, side));
    ASSERT_NEAR(side.t, 4, 1e-15);
    for (const double hair : {0.0, 1e-16, -1e-16, 5e-16})
      for (const double slant : {0.0, 1e-17, 1e-3, -1e-17}) {
        Departures inside;
        inside.push_back({0, side.crossings[0].face, true});
        Hit hit;
        ASSERT_TRUE(intersector.closest({{1, 1 + hair, 0.1}, normalise({slant, 1, 0})}, inside, hit));
        EXPECT_FALSE(hit.crossings[0].entering) << hair << " " << slant;
        EXPECT_LT(hit.t, 1e-14);

        // Outside again it does not come back in where it stands.
        Hit next;
        if (intersector.closest({hit.point, normalise({-1e-17, 1, 0})}, hit.through(), next)) {
          EXPECT_GT(next.t, 1);
        }
      }
  }
}

TEST(Mesh, IsNotEnteredWhereARayStandsOutside) {
  // On the upper side, a hair too low by rounding, going along it: the side face it seems to meet is not entered.
  const Mesh cube(mesh_of(kCube));
  const Departure outside{0, 8, false};
  ShapeHit hit;
  EXPECT_TRUE(!cube.intersect({{1, 1 - 1e-16, 0.1}, {-1, 0, 0}}, &outside, hit) || hit.t > 1);
}

TEST(Mesh, IsTheSameByListAndByTree) {
  const Scene scene = scene_of(mesh_of(ball_text(10), true, turned()));
  const Intersector list(scene, Search::list), tree(scene, Search::embree);
  TestNumbers numbers;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 origin = numbers.direction() * 3;
    Ray ray{origin, normalise(numbers.in_cube(1) - origin)};
    Departures left;
    for (int step = 0; step < 3; ++step) {
      Hit a, b;
      const bool met = list.closest(ray, left, a);
      ASSERT_EQ(met, tree.closest(ray, left, b));
      ASSERT_EQ(list.occluded(ray, left, 1.0), tree.occluded(ray, left, 1.0));
      if (!met) break;
      ASSERT_EQ(a.t, b.t);
      ASSERT_EQ(a.crossings[0].face, b.crossings[0].face);
      ASSERT_EQ(a.crossings[0].shading_normal, b.crossings[0].shading_normal);
      ray.origin = a.point;
      left = a.through();
    }
  }
}

TEST(Mesh, HasNormalsOfABallWhereSmooth) {
  const Mesh ball(mesh_of(ball_text(32), true));
  TestNumbers numbers;
  for (int i = 0; i < 500; ++i) {
    const Vec3 d = numbers.direction();
    ShapeHit hit;
    ASSERT_TRUE(ball.intersect({d * 3, -d}, nullptr, hit));
    const SurfacePoint at = ball.surface(d * (3 - hit.t), hit.face);
    // A facet spans 5.6 degrees: flat normals are off by up to 4, interpolated ones by a small part of that.
    EXPECT_LT(degrees(angle_between(at.normal, d)), 4.1);
    EXPECT_LT(degrees(angle_between(ball.shading_normal(at.point, hit.face), d)), 0.6);
  }
}

TEST(Mesh, KnowsWhatItContains) {
  const Mesh ball(mesh_of(ball_text(16)));
  TestNumbers numbers;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 p = numbers.in_cube(1.5);
    if (std::abs(length(p) - 1) < 0.03) continue;  // facets lie up to 1 - cos(8 degrees) inside the ball
    EXPECT_EQ(ball.contains(p), length(p) < 1);
  }
}

}  // namespace
}  // namespace vitrail
