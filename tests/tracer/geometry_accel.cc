/// List and tree give the same hits to the bit; what coincides is reported together.

#include <gtest/gtest.h>

#include "base/parallel.h"
#include "build_scene.h"
#include "geometry/accel.h"

namespace vitrail {
namespace {

/// Many solids of all kinds on a floor, some of them touching, one as large as a planet.
Scene crowded_scene(double k = 1) {
  SceneBuilder builder;
  const std::uint32_t clear = builder.add(glass(1.5));
  const std::uint32_t grey = builder.add(diffuse(0.5));
  TestNumbers numbers;
  for (int i = 0; i < 60; ++i) {
    const Vec3 at = numbers.in_cube(4);
    const double size = numbers.between(0.1, 0.6);
    const Frame frame = i % 2 ? turned(at * k) : Frame{at * k};
    Shape shape;
    switch (i % 6) {
      case 0:
        shape = SphereShape{at * k, size * k};
        break;
      case 1:
        shape = BoxShape{Vec3{-size, -size, -size} * k, Vec3{size, 2 * size, size} * k, frame};
        break;
      case 2:
        shape = CylinderShape{at * k, (at + Vec3{size, size, 0}) * k, size * k / 2};
        break;
      case 3:
        shape = ConeShape{at * k, (at + Vec3{size, size, 0}) * k, size * k / 2, 0};
        break;
      case 4:
        shape = LensShape{-2 * size * k, 2 * size * k, size * k, 2 * size * k, frame};
        break;
      default:
        shape = PrismShape{{{-size * k, 0}, {size * k, 0}, {0, size * k}}, size * k, frame};
        break;
    }
    builder.add("solid", shape, clear);
  }
  builder.add("floor", PlaneShape{Vec3{0, -5, 0} * k, {0, 1, 0}}, grey);
  builder.add("planet", SphereShape{Vec3{0, -1e6 - 6, 0} * k, 1e6 * k}, grey);
  for (int i = 0; i < 4; ++i)
    builder.add("tile", BoxShape{Vec3{i * 0.5, -5, 0} * k, Vec3{i * 0.5 + 0.5, -4.5, 1} * k, {}}, clear);
  return builder.scene;
}

void expect_same(const Hit& a, const Hit& b) {
  ASSERT_EQ(a.t, b.t);
  ASSERT_EQ(a.point, b.point);
  ASSERT_EQ(a.crossings.size(), b.crossings.size());
  for (int i = 0; i < a.crossings.size(); ++i) {
    ASSERT_EQ(a.crossings[i].object, b.crossings[i].object);
    ASSERT_EQ(a.crossings[i].face, b.crossings[i].face);
    ASSERT_EQ(a.crossings[i].entering, b.crossings[i].entering);
    ASSERT_EQ(a.crossings[i].normal, b.crossings[i].normal);
  }
}

TEST(Intersector, FindsTheSameByListAndByTree) {
  const Scene scene = crowded_scene();
  const Intersector list(scene, Search::list), tree(scene, Search::embree);
  TestNumbers numbers;
  int hits = 0;
  for (int i = 0; i < 30000; ++i) {
    // Follow each ray through everything, so that starts on surfaces are compared too; some come from far away.
    const double away = i % 10 == 0 ? 1e7 : 6;
    Ray ray{numbers.in_cube(away), {}};
    ray.direction = normalise(numbers.in_cube(4) - ray.origin);
    Departures left;
    for (int step = 0; step < 6; ++step) {
      Hit a, b;
      const bool met = list.closest(ray, left, a);
      ASSERT_EQ(met, tree.closest(ray, left, b));
      const double t_max = numbers.between(0, 2) * (met ? a.t : 5);
      ASSERT_EQ(list.occluded(ray, left, t_max), tree.occluded(ray, left, t_max));
      if (!met) break;
      ++hits;
      expect_same(a, b);
      ray.origin = a.point;
      left = a.through();
    }
  }
  EXPECT_GT(hits, 30000);
}

TEST(Intersector, IsTheSameAtAnyPowerOfTwo) {
  const double k = 0x1p-40;
  const Scene scene = crowded_scene(), small = crowded_scene(k);
  for (Search search : {Search::list, Search::embree}) {
    const Intersector one(scene, search), other(small, search);
    TestNumbers numbers;
    for (int i = 0; i < 5000; ++i) {
      const Ray ray{numbers.in_cube(6), numbers.direction()};
      Hit a, b;
      ASSERT_EQ(one.closest(ray, {}, a), other.closest({ray.origin * k, ray.direction}, {}, b));
      if (a.crossings.size() == 0) continue;
      a.t *= k;
      a.point = a.point * k;
      expect_same(a, b);
    }
  }
}

TEST(Intersector, ReportsTouchingFacesTogether) {
  for (Search search : {Search::list, Search::embree}) {
    const Scene scene = crowded_scene();
    const Intersector intersector(scene, search);
    // From tile to tile along x: exit and entry in one hit.
    Hit hit;
    ASSERT_TRUE(intersector.closest({{0.25, -4.75, 0.5}, normalise({1, 0.01, 0.02})}, {}, hit));
    ASSERT_EQ(hit.crossings.size(), 2);
    EXPECT_FALSE(hit.crossings[0].entering);
    EXPECT_TRUE(hit.crossings[1].entering);
    EXPECT_EQ(hit.through().size(), 2);

    // A tile stands on the floor: both faces in one hit.
    ASSERT_TRUE(intersector.closest({{0.25, -4.75, 0.5}, normalise({0.01, -1, 0.02})}, {}, hit));
    EXPECT_EQ(hit.crossings.size(), 2);
  }
}

TEST(Intersector, SeesTouchingFacesAtGrazingIncidenceInAnyFrame) {
  // Two boxes share a face in a rotated frame; rays at a hundredth of a degree still meet both at once.
  SceneBuilder builder;
  const std::uint32_t clear = builder.add(glass(1.5));
  const Frame frame = turned({100, 200, 300});
  builder.add("left", BoxShape{{-1, -9, -9}, {0, 9, 9}, frame}, clear);
  builder.add("right", BoxShape{{0, -9, -9}, {1, 9, 9}, frame}, clear);
  const Intersector intersector(builder.scene);
  TestNumbers numbers;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 local{-0.0005, numbers.between(-1, 1), numbers.between(-1, 1)};
    const Vec3 d = normalise({std::sin(radians(0.01)), std::cos(radians(0.01)), 0});
    Hit hit;
    ASSERT_TRUE(intersector.closest({frame.point_to_world(local), frame.direction_to_world(d)}, {}, hit));
    ASSERT_EQ(hit.crossings.size(), 2) << i;
    EXPECT_FALSE(hit.crossings[0].entering);
    EXPECT_TRUE(hit.crossings[1].entering);
  }
}

TEST(Intersector, BlocksOnlyWhatLiesBetween) {
  SceneBuilder builder;
  builder.add("ball", SphereShape{{0, 0, 5}, 1}, builder.add(glass(1.5)));
  const Intersector intersector(builder.scene);
  const Ray ray{{0, 0, 0}, {0, 0, 1}};
  EXPECT_FALSE(intersector.occluded(ray, {}, 3.9));
  EXPECT_FALSE(intersector.occluded(ray, {}, 4));  // a light that touches the ball is not behind it
  EXPECT_TRUE(intersector.occluded(ray, {}, 4.1));
  EXPECT_TRUE(intersector.occluded(ray, {}, kInfinity));
  Departures inside;
  inside.push_back({0, 0, true});
  EXPECT_TRUE(intersector.occluded({{0, 0, 4}, {0, 0, 1}}, inside, kInfinity));
  Departures outside;
  outside.push_back({0, 0, false});
  EXPECT_FALSE(intersector.occluded({{0, 0, 4}, {0, 0, -1}}, outside, kInfinity));
}

TEST(Intersector, MayBeAskedByManyThreadsAtOnce) {
  const Scene scene = crowded_scene();
  const Intersector intersector(scene, Search::embree);
  TestNumbers numbers;
  std::vector<Ray> rays;
  for (int i = 0; i < 4000; ++i) rays.push_back({numbers.in_cube(6), numbers.direction()});
  const auto distances = [&](unsigned threads) {
    std::vector<double> found(rays.size());
    parallel_blocks(40, threads, [&](std::uint64_t block, unsigned) {
      for (std::size_t i = block * 100; i < block * 100 + 100; ++i) {
        Hit hit;
        found[i] = intersector.closest(rays[i], {}, hit) ? hit.t : -1;
        found[i] += intersector.media_at(rays[i].origin).size();
      }
    });
    return found;
  };
  EXPECT_EQ(distances(1), distances(7));
}

TEST(Intersector, KnowsTheMediaAtAPoint) {
  const Scene scene = crowded_scene();
  const Intersector list(scene, Search::list), tree(scene, Search::embree);
  TestNumbers numbers;
  int inside = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 point = numbers.in_cube(i % 100 == 0 ? 1e4 : 5);
    const MediumSet a = list.media_at(point), b = tree.media_at(point);
    ASSERT_EQ(a.size(), b.size());
    for (int k = 0; k < a.size(); ++k) ASSERT_EQ(a[k], b[k]);
    inside += a.size() > 0;
  }
  EXPECT_GT(inside, 200);
  EXPECT_EQ(list.media_at({0.25, -4.75, 0.5}).size(), 1);
  EXPECT_EQ(list.media_at({0.25, -5.25, 0.5}).size(), 0);  // the floor is opaque
}

TEST(Intersector, AnswersForAnEmptyScene) {
  const Scene scene = SceneBuilder().scene;
  for (Search search : {Search::automatic, Search::list, Search::embree}) {
    const Intersector intersector(scene, search);
    Hit hit;
    EXPECT_FALSE(intersector.closest({{0, 0, 0}, {0, 0, 1}}, {}, hit));
    EXPECT_FALSE(intersector.occluded({{0, 0, 0}, {0, 0, 1}}, {}, kInfinity));
    EXPECT_TRUE(intersector.bounds().is_empty());
  }
}

}  // namespace
}  // namespace vitrail
