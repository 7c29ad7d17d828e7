/// What must not change a single bit of the image, and what its layers and halves must sum to.

#include <gtest/gtest.h>

#include "base/diagnostic.h"
#include "build_scene.h"
#include "render/render.h"

namespace vitrail {
namespace {

/// A glass ball and a mirror ball over a floor, a sun and a lamp; every length times `scale`, every power times
/// `power`.
Scene mixed_scene(double scale = 1, double power = 1) {
  SceneBuilder builder;
  builder.add("floor", PlaneShape{{0, 0, 0}, {0, 1, 0}}, builder.add(diffuse(0.8)));
  Material amber = glass(1.5, {0.9, 0.8, 0.5}, true);
  amber.absorption_per_m = Rgb{0.1, 0.2, 0.4} * (1 / scale);
  builder.add("ball", SphereShape{Vec3{-0.8, 1, 0} * scale, 0.7 * scale}, builder.add(amber));
  Material red = diffuse(0);
  red.reflection = {0.9, 0.1, 0.1};
  red.diffuse = Rgb{0.05, 0.05, 0.05};
  builder.add("red", SphereShape{Vec3{0.9, 0.8, 0.2} * scale, 0.6 * scale}, builder.add(red));
  builder.scene.lights.push_back({"sun", DirectionalLight{normalise({0.2, -1, 0.1}), Rgb{2, 2, 2} * power, 0}});
  builder.scene.lights.push_back({"lamp", PointLight{Vec3{0, 3, 1} * scale, Rgb{3, 4, 5} * (scale * scale * power)}});
  const Vec3 forward = normalise({0, -0.4, -1}), right{1, 0, 0};
  builder.scene.camera = {
      CameraKind::perspective, Vec3{0, 2.2, 3.5} * scale, forward, right, cross(right, forward), 0.6, 0.45};
  builder.scene.image = {40, 30};
  builder.scene.settings.samples = 4;
  builder.scene.settings.photons = 40000;
  builder.scene.settings.solver = Solver::photon_map;
  builder.scene.settings.gather_radius_m = 0.05 * scale;
  builder.scene.settings.seed = 3;
  return builder.scene;
}

Rendering rendered(const Scene& scene, unsigned threads = 1) {
  SilentMonitor monitor;
  return render(scene, {threads, monitor});
}

/// The number of pixels whose halves or layers differ, after multiplying the first image by `factor`.
int differing_pixels(const Film& a, const Film& b, double factor = 1) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      bool same = a.half(0, x, y) * factor == b.half(0, x, y) && a.half(1, x, y) * factor == b.half(1, x, y);
      for (int l = 0; l < kLayerCount; ++l) {
        const auto layer = static_cast<Layer>(l);
        same = same && a.layer(layer, x, y) * factor == b.layer(layer, x, y);
      }
      count += !same;
    }
  }
  return count;
}

TEST(Image, IsTheSameForAnyNumberOfThreads) {
  const Scene scene = mixed_scene();
  const Rendering one = rendered(scene, 1);
  EXPECT_GT(one.counters.photons_stored, 10000u);
  for (unsigned threads : {2u, 7u}) {
    const Rendering many = rendered(scene, threads);
    EXPECT_EQ(differing_pixels(one.film, many.film), 0) << threads << " threads";
    EXPECT_EQ(one.ledger.stored, many.ledger.stored);
    EXPECT_EQ(one.counters.camera_rays, many.counters.camera_rays);
  }
}

/// Lengths times 8 and light accordingly: no absolute epsilon hides anywhere [O part 2].
TEST(Image, IsTheSameAtEightTimesTheSize) {
  const Rendering small = rendered(mixed_scene(1)), large = rendered(mixed_scene(8));
  EXPECT_EQ(differing_pixels(small.film, large.film), 0);
  EXPECT_EQ(differing_pixels(small.film, rendered(mixed_scene(0x1p-20)).film), 0);
}

/// Light times 2^k: no absolute cut-off of brightness.
TEST(Image, FollowsTheLightExactly) {
  const Rendering plain = rendered(mixed_scene());
  EXPECT_EQ(differing_pixels(plain.film, rendered(mixed_scene(1, 0x1p20)).film, 0x1p20), 0);
  EXPECT_EQ(differing_pixels(plain.film, rendered(mixed_scene(1, 0x1p-60)).film, 0x1p-60), 0);
}

TEST(Image, DependsOnTheSeedOnly) {
  Scene scene = mixed_scene();
  const Rendering first = rendered(scene);
  EXPECT_EQ(differing_pixels(first.film, rendered(scene).film), 0);
  scene.settings.seed = 4;
  EXPECT_GT(differing_pixels(first.film, rendered(scene).film), 100);
}

/// The layers are the radiance taken apart, and the halves its two estimates.
TEST(Image, IsTheSumOfItsLayersAndTheMeanOfItsHalves) {
  const Film film = rendered(mixed_scene()).film;
  int seen[kLayerCount] = {};
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      Rgb sum;
      for (int l = 0; l < kLayerCount; ++l) {
        sum += film.layer(static_cast<Layer>(l), x, y);
        seen[l] += !is_black(film.layer(static_cast<Layer>(l), x, y));
      }
      const Rgb whole = film.radiance(x, y), a = film.half(0, x, y), b = film.half(1, x, y);
      for (int c = 0; c < 3; ++c) {
        // Each part was rounded to float when either half was added.
        EXPECT_NEAR(sum[c], whole[c], 2 * 0x1p-23 * whole[c]);
        EXPECT_EQ((a[c] + b[c]) / 2, whole[c]);
      }
    }
  }
  for (const Layer layer : {Layer::diffusion, Layer::reflection, Layer::refraction, Layer::caustic}) {
    EXPECT_GT(seen[static_cast<int>(layer)], 10) << name_of(layer);
  }
  EXPECT_EQ(seen[static_cast<int>(Layer::indirect_light)], 0);
}

/// The mixed scene with one sample per pixel, and nothing to draw lots for but weak branches.
Scene scene_of_one_sample() {
  Scene scene = mixed_scene();
  scene.settings.samples = 1;
  scene.plan.caustic = scene.plan.roughness = false;
  return scene;
}

/// One sample per pixel serves both halves where every way is followed; without photons they are then the same.
TEST(Image, WithOneSampleHasEqualHalvesBesidesPhotons) {
  Scene scene = scene_of_one_sample();
  scene.settings.branch_share = 0;
  const Film film = rendered(scene).film;
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) EXPECT_EQ(film.half(0, x, y), film.half(1, x, y));
  }
}

/// Whether a pixel shows nothing but what its first surface scatters: light divides nowhere on the way.
bool is_undivided(const Film& film, int x, int y) {
  return is_black(film.layer(Layer::reflection, x, y)) && is_black(film.layer(Layer::refraction, x, y)) &&
         is_black(film.layer(Layer::total_internal_reflection, x, y));
}

/// A look with weak branches is made for each half, or the noise of its chance would not show; others serve both.
TEST(Image, WithOneSampleHasTwoHalvesWhereWeakBranchesAre) {
  const Film film = rendered(scene_of_one_sample()).film;
  int undivided = 0, different = 0;
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      const bool same = film.half(0, x, y) == film.half(1, x, y);
      different += !same;
      if (!is_undivided(film, x, y)) continue;
      ++undivided;
      EXPECT_TRUE(same) << x << ", " << y;
    }
  }
  EXPECT_GT(undivided, 100);
  EXPECT_GT(different, 20);
}

/// Where lots are drawn, each half draws its own, or the noise of one sample would not show.
TEST(Image, WithOneSampleOfALargeLampHasTwoHalves) {
  Scene scene = mixed_scene();
  scene.settings.samples = 1;
  scene.lights.push_back({"lamp", AreaLight{DiscShape{{0, 6, 0}, {0, -1, 0}, 2}, false, {1, 1, 1}, {}}});
  scene.plan.caustic = false;
  const Film film = rendered(scene).film;
  int different = 0;
  for (int x = 0; x < film.width(); ++x) different += film.half(0, x, 25).r != film.half(1, x, 25).r;
  EXPECT_GT(different, film.width() / 2);
}

TEST(Image, OfNoObjectsIsBlack) {
  Scene scene = mixed_scene();
  scene.objects.clear();
  EXPECT_EQ(rendered(scene).film.radiance(20, 15), (Rgb{}));
}

TEST(Image, WithoutPhotonsIsDirectLightOnly) {
  Scene scene = mixed_scene();
  const Film with = rendered(scene).film;
  scene.settings.photons = 0;
  const Film without = rendered(scene).film;
  for (int x = 0; x < 40; ++x) {
    EXPECT_EQ(without.layer(Layer::caustic, x, 25), (Rgb{}));
    EXPECT_EQ(without.layer(Layer::diffusion, x, 25), with.layer(Layer::diffusion, x, 25));
  }
}

/// Stops after a number of units of work, as Ctrl-C does.
class StopAfter : public SilentMonitor {
 public:
  explicit StopAfter(int units) : left_(units) {}
  void begin(const std::string& phase, std::uint64_t) override { camera_ = phase == "camera"; }
  void advance(std::uint64_t) override { left_ -= camera_; }
  bool interrupted() const override { return left_ <= 0; }

 private:
  bool camera_ = false;
  int left_;
};

TEST(Image, KeepsFinishedTilesWhenInterrupted) {
  const Scene scene = mixed_scene();
  StopAfter monitor(1);
  const Rendering cut = render(scene, {1, monitor});
  EXPECT_TRUE(cut.interrupted);
  const Film whole = rendered(scene).film;
  EXPECT_EQ(cut.film.radiance(5, 20), whole.radiance(5, 20));  // first tile
  EXPECT_EQ(cut.film.radiance(35, 20), (Rgb{}));               // second tile
}

TEST(Settings, ThatNeedTooMuchMemoryAreRefusedBeforeTheyTakeIt) {
  Scene scene = mixed_scene();
  scene.settings.photons = 2000000000;
  scene.settings.memory_limit_mb = 1000;
  EXPECT_THROW(rendered(scene), InputError);
  scene.settings.memory_limit_mb = 4;
  scene.settings.photons = 1000;
  EXPECT_NO_THROW(rendered(scene));
}

TEST(Settings, WithoutAGatherRadiusAreRefusedForACaustic) {
  Scene scene = mixed_scene();
  scene.settings.gather_radius_m = 0;
  EXPECT_THROW(rendered(scene), InputError);
  scene.plan.caustic = false;
  EXPECT_NO_THROW(rendered(scene));
}

}  // namespace
}  // namespace vitrail
