// How many photons a second the light side emits, traces and stores, one thread.
#include <benchmark/benchmark.h>

#include "photon/trace.h"

namespace vitrail {
namespace {

Material material_of(Rgb diffuse, Rgb transmission, double ior, bool fresnel) {
  Material material;
  material.diffuse = diffuse;
  material.transmission = transmission;
  material.ior_by_band = {ior};
  material.ior_minus_one_by_band = {ior - 1};
  material.camera_ior = ior;
  material.fresnel = fresnel;
  return material;
}

// A ball of glass over a floor, under parallel light: the ball lens of the calibration scenes.
Scene ball_lens(bool fresnel) {
  Scene scene;
  scene.bands.push_back({"all", {1, 1, 1}, {}});
  scene.materials = {material_of({0.8, 0.8, 0.8}, {}, 1, false), material_of({}, {1, 1, 1}, 1.5, fresnel)};
  scene.objects = {{"floor", 0, 0, PlaneShape{{0, 0, 0}, {0, 1, 0}}}, {"ball", 1, 0, SphereShape{{0, 2, 0}, 1}}};
  scene.lights = {{"sun", DirectionalLight{{0, -1, 0}, {1, 1, 1}, 0}}};
  return scene;
}

// The same ball where every one of so many bands has an index of its own.
Scene ball_of_bands(std::int64_t count) {
  Scene scene = ball_lens(false);
  scene.bands.clear();
  for (Material& material : scene.materials) {
    const double ior = material.ior_by_band.front();
    material.ior_by_band.clear();
    material.ior_minus_one_by_band.clear();
    for (std::int64_t band = 0; band < count; ++band) {
      const double share = 1 / static_cast<double>(count),
                   own = ior + (ior > 1 ? 0.05 * share * static_cast<double>(band) : 0);
      material.ior_by_band.push_back(own);
      material.ior_minus_one_by_band.push_back(own - 1);
      if (&material == &scene.materials.front()) scene.bands.push_back({"band", {share, share, share}, {}});
    }
  }
  return scene;
}

void trace(benchmark::State& state, const Scene& scene, Strategy strategy) {
  const Intersector intersector(scene);
  const Targets targets = find_targets(scene, intersector);
  constexpr std::uint64_t kBlock = 8192;
  const std::vector<Chart> charts = make_charts(scene, targets, 1 << 20);
  const PhotonPass pass{{scene, intersector}, {targets.surroundings.center}};
  std::uint64_t block = 0;
  for (auto _ : state) {
    const Stream stream = stream_of(1, Purpose::kEmissionPosition);
    benchmark::DoNotOptimize(trace_photons(pass, charts[0], stream, (block++ % 128) * kBlock, kBlock, strategy));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kBlock));
}

void photons_through_ball(benchmark::State& state) { trace(state, ball_lens(false), Strategy::automatic); }
void photons_through_ball_with_fresnel(benchmark::State& state) { trace(state, ball_lens(true), Strategy::automatic); }
void photons_through_ball_one_by_one(benchmark::State& state) { trace(state, ball_lens(false), Strategy::tree); }
void photons_through_dispersive_ball(benchmark::State& state) {
  trace(state, ball_of_bands(state.range(0)), Strategy::automatic);
}
void photons_through_rough_ball(benchmark::State& state, const Roughness& roughness, Strategy strategy) {
  Scene scene = ball_lens(false);
  scene.materials[1].roughness = roughness;
  trace(state, scene, strategy);
}
// One of 8 x 8 balls with Fresnel's shares, from above: light goes on from ball to ball.
void photons_through_64_balls(benchmark::State& state, Strategy strategy) {
  Scene scene = ball_lens(true);
  for (int i = 1; i < 64; ++i)
    scene.objects.push_back({"ball", 1, 0, SphereShape{{2.1 * (i % 8), 2, 2.1 * (i / 8)}, 1}});
  trace(state, scene, strategy);
}
BENCHMARK_CAPTURE(photons_through_64_balls, automatic, Strategy::automatic);
BENCHMARK_CAPTURE(photons_through_64_balls, one_by_one, Strategy::tree);
BENCHMARK(photons_through_ball);
BENCHMARK_CAPTURE(photons_through_rough_ball, equation_8, Equation8{0.3}, Strategy::automatic);
BENCHMARK_CAPTURE(photons_through_rough_ball, ggx, Ggx{0.1}, Strategy::automatic);
BENCHMARK_CAPTURE(photons_through_rough_ball, equation_8_one_by_one, Equation8{0.3}, Strategy::tree);
BENCHMARK_CAPTURE(photons_through_rough_ball, ggx_one_by_one, Ggx{0.1}, Strategy::tree);
BENCHMARK(photons_through_ball_with_fresnel);
BENCHMARK(photons_through_ball_one_by_one);
BENCHMARK(photons_through_dispersive_ball)->Arg(4)->Arg(32)->Arg(140);

void sobol_points_2d(benchmark::State& state) {
  const Stream stream = stream_of(1, Purpose::kEmissionPosition);
  std::uint32_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(sobol_2d(stream, i++));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(sobol_points_2d);

}  // namespace
}  // namespace vitrail
