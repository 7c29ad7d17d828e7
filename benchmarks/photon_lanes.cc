// How fast the loops over many photons are, one thread, rays per second: what they meet, and how glass bends them.
#include <benchmark/benchmark.h>

#include <memory>

#include "base/random.h"
#include "photon/wave/dielectric_lanes.h"
#include "photon/wave/small_scene_intersector.h"

namespace vitrail {
namespace {

double unit(std::uint64_t index, std::uint32_t dimension) {
  return uniform(stream_of(1, Purpose::kPixel), index, dimension);
}

Vec3 direction(std::uint64_t index, std::uint32_t dimension) {
  return normalise({unit(index, dimension) - 0.5, unit(index, dimension + 1) - 0.5, unit(index, dimension + 2) - 0.5});
}

// Rays from around the origin in all directions, none of which has departed from anything.
void find_hits(benchmark::State& state, const Shape& shape) {
  Scene scene;
  scene.objects = {{"object", 0, 0, shape}};
  const SmallSceneIntersector objects(scene);
  PathStates photons;
  for (std::uint64_t i = 0; i < RayChunk::kCapacity; ++i) {
    photons.add({unit(i, 3), unit(i, 4), unit(i, 5)}, direction(i, 0), {1, 1, 1}, 0, {}, {});
  }
  const auto rays = std::make_unique<RayChunk>();
  rays->count = RayChunk::kCapacity;
  for (int a = 0; a < 3; ++a) {
    rays->origin[a] = photons.origin(a);
    rays->direction[a] = photons.direction(a);
  }
  rays->departed = photons.departed();
  rays->states = photons.states();

  for (auto _ : state) {
    objects.find(*rays);
    benchmark::DoNotOptimize(rays->nearest.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * RayChunk::kCapacity);
}
BENCHMARK_CAPTURE(find_hits, sphere, SphereShape{{2, 0, 0}, 1});
BENCHMARK_CAPTURE(find_hits, plane, PlaneShape{{0, -1, 0}, {0, 1, 0}});
BENCHMARK_CAPTURE(find_hits, rectangle, RectangleShape{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}});
BENCHMARK_CAPTURE(find_hits, disc, DiscShape{{0, -1, 0}, {0, 1, 0}, 1});

// Rays on faces of glass, from inside and from outside.
std::unique_ptr<DielectricLanes> rays_at_faces() {
  auto lanes = std::make_unique<DielectricLanes>();
  lanes->count = DielectricLanes::kCapacity;
  for (std::size_t i = 0; i < lanes->count; ++i) {
    const Vec3 ray = direction(i, 0), outward = direction(i, 3), normal = dot(ray, outward) > 0 ? -outward : outward;
    for (int a = 0; a < 3; ++a) {
      lanes->direction[a][i] = ray[a];
      lanes->normal[a][i] = normal[a];
    }
    lanes->ior_from[i] = i % 2 == 0 ? 1 : 1.5;
    lanes->ior_to[i] = i % 2 == 0 ? 1.5 : 1;
    lanes->ior_step[i] = lanes->ior_to[i] - lanes->ior_from[i];
  }
  return lanes;
}

void at_faces(benchmark::State& state, void (*kernel)(DielectricLanes&)) {
  const auto lanes = rays_at_faces();
  refract(*lanes);
  for (auto _ : state) {
    kernel(*lanes);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * DielectricLanes::kCapacity);
}
BENCHMARK_CAPTURE(at_faces, reflect, reflect);
BENCHMARK_CAPTURE(at_faces, refract, refract);
BENCHMARK_CAPTURE(at_faces, find_fresnel_shares, find_fresnel_shares);

// Points near a sphere are brought onto it.
void settle(benchmark::State& state) {
  Scene scene;
  scene.objects = {{"ball", 0, 0, SphereShape{{0, 0, 0}, 1}}};
  const SmallSceneIntersector objects(scene);
  auto lanes = std::make_unique<SurfaceLanes>();
  const std::array<std::int32_t, SurfaceLanes::kCapacity> faces{};
  for (std::size_t i = 0; i < SurfaceLanes::kCapacity; ++i) {
    for (int a = 0; a < 3; ++a) lanes->point[a][i] = direction(i, 0)[a];
  }
  for (auto _ : state) {
    objects.settle(0, faces.data(), SurfaceLanes::kCapacity, *lanes);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * SurfaceLanes::kCapacity);
}
BENCHMARK(settle);

}  // namespace
}  // namespace vitrail
