/// The white furnace: a ball of every combination of material under a sky of radiance 1. Nothing may make light; what
/// loses none cannot be seen, and what absorbs shows its law.

#include <gtest/gtest.h>

#include <functional>

#include "build_furnace.h"

namespace vitrail {
namespace {

/// Every pixel against a law of the offset, in all channels; sky pixels show the sky.
void expect_law(const Body& body, double tolerance, const std::function<double(double)>& law) {
  const Film film = rendered(furnace(body));
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double offset = offset_of(x, y), truth = offset < 1 ? law(offset) : 1;
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(film.radiance(x, y)[c], truth, tolerance) << name_of(body) << " at " << offset;
        EXPECT_LE(film.radiance(x, y)[c], 1 + tolerance) << name_of(body) << " at " << offset;
      }
    }
  }
}

/// Noise of the weak branches that are left to chance; in a ball some dozens of them, and some hundreds where GGX sends
/// light at a slant that goes round for long and divides at every face.
constexpr double kChance = 3e-5;

TEST(Furnace, HidesWhatMirrorsAndTransmitsEverything) {
  for (const BodyShares shares : {BodyShares{0, 0, 1}, BodyShares{0, 0.3, 0.7}, BodyShares{0, 1, 0}}) {
    for (const bool fresnel : {false, true}) {
      if (fresnel && shares.t == 0) continue;  // an opaque mirror absorbs what it does not mirror: below
      for (const Roughness& roughness : kFaces) {
        for (const bool disperses : {false, true}) {
          const double noise = std::holds_alternative<Ggx>(roughness) ? 10 * kChance : kChance;
          expect_law({shares, fresnel, roughness, disperses}, noise, [](double) { return 1.0; });
        }
      }
    }
  }
}

/// A convex body that is not of glass scatters the sky: d of it, and the share of its mirror on top.
TEST(Furnace, ShowsTheAlbedoOfWhatIsOpaque) {
  for (const BodyShares shares : {BodyShares{1, 0, 0}, BodyShares{0.4, 0.6, 0}, BodyShares{0.3, 0.2, 0}}) {
    for (const Roughness& roughness : kFaces) {
      expect_law({shares, false, roughness, false}, kFilmRounding, [&](double) { return shares.d + shares.r; });
    }
    expect_law({shares, true, NoRoughness{}, false}, kFilmRounding,
               [&](double offset) { return shares.d + shares.r * mirror_share(offset); });
  }
  // A rough mirror with Fresnel has no such formula: some microfacets of the lobe, from nothing of .6 to all of it.
  for (const Roughness& roughness : {kFaces[1], kFaces[2]}) {
    expect_law({{0.4, 0.6, 0}, true, roughness, false}, 0.3, [](double) { return 0.7; });
  }
}

/// Every passage of the chord 2 cos r leaves a = exp(-alpha 2 cos r): r + t^2 a / (1 - r a), or with R for r.
TEST(Furnace, ShowsTheLawOfWhatAbsorbs) {
  for (const double absorption : {0.1, 1.0, 10.0}) {
    for (const bool fresnel : {false, true}) {
      for (const BodyShares shares : {BodyShares{0, 0, 1}, BodyShares{0, 0.2, 0.8}}) {
        expect_law({shares, fresnel, NoRoughness{}, false, absorption}, kChance, [&](double offset) {
          const double chord = 2 * std::sqrt(1 - offset * offset / (kIndex * kIndex));
          const double left = std::exp(-absorption * chord);
          const double r = fresnel ? mirror_share(offset) : shares.r, t = fresnel ? 1 - r : shares.t;
          return r + t * t * left / (1 - r * left);
        });
      }
    }
  }
}

/// Rough glass that absorbs mixes chords from nothing to many times the diameter, where scattered light is caught: no
/// formula, but never more than the furnace, and the less of it the more is absorbed.
TEST(Furnace, IsDimmedWhereRoughGlassAbsorbs) {
  for (const Roughness& roughness : {kFaces[1], kFaces[2]}) {
    for (const bool fresnel : {false, true}) {
      double before = 1;
      for (const double absorption : {0.01, 0.1, 1.0, 10.0}) {
        const Film film = rendered(furnace({{0, 0, 1}, fresnel, roughness, false, absorption}));
        double sum = 0;
        for (int y = 0; y < kSide; ++y) {
          for (int x = 0; x < kSide; ++x) {
            EXPECT_GE(film.radiance(x, y).r, 0);
            EXPECT_LE(film.radiance(x, y).r, 1 + 10 * kChance);
            sum += film.radiance(x, y).r / (kSide * kSide);
          }
        }
        EXPECT_LT(sum, before);
        before = sum;
      }
      EXPECT_LT(before, 0.4);  // the sky beside the ball, and mirrors
    }
  }
}

}  // namespace
}  // namespace vitrail
