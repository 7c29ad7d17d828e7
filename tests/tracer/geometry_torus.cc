/// The torus against its quartic in quadruple precision, closed forms, and its volume and area by counting rays.

#include <gtest/gtest.h>

#include <array>

#include "build_scene.h"
#include "geometry/torus.h"

namespace vitrail {
namespace {

__extension__ using Wide = __float128;  // 113 bits: its roundings are invisible beside those of double

/// Polynomials of degree 4 at most, lowest power first.
using Polynomial = std::array<Wide, 5>;

struct WideLine {
  std::array<Wide, 3> origin, direction;
};

WideLine widened(const Ray& ray) {
  return {{ray.origin.x, ray.origin.y, ray.origin.z}, {ray.direction.x, ray.direction.y, ray.direction.z}};
}

/// The quartic of a torus about the z axis at the origin along a line: (p^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + y^2).
Polynomial quartic(const WideLine& line, Wide ring, Wide tube) {
  const auto& [o, d] = line;
  const auto product = [](const auto& a, const auto& b) {
    return std::array<Wide, 3>{a[0] * b[0], a[1] * b[1], a[2] * b[2]};
  };
  const auto oo = product(o, o), od = product(o, d), dd = product(d, d);
  const Wide c0 = oo[0] + oo[1] + oo[2] + (ring - tube) * (ring + tube), c1 = 2 * (od[0] + od[1] + od[2]),
             c2 = dd[0] + dd[1] + dd[2], four = 4 * ring * ring;
  return {c0 * c0 - four * (oo[0] + oo[1]), 2 * c0 * c1 - 2 * four * (od[0] + od[1]),
          c1 * c1 + 2 * c0 * c2 - four * (dd[0] + dd[1]), 2 * c1 * c2, c2 * c2};
}

/// How often the signs of Sturm's chain change at t: the difference between two places counts the roots between them.
int sign_changes(const std::vector<Polynomial>& chain, Wide t) {
  int changes = 0, last = 0;
  for (const Polynomial& p : chain) {
    Wide value = 0;
    for (int power = 4; power >= 0; --power) value = value * t + p[static_cast<std::size_t>(power)];
    const int sign = value > 0 ? 1 : value < 0 ? -1 : 0;
    if (sign != 0 && last != 0 && sign != last) ++changes;
    if (sign != 0) last = sign;
  }
  return changes;
}

/// The number of different roots at 0 < t < end.
int root_count(const Polynomial& p, Wide end) {
  std::vector<Polynomial> chain = {p, {p[1], 2 * p[2], 3 * p[3], 4 * p[4], 0}};
  for (std::size_t degree = 3; degree > 0; --degree) {
    // The remainder of the last two, with its sign turned.
    Polynomial rest = chain[chain.size() - 2];
    const Polynomial& by = chain.back();
    if (by[degree] == 0) break;
    for (std::size_t shift = 2; shift-- > 0;) {
      const Wide times = rest[degree + shift] / by[degree];
      for (std::size_t i = 0; i <= degree; ++i) rest[i + shift] -= times * by[i];
      rest[degree + shift] = 0;
    }
    for (Wide& coefficient : rest) coefficient = -coefficient;
    chain.push_back(rest);
  }
  return sign_changes(chain, 0) - sign_changes(chain, end);
}

/// The distance of a point of the line from the torus, to first order: the quartic over its other factor and 2 r.
double gap_at(const WideLine& line, double t, double ring, double tube) {
  std::array<Wide, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = line.origin[i] + line.direction[i] * t;
  const Wide lateral = p[0] * p[0] + p[1] * p[1], all = lateral + p[2] * p[2];
  const Wide r = ring, s = tube, sum = all + (r - s) * (r + s);
  const Wide value = sum * sum - 4 * r * r * lateral;
  const Wide other = sum + 2 * r * std::sqrt(static_cast<double>(lateral));
  return std::abs(static_cast<double>(value / (other * 2 * s)));
}

Torus torus_of(double ring, double tube) { return Torus({{0, 0, 0}, {0, 0, 1}, ring, tube}); }

/// The events on a ray that starts outside, each left by name.
std::vector<double> events(const Torus& torus, Ray ray) {
  std::vector<double> found;
  double walked = 0;
  Departure left;
  const Departure* departure = nullptr;
  bool inside = false;
  for (ShapeHit hit; found.size() < 8 && torus.intersect(ray, departure, hit);) {
    EXPECT_EQ(hit.entering, !inside);
    inside = !inside;
    walked += hit.t;
    found.push_back(walked);
    left = {0, 0, inside};
    departure = &left;
    ray.origin = ray.at(hit.t);
  }
  EXPECT_FALSE(inside);
  return found;
}

constexpr double kTubes[] = {1e-4, 1e-2, 0.3, 0.9, 0.999};  // over a ring of radius 1

TEST(Torus, HasTheRootsOfItsQuartic) {
  // Rays at anything, and rays that graze: through a point of the surface, nearly along it. The number of events is
  // that of Sturm's chain wherever a tube thicker or thinner by 1e-13 of the ring has it too.
  TestNumbers numbers;
  for (const double tube : kTubes) {
    const Torus torus = torus_of(1, tube);
    int met[5] = {};
    for (int i = 0; i < 6000; ++i) {
      const double around = numbers.between(0, 2 * kPi), about = numbers.between(0, 2 * kPi);
      const Vec3 outward{std::cos(around) * std::cos(about), std::sin(around) * std::cos(about), std::sin(about)};
      const Vec3 target = Vec3{std::cos(around), std::sin(around), 0} + outward * tube;
      const double lift = i % 2 == 0 ? 1 : std::pow(10.0, -numbers.between(1, 12));
      const Vec3 direction = normalise(cross(outward, numbers.direction()) + outward * numbers.between(-lift, lift));
      const Ray ray{target - direction * 5, direction};
      const WideLine line = widened(ray);
      const int few = root_count(quartic(line, 1, tube - 1e-13), 20);
      const bool decided = few == root_count(quartic(line, 1, tube + 1e-13), 20);
      const std::vector<double> found = events(torus, ray);
      if (decided) {
        ASSERT_EQ(static_cast<int>(found.size()), few) << tube << " ray " << i;
        ++met[few];
      }
      // Six units of way and of ring, two roundings each per event.
      for (const double t : found) ASSERT_LT(gap_at(line, t, 1, tube), 4e-15) << tube << " ray " << i;
    }
    EXPECT_GT(met[2], 1000) << tube;
    EXPECT_GT(met[4], tube < 1e-3 ? 2 : 30) << tube;  // few rays meet a thread twice
  }
}

TEST(Torus, IsMetFromAMillionRingsAway) {
  // A start 1e6 away is a number with steps of 1e-10: so far the line is known, and so far the hit is right.
  TestNumbers numbers;
  for (const double tube : kTubes) {
    const Torus torus = torus_of(1, tube);
    int met = 0;
    for (int i = 0; i < 4000; ++i) {
      const double around = numbers.between(0, 2 * kPi);
      const Vec3 target = Vec3{std::cos(around), std::sin(around), 0} + numbers.in_cube(tube);
      const Vec3 origin = numbers.direction() * 1e6;
      const Ray ray{origin, normalise(target - origin)};
      ShapeHit hit;
      if (!torus.intersect(ray, nullptr, hit)) continue;
      ++met;
      ASSERT_TRUE(hit.entering);
      const SurfacePoint at = torus.surface(ray.at(hit.t), 0);
      EXPECT_LT(std::abs(dot(at.point - ray.at(hit.t), at.normal)), 1e-9) << tube;
      EXPECT_LT(dot(at.normal, ray.direction), 1e-3) << tube;
    }
    EXPECT_GT(met, 1500) << tube;
  }
}

TEST(Torus, IsMetWhereSymmetrySays) {
  const Torus torus = torus_of(1, 0.25);
  const auto expect = [&](const Ray& ray, std::vector<double> wanted) {
    const std::vector<double> found = events(torus, ray);
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(found[i], wanted[i], 2e-15) << i;
  };
  expect({{-3, 0, 0}, {1, 0, 0}}, {1.75, 2.25, 3.75, 4.25});
  expect({{1, 0, 2}, {0, 0, -1}}, {1.75, 2.25});
  expect({{0, 0, 2}, {0, 0, -1}}, {});
  expect({{0, 1, -2}, {0, 0, 1}}, {1.75, 2.25});
  // A chord of the outer circle that misses the hole, and one that crosses the hole at z = 0.
  expect({{0.8, -2, 0}, {0, 1, 0}}, {2 - std::sqrt(1.5625 - 0.64), 2 + std::sqrt(1.5625 - 0.64)});
  expect({{0.5, -2, 0}, {0, 1, 0}}, {2 - std::sqrt(1.5625 - 0.25), 2 - std::sqrt(0.5625 - 0.25),
                                     2 + std::sqrt(0.5625 - 0.25), 2 + std::sqrt(1.5625 - 0.25)});
  // Villarceau: the plane through the centre that touches the torus twice holds two circles of radius R, and its line
  // through the centre touches at sqrt(R^2 - r^2); a hair steeper it misses, a hair flatter it has four roots.
  const double touch = std::asin(0.25);
  expect({Vec3{std::cos(touch + 1e-7), 0, std::sin(touch + 1e-7)} * -3,
          {std::cos(touch + 1e-7), 0, std::sin(touch + 1e-7)}},
         {});
  EXPECT_EQ(events(torus, {Vec3{std::cos(touch - 1e-7), 0, std::sin(touch - 1e-7)} * -3,
                           {std::cos(touch - 1e-7), 0, std::sin(touch - 1e-7)}})
                .size(),
            4u);
}

TEST(Torus, IsLeftByNameAndMetAgain) {
  const Torus torus = torus_of(1, 0.25);
  const Departure outside{0, 0, false}, inside{0, 0, true};
  ShapeHit hit;
  // Across the hole, away from the outer circle, and through the tube.
  ASSERT_TRUE(torus.intersect({{0.75, 0, 0}, {-1, 0, 0}}, &outside, hit));
  EXPECT_TRUE(hit.entering);
  EXPECT_NEAR(hit.t, 1.5, 1e-15);
  EXPECT_FALSE(torus.intersect({{1.25, 0, 0}, {1, 0, 0}}, &outside, hit));
  ASSERT_TRUE(torus.intersect({{1.25, 0, 0}, {-1, 0, 0}}, &inside, hit));
  EXPECT_FALSE(hit.entering);
  EXPECT_NEAR(hit.t, 0.5, 1e-15);
  // Along the outer circle nothing is met; inside and turned a hair outwards, the ray leaves at once.
  EXPECT_FALSE(torus.intersect({{1.25, 0, 0}, {0, 1, 0}}, &outside, hit));
  ASSERT_TRUE(torus.intersect({{1.25, 0, 0}, normalise({1e-12, 1, 0})}, &inside, hit));
  EXPECT_EQ(hit.t, 0);
  // Along the inner circle the tube is on both sides: a ray inside stays there up to the outer circle.
  ASSERT_TRUE(torus.intersect({{0.75, 0, 0}, normalise({1e-12, 1, 0})}, &inside, hit));
  EXPECT_NEAR(hit.t, 1, 1e-11);
}

TEST(Torus, HasTheNormalsOfItsDistance) {
  TestNumbers numbers;
  const Torus torus({{0.5, -1, 2}, normalise({1, 2, 3}), 1, 0.3});
  const auto distance = [&](Vec3 p) {
    const Vec3 offset = p - Vec3{0.5, -1, 2}, n = normalise({1, 2, 3});
    const double height = dot(offset, n);
    return std::hypot(length(offset - n * height) - 1, height);
  };
  for (int i = 0; i < 500; ++i) {
    const Vec3 direction = numbers.direction();
    ShapeHit hit;
    const Ray ray{Vec3{0.5, -1, 2} + numbers.in_cube(1) - direction * 5, direction};
    if (!torus.intersect(ray, nullptr, hit)) continue;
    const SurfacePoint at = torus.surface(ray.at(hit.t), 0);
    EXPECT_NEAR(distance(at.point), 0.3, 2e-15);
    // Central differences over 1e-5: 1e-10 of curvature and 1e-11 of rounding.
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 step;
      step[axis] = 1e-5;
      EXPECT_NEAR((distance(at.point + step) - distance(at.point - step)) / 2e-5, at.normal[axis], 1e-9);
    }
  }
}

TEST(Torus, HasTheVolumeAndAreaOfPappus) {
  // Isotropic lines through a ball of radius B: the mean chord is V / (pi B^2), the mean number of crossings 2 A over
  // the area of the ball. Each mean is held to four of its own standard errors, one chance in 16 000.
  TestNumbers numbers;
  for (const double tube : {0.05, 0.3, 0.9}) {
    const Torus torus = torus_of(1, tube);
    const double ball = 1 + tube, lines = 60000;
    double chord = 0, chord_squared = 0, crossings = 0, crossings_squared = 0;
    for (int i = 0; i < lines; ++i) {
      const Vec3 direction = numbers.direction();
      const SurfaceFrame frame = surface_frame(direction);
      const double r = ball * std::sqrt(numbers.unit()), angle = numbers.between(0, 2 * kPi);
      const Vec3 beside = frame.u * (r * std::cos(angle)) + frame.v * (r * std::sin(angle));
      const std::vector<double> found = events(torus, {beside - direction * 3, direction});
      double inside = 0;
      for (std::size_t k = 0; k + 1 < found.size(); k += 2) inside += found[k + 1] - found[k];
      chord += inside, chord_squared += inside * inside;
      crossings += static_cast<double>(found.size());
      crossings_squared += static_cast<double>(found.size() * found.size());
    }
    const auto error = [&](double sum, double squares) {
      return std::sqrt((squares / lines - sum * sum / lines / lines) / lines);
    };
    const double volume = 2 * kPi * kPi * tube * tube, area = 4 * kPi * kPi * tube;
    EXPECT_NEAR(chord / lines, volume / (kPi * ball * ball), 4 * error(chord, chord_squared)) << tube;
    EXPECT_NEAR(crossings / lines, 2 * area / (4 * kPi * ball * ball), 4 * error(crossings, crossings_squared)) << tube;
  }
}

}  // namespace
}  // namespace vitrail
