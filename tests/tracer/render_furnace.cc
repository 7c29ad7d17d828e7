/// The white furnace: a ball of every combination of material under a sky of radiance 1. Nothing may make light; what
/// loses none cannot be seen, and what absorbs shows its law.

#include <gtest/gtest.h>

#include <functional>

#include "build_scene.h"
#include "render/render.h"

namespace vitrail {
namespace {

constexpr double kIndex = 1.5;

struct Shares {
  double d, r, t;
};

struct Body {
  Shares shares;
  bool fresnel;
  Roughness roughness;
  bool disperses;
  double absorption_per_m = 0;
};

std::string name_of(const Body& body) {
  const char* rough[] = {"smooth", "equation 8", "GGX"};
  return "d " + std::to_string(body.shares.d) + " r " + std::to_string(body.shares.r) + " t " +
         std::to_string(body.shares.t) + (body.fresnel ? ", Fresnel, " : ", ") + rough[body.roughness.index()] +
         (body.disperses ? ", dispersive" : "");
}

constexpr int kSide = 6;
constexpr double kHalf = 0.95;  // of the image; the ball has radius 1

/// The ball alone under the sky, seen so that every pixel's centre meets it.
Scene furnace(const Body& body) {
  SceneBuilder builder;
  Material material = glass(kIndex, Rgb{1, 1, 1} * body.shares.t, body.fresnel);
  material.reflection = Rgb{1, 1, 1} * body.shares.r;
  material.diffuse = Rgb{1, 1, 1} * body.shares.d;
  material.roughness = body.roughness;
  material.absorption_per_m = Rgb{1, 1, 1} * body.absorption_per_m;
  if (body.disperses) {
    builder.scene.bands = {
        {"red", {0.5, 0, 0}, {}}, {"yellow", {0.5, 0.5, 0}, {}}, {"green", {0, 0.5, 0}, {}}, {"blue", {0, 0, 1}, {}}};
    material.ior_by_band = {1.5, 1.532, 1.564, 1.596};
    material.ior_minus_one_by_band = {0.5, 0.532, 0.564, 0.596};
  }
  builder.add("body", SphereShape{{0, 0, 0}, 1}, builder.add(material));
  builder.scene.lights.push_back({"sky", EnvironmentLight{{1, 1, 1}, "", nullptr}});
  builder.scene.camera = {CameraKind::orthographic, {0, 0, 5}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, kHalf, kHalf};
  builder.scene.image = {kSide, kSide};
  builder.scene.plan.caustic = false;
  builder.scene.transport.max_reflections = builder.scene.transport.max_transmissions = 1000;
  return builder.scene;
}

/// How far from the ball's axis the centre of a pixel meets it; more than 1 if it does not.
double offset_of(int x, int y) {
  return std::hypot(kHalf * (2 * (x + 0.5) / kSide - 1), kHalf * (2 * (y + 0.5) / kSide - 1));
}

Film rendered(const Scene& scene) {
  SilentMonitor monitor;
  return render(scene, 2, monitor).film;
}

/// Every pixel against a law of the offset, in all channels; sky pixels show the sky. `slack` upwards is rounding.
void expect_law(const Body& body, double tolerance, const std::function<double(double)>& law) {
  const Film film = rendered(furnace(body));
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double offset = offset_of(x, y), truth = offset < 1 ? law(offset) : 1;
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(film.radiance(x, y)[c], truth, tolerance) << name_of(body) << " at " << offset;
        EXPECT_LE(film.radiance(x, y)[c], 1 + 1e-12) << name_of(body) << " at " << offset;
      }
    }
  }
}

const Roughness kFaces[] = {NoRoughness{}, Equation8{0.5}, Ggx{0.3}};

/// Branches below 1e-6 of a look are cut; in a ball some dozens of them.
constexpr double kCut = 3e-5;

/// Fresnel's share of the mirror at the ball's outside.
double mirror_share(double offset) {
  const double cos_in = std::sqrt(1 - offset * offset);
  const double cos_out = std::sqrt(1 - offset * offset / (kIndex * kIndex));
  const double s = (cos_in - kIndex * cos_out) / (cos_in + kIndex * cos_out);
  const double p = (kIndex * cos_in - cos_out) / (kIndex * cos_in + cos_out);
  return 0.5 * (s * s + p * p);
}

TEST(Furnace, HidesWhatMirrorsAndTransmitsEverything) {
  for (const Shares shares : {Shares{0, 0, 1}, Shares{0, 0.3, 0.7}, Shares{0, 1, 0}}) {
    for (const bool fresnel : {false, true}) {
      if (fresnel && shares.t == 0) continue;  // an opaque mirror absorbs what it does not mirror: below
      for (const Roughness& roughness : kFaces) {
        for (const bool disperses : {false, true}) {
          expect_law({shares, fresnel, roughness, disperses}, kCut, [](double) { return 1.0; });
        }
      }
    }
  }
}

/// A convex body that is not of glass scatters the sky: d of it, and the share of its mirror on top.
TEST(Furnace, ShowsTheAlbedoOfWhatIsOpaque) {
  for (const Shares shares : {Shares{1, 0, 0}, Shares{0.4, 0.6, 0}, Shares{0.3, 0.2, 0}}) {
    for (const Roughness& roughness : kFaces) {
      expect_law({shares, false, roughness, false}, 1e-12, [&](double) { return shares.d + shares.r; });
    }
    expect_law({shares, true, NoRoughness{}, false}, 1e-12,
               [&](double offset) { return shares.d + shares.r * mirror_share(offset); });
  }
  // A rough mirror with Fresnel has no such formula: some microfacet of the lobe, from R(0) = .04 to 1.
  for (const Roughness& roughness : {kFaces[1], kFaces[2]}) {
    expect_law({{0.4, 0.6, 0}, true, roughness, false}, 0.29, [](double) { return 0.4 + 0.6 * 0.52; });
  }
}

/// Every passage of the chord 2 cos r leaves a = exp(-alpha 2 cos r): r + t^2 a / (1 - r a), or with R for r.
TEST(Furnace, ShowsTheLawOfWhatAbsorbs) {
  for (const double absorption : {0.1, 1.0, 10.0}) {
    for (const bool fresnel : {false, true}) {
      for (const Shares shares : {Shares{0, 0, 1}, Shares{0, 0.2, 0.8}}) {
        expect_law({shares, fresnel, NoRoughness{}, false, absorption}, kCut, [&](double offset) {
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
            EXPECT_LE(film.radiance(x, y).r, 1 + 1e-12);
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

/// Mean over the ball where light is scattered inside it too: photons bring what the camera cannot follow.
double mean_with_photons(const Body& body) {
  Scene scene = furnace(body);
  scene.plan.caustic = true;
  scene.transport.indirect = Indirect::photons;
  scene.transport.max_reflections = scene.transport.max_transmissions = 64;
  scene.settings.photons = 100000;
  scene.settings.gather_radius_m = 0.05;
  scene.settings.seed = 1;
  const Film film = rendered(scene);
  double sum = 0, count = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      if (offset_of(x, y) > 0.75) continue;
      sum += film.radiance(x, y).r;
      ++count;
    }
  }
  return sum / count;
}

/// One part in fifty: 1 % of photon noise, and 0.3 % from flat discs of 0.2 m on a ball. GGX darkens by another 2.5 %:
/// microfacets that hide one another are met by photons and camera in different shares, so that light inside is not
/// even [O 1.3 says the same of equation 8, where it stays below the noise].
void expect_hidden(const Body& body) {
  const double found = mean_with_photons(body), darkens = std::holds_alternative<Ggx>(body.roughness) ? 0.025 : 0;
  EXPECT_GT(found, 1 - 0.02 - darkens) << name_of(body);
  EXPECT_LT(found, 1 + 0.02) << name_of(body);
}

TEST(Furnace, HidesGlassThatAlsoScatters) {
  for (const Roughness& roughness : kFaces) {
    expect_hidden({{0.5, 0, 0.5}, false, roughness, false});
    expect_hidden({{0.5, 0, 0.5}, true, roughness, false});
    expect_hidden({{0.5, 0, 0.5}, true, roughness, true});
  }
  expect_hidden({{0.2, 0.3, 0.5}, false, NoRoughness{}, false});
}

}  // namespace
}  // namespace vitrail
