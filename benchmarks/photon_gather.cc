// How fast the photon map is built and asked, one thread: 1e6 photons, half of them concentrated in a ring.
#include <benchmark/benchmark.h>

#include <cmath>

#include "base/random.h"
#include "photon/photon_map.h"

namespace vitrail {
namespace {

constexpr std::size_t kPhotons = 1000000;

std::vector<std::vector<PhotonRecord>> photons() {
  std::vector<std::vector<PhotonRecord>> blocks(kPhotons / 8192 + 1);
  const Stream stream = stream_of(1, Purpose::kEmissionPosition);
  for (std::uint32_t i = 0; i < kPhotons; ++i) {
    const auto [a, b] = sobol_2d(stream, i);
    Vec3 at{4 * a - 2, 0, 4 * b - 2};
    if (i % 2 == 0) at = Vec3{std::cos(2 * M_PI * a), 0, std::sin(2 * M_PI * a)} * (0.6 + 0.3 * b * b);
    blocks[i / 8192].push_back(make_photon({}, at, {0, 1, 0}, {1e-6, 1e-6, 1e-6}));
  }
  return blocks;
}

// The radius that finds so many photons where they are spread evenly over the 4 x 4 square.
double radius_for(double mean) { return std::sqrt(mean * 16 / (M_PI * kPhotons)); }

void build_grid(benchmark::State& state) {
  const auto blocks = photons();
  for (auto _ : state) {
    state.PauseTiming();
    auto copy = blocks;
    state.ResumeTiming();
    benchmark::DoNotOptimize(PhotonMap({}, std::move(copy), radius_for(60)).size());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kPhotons));
}
BENCHMARK(build_grid)->Unit(benchmark::kMillisecond);

// Queries along scan lines of a 600 x 600 image, as the camera makes them.
void gather(benchmark::State& state) {
  const PhotonMap map({}, photons(), radius_for(static_cast<double>(state.range(0))));
  constexpr int kSide = 600;
  int pixel = 0;
  for (auto _ : state) {
    const double x = -1.9 + 3.8 * (pixel % kSide) / kSide, z = -1.9 + 3.8 * (pixel / kSide) / kSide;
    benchmark::DoNotOptimize(map.irradiance({{x, 0, z}, {0, 1, 0}}));
    pixel = (pixel + 1) % (kSide * kSide);
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(gather)->Arg(10)->Arg(60)->Arg(600);

}  // namespace
}  // namespace vitrail
