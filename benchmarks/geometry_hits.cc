// How fast one ray finds its nearest hit, on one thread: spheres, rays in no order, by list and by Embree.
#include <benchmark/benchmark.h>

#include "base/random.h"
#include "geometry/accel.h"

namespace vitrail {
namespace {

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
    ->Args({4, 0})
    ->Args({4, 1})
    ->Args({8, 0})
    ->Args({8, 1})
    ->Args({16, 0})
    ->Args({16, 1})
    ->Args({32, 0})
    ->Args({32, 1})
    ->Args({1000, 1});

}  // namespace
}  // namespace vitrail
