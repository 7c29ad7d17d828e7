/// Triangles: files read and refused, closed surfaces without leaks, the same hits by list and by tree.

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include "base/diagnostic.h"
#include "build_scene.h"
#include "geometry/accel.h"
#include "geometry/mesh.h"
#include "geometry/mesh_file.h"

namespace vitrail {
namespace {

std::string write_file(const std::string& name, const std::string& content) {
  const std::string path = testing::TempDir() + "vitrail_" + std::to_string(getpid()) + "_" + name;
  std::ofstream(path, std::ios::binary) << content;
  return path;
}

/// A cube of half edge 1 with two triangles a side.
const char* const kCube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// A ball of latitude and longitude, `steps` from pole to pole, as OBJ text.
std::string ball_text(int steps) {
  std::string text = "v 0 1 0\n";
  char line[200];
  for (int i = 1; i < steps; ++i)
    for (int j = 0; j < 2 * steps; ++j) {
      const double polar = kPi * i / steps, turn = kPi * j / steps;
      std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", std::sin(polar) * std::cos(turn), std::cos(polar),
                    -std::sin(polar) * std::sin(turn));
      text += line;
    }
  text += "v 0 -1 0\n";
  const auto at = [&](int i, int j) {
    if (i == 0) return 1;
    if (i == steps) return 2 + (steps - 1) * 2 * steps;
    return 2 + (i - 1) * 2 * steps + j % (2 * steps);
  };
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < 2 * steps; ++j) {
      const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (i > 0) text += "f " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(d) + "\n";
      if (i + 1 < steps) text += "f " + std::to_string(d) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
    }
  return text;
}

MeshShape mesh_of(const std::string& path, bool smooth = false, const Frame& frame = {}) {
  return {path, smooth, frame};
}

Scene scene_of(const MeshShape& shape) {
  SceneBuilder builder;
  builder.add("mesh", shape, builder.add(glass(1.5)));
  return builder.scene;
}

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
  const std::string ball = write_file("leak.obj", ball_text(12));
  const MeshData data = read_mesh_file(ball);
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
  const Scene scene = scene_of(mesh_of(write_file("cube.obj", kCube)));
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
  const Scene scene = scene_of(mesh_of(write_file("two.obj", two_cubes())));
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
  const Mesh cube(mesh_of(write_file("hair.obj", kCube)));
  const Departure outside{0, 8, false};
  ShapeHit hit;
  EXPECT_TRUE(!cube.intersect({{1, 1 - 1e-16, 0.1}, {-1, 0, 0}}, &outside, hit) || hit.t > 1);
}

TEST(Mesh, IsTheSameByListAndByTree) {
  const Scene scene = scene_of(mesh_of(write_file("same.obj", ball_text(10)), true, turned()));
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
  const Mesh ball(mesh_of(write_file("smooth.obj", ball_text(32)), true));
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
  const Mesh ball(mesh_of(write_file("contains.obj", ball_text(16))));
  TestNumbers numbers;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 p = numbers.in_cube(1.5);
    if (std::abs(length(p) - 1) < 0.03) continue;  // facets lie up to 1 - cos(8 degrees) inside the ball
    EXPECT_EQ(ball.contains(p), length(p) < 1);
  }
}

TEST(MeshFile, ReadsTheSameFromTextAndBytes) {
  const std::string header =
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const MeshData text = read_mesh_file(
      write_file("a.ply", "ply\nformat ascii 1.0\ncomment x\n" + header + "0 0 0.5\n1 0 0\n0 1 0\n3 0 1 2\n"));
  std::string bytes = "ply\nformat binary_little_endian 1.0\n" + header;
  for (const float value : {0.f, 0.f, .5f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f})
    bytes.append(reinterpret_cast<const char*>(&value), 4);
  bytes += '\3';
  for (const std::int32_t value : {0, 1, 2}) bytes.append(reinterpret_cast<const char*>(&value), 4);
  const MeshData binary = read_mesh_file(write_file("b.PLY", bytes));
  EXPECT_EQ(text.vertices, binary.vertices);
  EXPECT_EQ(text.triangles, binary.triangles);
  EXPECT_EQ(text.vertices[0], (Vec3{0, 0, 0.5}));
  const MeshData cube = read_mesh_file(write_file("c.obj", kCube));
  EXPECT_EQ(cube.triangles.size(), 12u);
}

TEST(MeshFile, RefusesWhatItCannotUse) {
  const char* const wrong[][2] = {
      {"missing.stl", "solid"},
      {"a.obj", "v 1 2\n"},
      {"b.obj", "v 0 0 0\nf 1 2 3\n"},
      {"c.obj", "v 0 0 0\nf 1 1\n"},
      {"d.obj", "v 0 0 nan\n"},
      {"e.obj", ""},
      {"f.ply", ""},
      {"g.ply", "ply\nend_header\n"},
      {"h.ply", "ply\nformat ascii 1.0\n"},
      {"i.ply", "ply\nformat binary_big_endian 1.0\nend_header\n"},
      {"j.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999\nend_header\n"},
      {"k.ply", "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nend_header\n1\n"},
      {"l.ply", "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n3 0 1 2\n"},
      {"m.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n"}};
  for (const auto& [name, content] : wrong) EXPECT_THROW(Mesh(mesh_of(write_file(name, content))), InputError) << name;
  EXPECT_THROW(read_mesh_file("/does/not/exist.ply"), InputError);
}

TEST(MeshFile, GlassMustBeClosedAndOutward) {
  std::string open = kCube, inverted = "";
  open.erase(open.rfind("f "));
  EXPECT_THROW(Intersector{scene_of(mesh_of(write_file("open.obj", open)))}, InputError);
  std::istringstream lines(kCube);
  for (std::string kind, a, b, c, d; lines >> kind;) {
    if (kind == "v") lines >> a >> b >> c, inverted += "v " + a + " " + b + " " + c + "\n";
    if (kind == "f") lines >> a >> b >> c >> d, inverted += "f " + d + " " + c + " " + b + " " + a + "\n";
  }
  EXPECT_THROW(Intersector{scene_of(mesh_of(write_file("inverted.obj", inverted)))}, InputError);
  Scene opaque = scene_of(mesh_of(write_file("open.obj", open)));
  opaque.materials[0] = diffuse(0.5);
  EXPECT_NO_THROW(Intersector{opaque});
}

}  // namespace
}  // namespace vitrail
