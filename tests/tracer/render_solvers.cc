/// The three solvers of caustics: discs around what is seen, the pixels that see, and beams between rays.

#include <gtest/gtest.h>

#include "base/diagnostic.h"
#include "build_scene.h"
#include "render/light_bins.h"
#include "render/render.h"

namespace vitrail {
namespace {

Rendering rendered(const Scene& scene, unsigned threads = 1) {
  SilentMonitor monitor;
  return render(scene, {threads, monitor});
}

/// Caustics seen directly, in a mirror and through glass.
Scene mixed_scene() {
  SceneBuilder builder;
  builder.add("floor", RectangleShape{{0, 0, 0}, {3, 0, 0}, {0, 0, -3}}, builder.add(diffuse(0.8)));
  builder.add("ball", SphereShape{{0, 1, 0}, 0.7}, builder.add(glass(1.5, {1, 0.8, 0.5}, true)));
  Material mirror = diffuse(0.1);
  mirror.reflection = {0.8, 0.8, 0.8};
  builder.add("mirror", RectangleShape{{0, 1, -2}, {2, 0, 0}, {0, 1, 0}}, builder.add(mirror));
  builder.scene.lights.push_back({"lamp", PointLight{{1, 4, 1}, {10, 10, 10}}});
  const Vec3 forward = normalise({0, -0.5, -1}), right{1, 0, 0};
  builder.scene.camera = {CameraKind::perspective, {0, 3, 4}, forward, right, cross(right, forward), 0.5, 0.5};
  builder.scene.image = {32, 32};
  builder.scene.settings.photons = 60000;
  builder.scene.settings.solver = Solver::photon_map;
  builder.scene.settings.gather_radius_m = 0.02;
  builder.scene.settings.samples = 64;
  return builder.scene;
}

Rgb mean_caustic(const Film& film) {
  Rgb sum;
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) sum += film.layer(Layer::caustic, x, y);
  }
  return sum * (1.0 / 1024);
}

/// All solvers see the same light on the same surfaces, directly, in a mirror and through glass; each is the same to
/// the bit on any number of threads.
TEST(Solvers, AgreeInAMixedScene) {
  Scene scene = mixed_scene();
  const Rgb by_map = mean_caustic(rendered(scene, 2).film);
  for (const Solver solver : {Solver::light_bins, Solver::beams}) {
    scene.settings.solver = solver;
    const Film film = rendered(scene, 2).film;
    // The means of whole images: discs lose a little at the edges of surfaces, pixel samples of peaks are noisy.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean_caustic(film)[c] / by_map[c], 1, 0.02) << name_of(solver);
    const Film seven = rendered(scene, 7).film;
    for (int x = 0; x < 32; ++x) EXPECT_EQ(film.radiance(x, 16), seven.radiance(x, 16)) << name_of(solver);
  }
}

/// A lamp with an area has no single ray at a place: its light comes as photons, beside the beams of the other lamp.
TEST(Beams, LeaveToPhotonsWhatTheyCannotDo) {
  Scene scene = mixed_scene();
  scene.lights.push_back(
      {"panel", AreaLight{RectangleShape{{-1, 4, 1}, {0.3, 0, 0}, {0, 0, 0.3}}, false, {30, 30, 30}, {}}});
  const Rgb by_map = mean_caustic(rendered(scene, 2).film);
  scene.settings.solver = Solver::beams;
  const Rgb by_beams = mean_caustic(rendered(scene, 2).film);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(by_beams[c] / by_map[c], 1, 0.02);
}

/// `auto` takes beams where some light sends one ray alone from each place, with a tenth of the photons as rays.
TEST(Solver, AutoTakesBeamsWhereLightHasNoExtent) {
  Scene scene = mixed_scene();
  scene.settings.solver = Solver::automatic;
  scene.plan.roughness = false;
  EXPECT_EQ(scene.solver(), Solver::beams);
  const Rendering chosen = rendered(scene);
  EXPECT_LT(chosen.counters.photons_emitted, scene.settings.photons);
  scene.settings.solver = Solver::light_bins;
  const Rgb by_bins = mean_caustic(rendered(scene).film), by_choice = mean_caustic(chosen.film);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(by_choice[c] / by_bins[c], 1, 0.02);
  scene.settings.solver = Solver::automatic;
  scene.plan.roughness = true;
  EXPECT_NE(scene.solver(), Solver::beams) << "a rough face sends rays everywhere";
}

/// Light from a lamp with an area is counted in pixels from 4 photons a pixel on, to the bit as by that solver.
TEST(Solver, AutoTakesBinsWherePhotonsAreMany) {
  Scene scene = mixed_scene();
  scene.lights = {{"panel", AreaLight{RectangleShape{{-1, 4, 1}, {0.3, 0, 0}, {0, 0, 0.3}}, false, {30, 30, 30}, {}}}};
  scene.image = {16, 16};
  scene.settings.samples = 1;
  for (const std::uint64_t photons : {1022, 1024}) {
    scene.settings.photons = photons;
    const bool many = photons >= 4 * 16 * 16;
    scene.settings.solver = many ? Solver::light_bins : Solver::photon_map;
    const Film named = rendered(scene).film;
    scene.settings.solver = Solver::automatic;
    const Film chosen = rendered(scene).film;
    EXPECT_EQ(scene.solver(), many ? Solver::light_bins : Solver::photon_map);
    for (int x = 0; x < 16; ++x) EXPECT_EQ(named.radiance(x, 8), chosen.radiance(x, 8)) << photons;
  }
}

}  // namespace
}  // namespace vitrail
