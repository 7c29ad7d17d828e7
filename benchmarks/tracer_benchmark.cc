// How fast the tracer is, piece by piece, on one thread: hits, photons, the map, gathering, and a whole small frame.
//
// Rates count what a user waits for: rays, photons emitted, photons sorted, queries answered, pixels. The scene of the
// light side is the lowered ball lens named by VITRAIL_BENCHMARK_SCENE; tools/bench.sh emits it.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <stdexcept>

#include "base/random.h"
#include "geometry/accel.h"
#include "photon/pass.h"
#include "render/render.h"
#include "scene/read.h"

namespace vitrail {
namespace {

Scene ball_lens() {
  const char* path = std::getenv("VITRAIL_BENCHMARK_SCENE");
  if (path == nullptr) throw std::runtime_error("VITRAIL_BENCHMARK_SCENE names no lowered scene; run `make bench`");
  return read_scene(path);
}

double unit(std::uint64_t index, std::uint32_t dimension) {
  return uniform(stream_of(1, Purpose::kPixel), index, dimension);
}

// Balls of radius 0.1 in a cube of edge 2, or a single one in the middle.
Scene balls(int count) {
  Scene scene;
  scene.bands.push_back({"all", {1, 1, 1}, {}});
  scene.materials.emplace_back().ior_by_band = {1};
  for (int i = 0; i < count; ++i) {
    const std::uint64_t index = static_cast<std::uint64_t>(i);
    const Vec3 center =
        count == 1 ? Vec3{} : Vec3{unit(index, 0) * 2 - 1, unit(index, 1) * 2 - 1, unit(index, 2) * 2 - 1};
    scene.objects.push_back({"ball", 0, 0, SphereShape{center, count == 1 ? 1.0 : 0.1}});
  }
  return scene;
}

// Rays from a sphere around the balls towards points inside, in no order: the incoherent case.
void closest_hit(benchmark::State& state) {
  const Scene scene = balls(static_cast<int>(state.range(0)));
  const Intersector intersector(scene, state.range(1) != 0 ? Search::embree : Search::list);
  std::vector<Ray> rays;
  for (std::uint64_t i = 0; i < 4096; ++i) {
    const Vec3 from = normalise({unit(i, 3) - 0.5, unit(i, 4) - 0.5, unit(i, 5) - 0.5}) * 4;
    const Vec3 to{unit(i, 6) - 0.5, unit(i, 7) - 0.5, unit(i, 8) - 0.5};
    rays.push_back({from, normalise(to - from)});
  }

  Hit hit;
  for (auto _ : state) {
    for (const Ray& ray : rays) benchmark::DoNotOptimize(intersector.closest(ray, {}, hit));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays.size()));
}
BENCHMARK(closest_hit)
    ->ArgNames({"balls", "embree"})
    ->Args({1, 0})
    ->Args({1, 1})
    ->Args({32, 0})
    ->Args({32, 1})
    ->Args({1000, 1});

// Emit, trace and store, then sort: the photon pass of the ball lens.
void photon_pass(benchmark::State& state) {
  Scene scene = ball_lens();
  scene.settings.photons = static_cast<std::uint64_t>(state.range(0));
  const Intersector intersector(scene);
  double trace_s = 0, sort_s = 0;
  std::uint64_t emitted = 0, stored = 0;
  for (auto _ : state) {
    SilentMonitor monitor;
    const PhotonMaps maps = make_photon_maps(scene, intersector, 1, monitor);
    trace_s += maps.statistics.trace_cpu_s;
    sort_s += maps.statistics.sort_cpu_s;
    emitted += maps.statistics.emitted;
    stored += maps.statistics.stored;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(emitted));
  state.counters["traced_per_cpu_s"] = static_cast<double>(emitted) / trace_s;
  state.counters["sorted_per_cpu_s"] = static_cast<double>(stored) / sort_s;
}
BENCHMARK(photon_pass)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

// Ask for the light on the floor, in the order of scan lines as the renderer does.
void gather(benchmark::State& state) {
  Scene scene = ball_lens();
  scene.settings.photons = 1'000'000;
  const Intersector intersector(scene);
  SilentMonitor monitor;
  const PhotonMaps maps = make_photon_maps(scene, intersector, 1, monitor);

  // Find the floor under each pixel of a square as wide as the shadow of the ball.
  const Bounds bounds = intersector.bounds();
  const Vec3 middle = (bounds.min + bounds.max) * 0.5;
  const double half = (bounds.max.x - bounds.min.x) / 2;
  std::vector<GatherQuery> queries;
  for (int j = 0; j < 128; ++j) {
    for (int i = 0; i < 128; ++i) {
      const Vec3 above{middle.x + half * (i / 64.0 - 1), bounds.min.y - half * 1e-3, middle.z + half * (j / 64.0 - 1)};
      Hit hit;
      if (intersector.closest({above, {0, -1, 0}}, {}, hit)) queries.push_back({hit.point, {0, 1, 0}});
    }
  }
  if (queries.empty()) state.SkipWithError("no floor under the ball");

  for (auto _ : state) {
    for (const GatherQuery& query : queries) benchmark::DoNotOptimize(maps.half[0]->irradiance(query));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(queries.size()));
}
BENCHMARK(gather)->Unit(benchmark::kMillisecond);

// A whole small picture of the ball lens, photons included.
void frame(benchmark::State& state) {
  Scene scene = ball_lens();
  scene.settings.photons = 100'000;
  for (auto _ : state) {
    SilentMonitor monitor;
    benchmark::DoNotOptimize(render(scene, 1, monitor));
  }
  state.SetItemsProcessed(state.iterations() * scene.image.width * scene.image.height);
}
BENCHMARK(frame)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace vitrail

BENCHMARK_MAIN();
