/// Hits of many rays at once: the vector loops against plain ones, bit for bit, on every instruction set.

#include <cmath>
#include <memory>

#include "build_scene.h"
#include "each_instruction_set.h"
#include "photon/wave/intersect_lanes.h"

namespace vitrail {
namespace {

constexpr std::int32_t kObject = 3;
// No multiple of any vector, so that the last one is partly filled.
constexpr int kRays = 251;

// Rays around the origin; every fourth departs from the object and goes on inside it, every fourth from its outside.
struct Rays {
  PathStates states;
  std::unique_ptr<RayChunk> chunk = std::make_unique<RayChunk>();

  Rays() {
    TestNumbers numbers;
    for (int i = 0; i < kRays; ++i) {
      const HitId departed = i % 4 == 0 ? HitId{kObject, true} : i % 4 == 1 ? HitId{kObject, false} : HitId{};
      // Draw one after the other: compilers evaluate arguments in different orders.
      const Vec3 origin = numbers.in_cube(2), direction = numbers.direction();
      states.add(origin, direction, {}, 0, departed, {});
    }
    chunk->count = kRays;
    for (int a = 0; a < 3; ++a) {
      chunk->origin[a] = states.origin(a);
      chunk->direction[a] = states.direction(a);
    }
    chunk->departed = states.departed();
    chunk->states = states.states();
    chunk->nearest.fill(kInfinity);
    chunk->next.fill(kInfinity);
    chunk->met.fill(kNoObject);
    chunk->too_close.fill(0);
  }
};

// What is known of one ray; `enter` is the plain form of the answers.
struct Answers {
  double nearest = kInfinity, next = kInfinity;
  std::int64_t met = kNoObject;

  void enter(double t, bool entering) {
    if (t < nearest) {
      next = nearest;
      nearest = t;
      met = HitId{kObject, entering}.lane();
    } else if (t < next) {
      next = t;
    }
  }
};

void meet(const SphereShape& sphere, const Ray& ray, HitId departed, Answers& answers) {
  const Vec3 to_center = sphere.center - ray.origin;
  const double closest_at = dot(to_center, ray.direction);
  const double distance = length(to_center - ray.direction * closest_at);
  const double squared = (sphere.radius - distance) * (sphere.radius + distance);
  const double half_chord = std::sqrt(squared > 0 ? squared : 0.0);
  const double in = closest_at - half_chord, out = closest_at + half_chord;
  if (departed.object == kObject) {
    if (departed.entering) answers.enter(closest_at > 0 ? 2 * closest_at : 0.0, false);
  } else if (squared > 0 && out > 0) {
    answers.enter(in > 0 ? in : out, in > 0);
  }
}

template <typename Contains>
void meet_flat(Vec3 point, Vec3 normal, const Contains& contains, const Ray& ray, HitId departed, Answers& answers) {
  const Vec3 from_point = ray.origin - point;
  const double climb = dot(ray.direction, normal), t = -dot(from_point, normal) / climb;
  if (departed.object == kObject || !(t > 0) || !(t < kInfinity)) return;
  if (contains(from_point + ray.direction * t)) answers.enter(t, climb < 0);
}

void meet(const PlaneShape& plane, const Ray& ray, HitId departed, Answers& answers) {
  meet_flat(
      plane.point, plane.normal, [](Vec3) { return true; }, ray, departed, answers);
}
void meet(const RectangleShape& r, const Ray& ray, HitId departed, Answers& answers) {
  const auto contains = [&](Vec3 at) {
    return std::abs(dot(at, normalise(r.u))) <= length(r.u) && std::abs(dot(at, normalise(r.v))) <= length(r.v);
  };
  meet_flat(r.center, normalise(cross(r.u, r.v)), contains, ray, departed, answers);
}
void meet(const DiscShape& disc, const Ray& ray, HitId departed, Answers& answers) {
  meet_flat(
      disc.center, disc.normal, [&](Vec3 at) { return length(at) <= disc.radius; }, ray, departed, answers);
}

// Ask the shapes one after the other, all under one object number, and compare what the rays have met.
template <typename... Shapes>
void expect_the_bits_of_a_plain_loop(std::uint64_t hash_everywhere, const Shapes&... shapes) {
  for_each_instruction_set([&] {
    const Rays rays;
    const RayChunk& chunk = *rays.chunk;
    (intersect(shapes, kObject, *rays.chunk), ...);
    BitHash hash;
    int hits = 0;
    for (std::size_t i = 0; i < kRays; ++i) {
      Answers expected;
      (meet(shapes, rays.states.ray(i), HitId::of_lane(chunk.departed[i]), expected), ...);
      EXPECT_EQ(chunk.nearest[i], expected.nearest);
      EXPECT_EQ(chunk.next[i], expected.next);
      EXPECT_EQ(chunk.met[i], expected.met);
      hits += expected.met != kNoObject;
      hash.add(chunk.nearest[i]);
      hash.add(static_cast<double>(chunk.met[i]));
    }
    EXPECT_GT(hits, kRays / 20);
    EXPECT_LT(hits, kRays);
    EXPECT_EQ(hash.value(), hash_everywhere);
  });
}

constexpr SphereShape kSphere{{0.3, -0.2, 0.1}, 1.3};
const PlaneShape kPlane{{0.1, -0.3, 0.2}, normalise(Vec3{0.3, 1, -0.2})};
constexpr RectangleShape kRectangle{{0, 0.2, 0.1}, {1.5, 0.2, 0}, {-0.2, 1.5, 0.4}};
const DiscShape kDisc{{0.2, 0.1, 0}, normalise(Vec3{1, 1, 0.5}), 2.2};

TEST(IntersectLanes, MeetASphere) { expect_the_bits_of_a_plain_loop(3687101234145543503u, kSphere); }
TEST(IntersectLanes, MeetAPlane) { expect_the_bits_of_a_plain_loop(15326592978473203811u, kPlane); }
TEST(IntersectLanes, MeetARectangle) { expect_the_bits_of_a_plain_loop(11282516960986636979u, kRectangle); }
TEST(IntersectLanes, MeetADisc) { expect_the_bits_of_a_plain_loop(4930771340403535315u, kDisc); }
TEST(IntersectLanes, KeepTheNearestOfSeveral) {
  expect_the_bits_of_a_plain_loop(14593695732032262104u, kDisc, kSphere, kPlane, kRectangle, kSphere);
}

// The gap behind the nearest hit that counts as a tie grows with the coordinates: 2^-30 of them.
TEST(IntersectLanes, FindTiesRelativeToTheCoordinates) {
  for_each_instruction_set([] {
    const Rays rays;
    RayChunk& chunk = *rays.chunk;
    for (std::size_t i = 0; i < kRays; ++i) {
      const double reach = largest_coordinate(rays.states.ray(i).origin) + 1;
      chunk.nearest[i] = 1;
      chunk.next[i] = 1 + reach * 0x1p-30 * (i % 2 == 0 ? 0.999 : 1.001);
    }
    find_ties(chunk);
    for (std::size_t i = 0; i < kRays; ++i) EXPECT_EQ(chunk.too_close[i], i % 2 == 0);
  });
}

TEST(IntersectLanes, ProjectPointsOntoASphere) {
  for_each_instruction_set([] {
    TestNumbers numbers;
    const auto lanes = std::make_unique<SurfaceLanes>();
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < kRays; ++i) {
      const double distance = kSphere.radius * numbers.between(0.99, 1.01);
      points.push_back(kSphere.center + numbers.direction() * distance);
      for (int a = 0; a < 3; ++a) lanes->point[a][i] = points[i][a];
    }
    project(kSphere, kRays, *lanes);
    BitHash hash;
    for (std::size_t i = 0; i < kRays; ++i) {
      const Vec3 outward = points[i] - kSphere.center, normal = outward * (1 / std::sqrt(dot(outward, outward)));
      for (int a = 0; a < 3; ++a) {
        EXPECT_EQ(lanes->normal[a][i], normal[a]);
        EXPECT_EQ(lanes->point[a][i], kSphere.center[a] + normal[a] * kSphere.radius);
        hash.add(lanes->point[a][i]);
      }
    }
    EXPECT_EQ(hash.value(), 13814862813582625108u);  // on every machine
  });
}

}  // namespace
}  // namespace vitrail
