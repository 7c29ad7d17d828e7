/// Several pictures of one run: views are made from the photons of the scene's picture, and change nothing in it.

#include <gtest/gtest.h>

#include "base/diagnostic.h"
#include "build_scene.h"
#include "render/render.h"

namespace vitrail {
namespace {

Rendering rendered(const Scene& scene, unsigned threads = 1) {
  SilentMonitor monitor;
  return render(scene, {threads, monitor});
}

/// A glass ball over a floor, with light that is random in every way that a picture may be: an area lamp, indirect
/// photons and caustics.
Scene ball_scene(Solver solver) {
  SceneBuilder builder;
  builder.add("floor", RectangleShape{{0, 0, 0}, {3, 0, 0}, {0, 0, -3}}, builder.add(diffuse(0.8)));
  builder.add("ball", SphereShape{{0, 1, 0}, 0.7}, builder.add(glass(1.5, {1, 0.8, 0.5}, true)));
  builder.scene.lights.push_back({"lamp", PointLight{{1, 4, 1}, {10, 10, 10}}});
  builder.scene.lights.push_back(
      {"panel", AreaLight{RectangleShape{{-1, 4, 1}, {0.3, 0, 0}, {0, 0, 0.3}}, false, {30, 30, 30}, {}}});
  const Vec3 forward = normalise({0, -0.5, -1}), right{1, 0, 0};
  builder.scene.camera = {CameraKind::perspective, {0, 3, 4}, forward, right, cross(right, forward), 0.5, 0.5};
  builder.scene.image = {40, 36};
  builder.scene.transport.indirect = Indirect::photons;
  builder.scene.settings.photons = 4000;
  builder.scene.settings.gather_radius_m = 0.05;
  builder.scene.settings.samples = 3;
  builder.scene.settings.solver = solver;
  return builder.scene;
}

/// The floor beside the ball from straight above, in a picture of other size and samples.
Picture from_above() {
  return {"above", {8, 6}, {CameraKind::orthographic, {0.5, 5, 0.5}, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}, 0.4, 0.3}, 16};
}

Picture named(const std::string& name, Picture picture) {
  picture.view = name;
  return picture;
}

int differing_pixels(const Film& a, const Film& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      bool same = a.half(0, x, y) == b.half(0, x, y) && a.half(1, x, y) == b.half(1, x, y);
      for (int l = 0; l < kLayerCount; ++l) {
        same = same && a.layer(static_cast<Layer>(l), x, y) == b.layer(static_cast<Layer>(l), x, y);
      }
      count += !same;
    }
  }
  return count;
}

class Views : public testing::TestWithParam<Solver> {};
INSTANTIATE_TEST_SUITE_P(Solvers, Views, testing::Values(Solver::photon_map, Solver::light_bins, Solver::beams),
                         [](const auto& one) { return name_of(one.param); });

TEST_P(Views, LeaveThePictureAsItIs) {
  Scene scene = ball_scene(GetParam());
  const Rendering alone = rendered(scene);
  scene.views = {from_above(), named("beside", from_above())};
  for (const unsigned threads : {1u, 7u}) {
    const Rendering with = rendered(scene, threads);
    EXPECT_EQ(differing_pixels(with.film, alone.film), 0);
    ASSERT_EQ(with.views.size(), 2u);
    EXPECT_EQ(differing_pixels(with.views[0].film, with.views[1].film), 0);
  }
}

/// A view through the scene's own camera is the picture, and a scene whose camera is that of a view shows the view.
TEST_P(Views, AreThePicturesOfTheirCameras) {
  Scene scene = ball_scene(GetParam());
  scene.views = {from_above(), named("same", scene.picture())};
  const Rendering all = rendered(scene, 2);
  EXPECT_EQ(differing_pixels(all.views[1].film, all.film), 0);

  // Indirect photons are aimed at all that is there, the scene's camera too.
  scene.transport.indirect = Indirect::none;
  const Rendering viewed = rendered(scene);
  const Film& seen = viewed.views[0].film;
  Scene other = scene;
  other.image = from_above().image;
  other.camera = from_above().camera;
  other.settings.samples = from_above().samples;
  other.views.clear();
  EXPECT_EQ(differing_pixels(seen, rendered(other).film), 0);
  Rgb caustic;
  for (int x = 0; x < 8; ++x) caustic += seen.layer(Layer::caustic, x, 3);
  EXPECT_GT(caustic.g, 0);
}

TEST_P(Views, ShareThePhotonsAndCountTheirOwnRays) {
  Scene scene = ball_scene(GetParam());
  const Rendering alone = rendered(scene);
  scene.views = {from_above(), named("same", scene.picture())};
  const Rendering all = rendered(scene);
  EXPECT_EQ(all.counters.photons_emitted, alone.counters.photons_emitted);
  EXPECT_EQ(all.counters.photons_stored, alone.counters.photons_stored);
  EXPECT_EQ(all.ledger.stored, alone.ledger.stored);
  EXPECT_EQ(all.views[0].name, "above");
  EXPECT_GE(all.views[0].camera_rays, 8u * 6 * 16);
  EXPECT_EQ(all.views[1].camera_rays, alone.counters.camera_rays);
  EXPECT_EQ(all.counters.camera_rays, 2 * alone.counters.camera_rays + all.views[0].camera_rays);
}

/// Hears how many units a phase has and how many of them were done.
class Listener : public SilentMonitor {
 public:
  void begin(const std::string& phase, std::uint64_t total) override {
    if (phase != "camera" && phase != "light_bins") return;
    EXPECT_EQ(left_, 0u);
    ++phases_;
    left_ = total;
  }
  void advance(std::uint64_t units) override { left_ -= phases_ > 0 ? units : 0; }
  std::uint64_t phases_ = 0, left_ = 0;
};

TEST_P(Views, AreUnitsOfTheSamePhases) {
  Scene scene = ball_scene(GetParam());
  scene.views = {from_above(), named("same", scene.picture())};
  Listener monitor;
  render(scene, {1, monitor});
  EXPECT_EQ(monitor.phases_, GetParam() == Solver::photon_map ? 1u : 2u);
  EXPECT_EQ(monitor.left_, 0u);
}

TEST(ViewsMemory, IsPredicted) {
  Scene scene = ball_scene(Solver::photon_map);
  const Intersector intersector(scene);
  const std::uint64_t alone = predicted_bytes({scene, intersector});
  scene.views = {named("same", scene.picture())};
  EXPECT_EQ(predicted_bytes({scene, intersector}) - alone, Film::predicted_bytes(40, 36, kLayerCount));
}

}  // namespace
}  // namespace vitrail
