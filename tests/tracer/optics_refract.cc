/// Snell's law against the closed forms of the optics notes [O 1.2, O 2].

#include <gtest/gtest.h>

#include "build_scene.h"
#include "optics/absorption.h"
#include "optics/fresnel.h"
#include "optics/refract.h"

namespace vitrail {
namespace {

constexpr Vec3 kUp{0, 1, 0};

Vec3 arriving(double angle_deg) { return {std::sin(radians(angle_deg)), -std::cos(radians(angle_deg)), 0}; }
IndexPair into(double n) { return {1, n, 0, n - 1}; }
IndexPair out_of(double n) { return {n, 1, n - 1, 0}; }
double refracted_deg(const Refraction& r) { return degrees(std::atan2(r.direction.x, -r.direction.y)); }

TEST(Refract, FollowsTheTableOfEquation5) {
  // Incidence, correct angle; printed with four decimals, hence half a unit of the last.
  const double table[][2] = {{1, 0.6666},   {10, 6.6478},  {30, 19.4712}, {45, 28.1255},
                             {60, 35.2644}, {75, 40.0870}, {89, 41.8025}};
  for (const auto& [incidence, expected] : table)
    EXPECT_NEAR(refracted_deg(refract(arriving(incidence), kUp, into(1.5))), expected, 5e-5) << incidence;
}

TEST(Refract, KeepsSnellsLawToRounding) {
  for (double n : {0.5, 0.8, 1.0001, 1.5, 2.4, 1e6})
    for (double incidence = 0; incidence < 90; incidence += 0.37) {
      const Vec3 d = arriving(incidence);
      const Refraction r = refract(d, kUp, into(n));
      if (r.total) continue;
      // Two roundings of the sines and one of the normalisation: a few units of 2e-16.
      EXPECT_NEAR(r.direction.x * n, d.x, 1e-15) << n << " " << incidence;
      EXPECT_NEAR(length(r.direction), 1, 4e-16);
    }
}

TEST(Refract, LeavesMatchedMediaAloneAtGrazingIncidence) {
  const Vec3 d = arriving(89.9999);
  EXPECT_EQ(refract(d, kUp, into(1)).direction, d);
  EXPECT_FALSE(refract(d, kUp, into(1)).total);
}

TEST(Refract, DeflectsByTheSmallDifferenceOfIndices) {
  // n = 1 + 1e-12 bends by 1e-12 tan(theta); the direction itself is rounded at 1e-16 [O 2.2].
  const Vec3 d = arriving(60);
  const IndexPair index{1, 1 + 1e-12, 0, 1e-12};
  EXPECT_NEAR(angle_between(d, refract(d, kUp, index).direction), 1e-12 * std::tan(radians(60)), 3e-16);
}

TEST(Refract, TurnsTotalExactlyAtTheCriticalAngle) {
  const double critical = degrees(std::asin(1 / 1.5));
  EXPECT_FALSE(refract(arriving(critical * (1 - 1e-12)), kUp, out_of(1.5)).total);
  EXPECT_TRUE(refract(arriving(critical * (1 + 1e-12)), kUp, out_of(1.5)).total);
  EXPECT_FALSE(refract(arriving(89.9999), kUp, into(1.5)).total);
}

TEST(Refract, KeepsItsDigitsIntoFarThinnerMedia) {
  // Light at asin(n / 2) leaves at 30 degrees. The sine is given to 1e-16 of itself, so the result is known as well;
  // the radicand formed from 1 - eta^2 and (eta c1)^2 would be off by eta^2 1e-16, 1 % at n = 1e-7.
  for (double n : {0.4, 1e-2, 1e-4, 1e-7}) {
    const Vec3 d{n / 2, -std::sqrt(1 - n * n / 4), 0};
    EXPECT_NEAR(refract(d, kUp, {1, n, 0, n - 1}).direction.x, 0.5, 1e-15) << n;
  }
}

TEST(Refract, ReadsThePaperByTheLetterWhereAsked) {
  // All literal, entering: the third column of the table; leaving, the root is never real.
  EXPECT_NEAR(refracted_deg(refract_literal(arriving(30), kUp, into(1.5))), 12.3111, 5e-5);
  EXPECT_NEAR(refracted_deg(refract_literal(arriving(60), kUp, into(1.5))), 23.7494, 5e-5);
  EXPECT_TRUE(refract_literal(arriving(30), kUp, out_of(1.5)).total);
}

TEST(Reflect, KeepsAngleAndLength) {
  const Vec3 r = reflect(arriving(30), kUp);
  EXPECT_NEAR(r.x, 0.5, 1e-15);
  EXPECT_NEAR(r.y, std::cos(radians(30)), 1e-15);
  EXPECT_EQ(reflect(arriving(30), -kUp), r);
}

FresnelShares shares(double angle_deg, const IndexPair& index) {
  return fresnel(index, refract(arriving(angle_deg), kUp, index));
}

TEST(Fresnel, AgreesWithTheTable) {
  // [O 1.1 row 3] prints three decimals; normal incidence is ((n-1)/(n+1))^2 exactly.
  EXPECT_NEAR(shares(0, into(1.5)).R, 0.04, 1e-16);
  EXPECT_NEAR(shares(60, into(1.5)).R, 0.089, 5e-4);
  EXPECT_NEAR(shares(80, into(1.5)).R, 0.388, 5e-4);
  EXPECT_NEAR(shares(89, into(1.5)).R, 0.904, 5e-4);
}

TEST(Fresnel, KeepsTheDigitsOfTAtGrazingIncidence) {
  // [O 2.6]: T = 1.0147e-5 at 89.9999 degrees; five printed digits.
  EXPECT_NEAR(shares(89.9999, into(1.5)).T, 1.0147e-5, 5e-10);
}

TEST(Fresnel, AddsUpToOne) {
  for (double n : {0.3, 0.8, 1.0, 1.5, 4.0, 1e6})
    for (double angle = 0; angle < 90; angle += 0.7) {
      const FresnelShares s = shares(angle, into(n));
      EXPECT_NEAR(s.R + s.T, 1, 2e-15) << n << " " << angle;  // about ten roundings on either side
    }
}

TEST(Fresnel, KeepsTheDigitsOfRBetweenNearlyEqualMedia) {
  // ((n-1)/(n+1))^2 with n - 1 = 1e-12 is 2.5e-25 to the rounding of n + 1.
  const IndexPair index{1, 1 + 1e-12, 0, 1e-12};
  EXPECT_NEAR(shares(0, index).R / 2.5e-25, 1, 2e-12);
}

TEST(Fresnel, IsTheSameFromBothSides) {
  for (double angle = 1; angle < 90; angle += 4.3) {
    const Refraction in = refract(arriving(angle), kUp, into(1.5));
    const Vec3 back = -in.direction;
    const Refraction out = refract(back, -kUp, out_of(1.5));
    // The cosine of a direction is known to 1e-16, relative to itself: near grazing R follows it with slope 1 / cos.
    const double slack = 1e-15 / std::cos(radians(angle));
    EXPECT_NEAR(fresnel(into(1.5), in).R, fresnel(out_of(1.5), out).R, slack) << angle;
  }
}

TEST(Absorption, GuardsTheEndsOfItsRange) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(transmittance(0.0, infinity), 1);
  EXPECT_EQ(transmittance(infinity, 0.0), 1);
  EXPECT_EQ(transmittance(1e9, infinity), 0);
  EXPECT_EQ(transmittance(infinity, 1e-300), 0);
  EXPECT_DOUBLE_EQ(transmittance(2.0, 0.5), std::exp(-1.0));
}

}  // namespace
}  // namespace vitrail
