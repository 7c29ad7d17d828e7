// How fast a whole small picture of the ball lens is, photons included, on one thread.
//
// The rate counts pixels. VITRAIL_BENCHMARK_SCENE names the lowered ball lens; tools/bench.sh emits it.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <stdexcept>

#include "render/render.h"
#include "scene/read.h"

namespace vitrail {
namespace {

Scene ball_lens() {
  const char* path = std::getenv("VITRAIL_BENCHMARK_SCENE");
  if (path == nullptr) throw std::runtime_error("VITRAIL_BENCHMARK_SCENE names no lowered scene; run `make bench`");
  return read_scene(path);
}

void frame(benchmark::State& state) {
  Scene scene = ball_lens();
  scene.settings.photons = 100'000;
  for (auto _ : state) {
    SilentMonitor monitor;
    benchmark::DoNotOptimize(render(scene, {1, monitor}));
  }
  state.SetItemsProcessed(state.iterations() * scene.image.width * scene.image.height);
}
BENCHMARK(frame)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace vitrail
