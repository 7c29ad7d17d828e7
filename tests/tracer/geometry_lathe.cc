/// The lathe against the shapes it contains, and what holds where two of its pieces meet.

#include <gtest/gtest.h>

#include <algorithm>

#include "build_scene.h"
#include "geometry/axial.h"
#include "geometry/lathe.h"
#include "geometry/sphere.h"

namespace vitrail {
namespace {

using Profile = std::vector<std::array<double, 2>>;

struct Event {
  double t = 0;
  std::uint32_t face = 0;
  Vec3 point, normal;
};

/// The events on a ray that starts outside, each left by name; sides must alternate and the ray must end outside.
template <typename Solid>
std::vector<Event> events(const Solid& solid, Ray ray) {
  std::vector<Event> found;
  double walked = 0;
  Departure left;
  const Departure* departure = nullptr;
  bool inside = false;
  for (ShapeHit hit; found.size() < 40 && solid.intersect(ray, departure, hit);) {
    EXPECT_EQ(hit.entering, !inside);
    EXPECT_GE(hit.t, 0);
    inside = !inside;
    walked += hit.t;
    const SurfacePoint at = solid.surface(ray.at(hit.t), hit.face);
    found.push_back({walked, hit.face, at.point, at.normal});
    left = {0, hit.face, inside};
    departure = &left;
    ray.origin = at.point;
  }
  EXPECT_FALSE(inside);
  return found;
}

/// That two solids are met alike by random rays: distances, points and normals.
template <typename Known>
void expect_same(const Lathe& lathe, const Known& known, double tolerance) {
  TestNumbers numbers;
  int met = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 target = numbers.in_cube(1);
    const Vec3 direction = numbers.direction();
    const Ray ray{target - direction * 4, direction};
    const std::vector<Event> found = events(lathe, ray), wanted = events(known, ray);
    ASSERT_EQ(found.size(), wanted.size()) << i;
    met += static_cast<int>(found.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      // Rays that graze slide along the surface by the error over the sine, 1e-4 at least among so many rays.
      const double slant = std::max(1e-4, std::abs(dot(direction, wanted[k].normal)));
      EXPECT_NEAR(found[k].t, wanted[k].t, tolerance / slant) << i;
      // A normal turns by the error over the distance from the axis, 0.1 and more but for the few rays at a tip.
      EXPECT_LT(length(found[k].normal - wanted[k].normal), 10 * tolerance / slant) << i;
    }
  }
  EXPECT_GT(met, 1000);
}

const Profile kRod = {{0, -0.75}, {0.5, -0.75}, {0.5, 0.625}, {0, 0.625}};
const Profile kTip = {{0, -0.5}, {0.75, -0.5}, {0, 1}};
const Profile kTube = {{0.5, -0.5}, {0.75, -0.5}, {0.75, 0.5}, {0.5, 0.5}};
/// A cup with a thin wall, cones that open and close, and a thread of glass along the axis.
const Profile kCup = {{0, -1},    {0.6, -1},   {0.1, -0.9}, {0.05, -0.2},  {0.7, 0.4},
                      {0.6, 0.9}, {0.59, 0.9}, {0.68, 0.4}, {0.04, -0.15}, {0, -0.15}};
const Profile kHourglass = {{0, -1}, {0.75, -1}, {0, 0}, {0.75, 1}, {0, 1}};

Profile reversed(Profile profile) {
  std::reverse(profile.begin(), profile.end());
  return profile;
}

TEST(Lathe, IsACylinderAndACone) {
  for (const Profile& profile : {kRod, reversed(kRod)})
    expect_same(Lathe({profile, {}}), Axial(CylinderShape{{0, -0.75, 0}, {0, 0.625, 0}, 0.5}), 4e-15);
  expect_same(Lathe({kTip, {}}), Axial(ConeShape{{0, -0.5, 0}, {0, 1, 0}, 0.75, 0}), 2e-14);
  const Frame frame = turned({0.1, -0.2, 0.05});
  expect_same(Lathe({kTip, frame}),
              Axial(ConeShape{frame.point_to_world({0, -0.5, 0}), frame.point_to_world({0, 1, 0}), 0.75, 0}), 2e-14);
}

TEST(Lathe, OfManyPiecesIsABall) {
  // 200 corners on the half circle: a chord lies inside its arc by the sagitta, 1 - cos(pi / 398) = 3.1e-5.
  Profile arc;
  for (int i = 0; i < 200; ++i) {
    const double angle = kPi * i / 199;
    arc.push_back({i % 199 == 0 ? 0 : std::sin(angle), -std::cos(angle)});
  }
  const Lathe lathe({arc, {}});
  const Sphere ball({{0, 0, 0}, 1});
  TestNumbers numbers;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 direction = numbers.direction(), target = numbers.in_cube(0.5);
    const Ray ray{target - direction * 4, direction};
    const std::vector<Event> found = events(lathe, ray), wanted = events(ball, ray);
    ASSERT_EQ(found.size(), 2u);
    for (int k = 0; k < 2; ++k) {
      const double slant = std::abs(dot(direction, wanted[static_cast<std::size_t>(k)].normal));
      EXPECT_NEAR(found[static_cast<std::size_t>(k)].t, wanted[static_cast<std::size_t>(k)].t, 3.3e-5 / slant);
    }
  }
}

TEST(Lathe, HasABore) {
  const Lathe tube({kTube, {}});
  EXPECT_EQ(events(tube, {{0, 3, 0}, {0, -1, 0}}).size(), 0u);
  const std::vector<Event> across = events(tube, {{-3, 0.25, 0}, {1, 0, 0}});
  ASSERT_EQ(across.size(), 4u);
  const double wanted[] = {2.25, 2.5, 3.5, 3.75};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(across[k].t, wanted[k], 1e-15);
  EXPECT_EQ(across[0].face, 1u);
  EXPECT_EQ(across[1].face, 3u);
  EXPECT_EQ(across[1].normal, (Vec3{1, 0, 0}));  // out of the glass, towards the axis
  EXPECT_FALSE(tube.contains({0, 0, 0}));
  EXPECT_TRUE(tube.contains({0, 0, 0.6}));
}

TEST(Lathe, LetsNoRaySlipThroughASeam) {
  // Rays aimed at the circles where pieces meet, at the tips on the axis, along the pieces, level and upright: as many
  // times in as out, from anywhere. `events` asserts it; at a third of these rays rounding alone decides.
  TestNumbers numbers;
  for (const Profile& profile : {kRod, kTip, kTube, kCup, kHourglass}) {
    for (const Frame& frame : {Frame{}, turned({0.1, -0.2, 0.05})}) {
      const Lathe lathe({profile, frame});
      for (int i = 0; i < 20000; ++i) {
        const auto& corner = profile[static_cast<std::size_t>(i) % profile.size()];
        const auto& next = profile[(static_cast<std::size_t>(i) + 1) % profile.size()];
        const double around = numbers.between(0, 2 * kPi), across = std::cos(around), aside = std::sin(around);
        const Vec3 seam{corner[0] * across, corner[1], corner[0] * aside};
        const Vec3 other{next[0] * across, next[1], next[0] * aside};
        Vec3 direction = numbers.direction();
        if (i % 5 == 1) direction = normalise(other - seam);
        if (i % 5 == 2) direction = normalise({direction.x, 0, direction.z});
        if (i % 5 == 3) direction = {0, direction.y < 0 ? -1.0 : 1.0, 0};
        if (i % 5 == 4) direction = normalise({-aside, direction.y * 1e-3, across});
        const Vec3 to_world = frame.direction_to_world(direction);
        events(lathe, {frame.point_to_world(seam) - to_world * 4, to_world});
        ASSERT_FALSE(HasFailure()) << "ray " << i << " corners " << profile.size();
      }
    }
  }
}

TEST(Lathe, IsMetFromAMillionSizesAway) {
  TestNumbers numbers;
  const Lathe lathe({kCup, turned({0.1, -0.2, 0.05})});
  int met = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 origin = numbers.direction() * 1e6;
    const Ray ray{origin, normalise(numbers.in_cube(0.7) - origin)};
    ShapeHit hit;
    if (!lathe.intersect(ray, nullptr, hit)) continue;
    ++met;
    const SurfacePoint at = lathe.surface(ray.at(hit.t), hit.face);
    EXPECT_TRUE(hit.entering);
    EXPECT_LT(std::abs(dot(at.point - ray.at(hit.t), at.normal)), 1e-9);  // 1e6 is a number with steps of 1e-10
    EXPECT_LT(dot(at.normal, ray.direction), 1e-3);
  }
  EXPECT_GT(met, 1000);
}

TEST(Lathe, HasTheVolumeOfPappus) {
  // The mean chord of lines along a direction times the area they are spread over; four of its standard errors, one
  // chance in 16 000. A frustum between radii a and b has the volume pi h (a^2 + a b + b^2) / 3.
  const auto volume_of = [](const Profile& profile) {
    double sum = 0;
    for (std::size_t i = 0; i < profile.size(); ++i) {
      const auto &a = profile[i], &b = profile[(i + 1) % profile.size()];
      sum += kPi * (b[1] - a[1]) * (a[0] * a[0] + a[0] * b[0] + b[0] * b[0]) / 3;
    }
    return sum;
  };
  TestNumbers numbers;
  for (const Profile& profile : {kTube, kCup, kHourglass}) {
    const Lathe lathe({profile, {}});
    const double lines = 100000, half = 1.3;
    double chord = 0, squares = 0;
    for (int i = 0; i < lines; ++i) {
      const Vec3 direction = numbers.direction();
      const SurfaceFrame frame = surface_frame(direction);
      const Vec3 beside = frame.u * numbers.between(-half, half) + frame.v * numbers.between(-half, half);
      const std::vector<Event> found = events(lathe, {beside - direction * 3, direction});
      double inside = 0;
      for (std::size_t k = 0; k + 1 < found.size(); k += 2) inside += found[k + 1].t - found[k].t;
      chord += inside, squares += inside * inside;
    }
    const double error = std::sqrt((squares / lines - chord * chord / lines / lines) / lines);
    EXPECT_NEAR(chord / lines, volume_of(profile) / (4 * half * half), 4 * error);
  }
}

/// A vase of many pieces is searched by runs of them. Begun at another corner it has other runs and the same surface:
/// the hits have the same bits.
TEST(Lathe, HasTheSameHitsWhereverItsProfileBegins) {
  constexpr std::size_t kCorners = 150, kTurned = 37;
  Profile profile;
  for (std::size_t i = 0; i < kCorners; ++i) {
    const double along = 2 * kPi * static_cast<double>(i) / kCorners;
    profile.push_back({0.5 + 0.2 * std::cos(along) + 0.01 * std::cos(9 * along), 0.8 * std::sin(along)});
  }
  Profile turned_profile(profile.begin() + kTurned, profile.end());
  turned_profile.insert(turned_profile.end(), profile.begin(), profile.begin() + kTurned);
  const Lathe lathe({profile, turned()}), again({turned_profile, turned()});
  TestNumbers numbers;
  int met = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 direction =
        i % 3 == 0 ? turned().direction_to_world({0, i % 2 == 0 ? 1.0 : -1.0, 0}) : numbers.direction();
    const Ray ray{numbers.in_cube(0.8) - direction * 4, direction};
    const std::vector<Event> found = events(lathe, ray), wanted = events(again, ray);
    ASSERT_EQ(found.size(), wanted.size());
    met += static_cast<int>(found.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_EQ(found[k].t, wanted[k].t);
      EXPECT_EQ(found[k].face, (wanted[k].face + kTurned) % kCorners);
    }
  }
  EXPECT_GT(met, 10000);
}

}  // namespace
}  // namespace vitrail
