/// Rough faces for many rays: the same bits on every instruction set, and the formulas of optics.

#include <cmath>
#include <memory>

#include "build_scene.h"
#include "each_instruction_set.h"
#include "optics/microsurface.h"
#include "optics/roughness.h"
#include "photon/wave/rough_lanes.h"

namespace vitrail {
namespace {

constexpr std::size_t kCount = DielectricLanes::kCapacity;
// Each way rounds some ten steps of its own, on numbers below about 10.
constexpr double kRounding = 1e-14;

Vec3 at(const std::array<DielectricLanes::Column, 3>& columns, std::size_t i) {
  return {columns[0][i], columns[1][i], columns[2][i]};
}

void put(Vec3 v, std::array<DielectricLanes::Column, 3>& columns, std::size_t i) {
  for (int a = 0; a < 3; ++a) columns[a][i] = v[a];
}

// Rays at faces, from right above to grazing, with their random numbers.
struct RaysAtRoughFaces {
  std::unique_ptr<DielectricLanes> lanes = std::make_unique<DielectricLanes>();
  std::unique_ptr<RoughSamples> samples = std::make_unique<RoughSamples>();

  RaysAtRoughFaces() {
    TestNumbers numbers;
    lanes->count = kCount;
    for (std::size_t i = 0; i < kCount; ++i) {
      const Vec3 normal = i % 8 == 0 ? Vec3{0, 0, 1} : numbers.direction();
      const Vec3 ray = i % 16 == 0 ? Vec3{0, 0, -1} : numbers.direction();
      put(normal, lanes->normal, i);
      put(dot(ray, normal) > 0 ? -ray : ray, lanes->direction, i);
      lanes->ior_from[i] = 1;
      lanes->ior_to[i] = 1.5;
      lanes->ior_step[i] = 0.5;
      for (auto& u : samples->u) u[i] = numbers.between(1e-6, 1);
      samples->keep[i] = numbers.unit();
    }
  }
  std::array<double, 3> u(std::size_t i) const { return {samples->u[0][i], samples->u[1][i], samples->u[2][i]}; }
};

void expect_close(Vec3 a, Vec3 b) { EXPECT_LT(length(a - b), kRounding); }

void add(const std::array<DielectricLanes::Column, 3>& columns, BitHash& hash) {
  for (const auto& column : columns) {
    for (const double value : column) hash.add(value);
  }
}

TEST(RoughLanes, DeflectAsEquation8Does) {
  std::vector<std::uint64_t> hashes;
  for_each_instruction_set([&] {
    BitHash hash;
    for (const double side : {1.0, -1.0}) {
      for (const bool reciprocal : {false, true}) {
        const RaysAtRoughFaces rays;
        // Directions on the wanted side.
        auto direction = rays.lanes->direction;
        for (std::size_t i = 0; i < kCount; ++i) put(at(direction, i) * -side, direction, i);
        const auto before = direction;
        deflect(*rays.samples, kCount, 0.7, reciprocal, rays.lanes->normal, side, direction);
        for (std::size_t i = 0; i < kCount; ++i) {
          const Vec3 facing = at(rays.lanes->normal, i) * side;
          const Vec3 expected = reciprocal ? deflect_light(at(before, i), 0.7, facing, rays.u(i), rays.samples->keep[i])
                                           : deflect(at(before, i), 0.7, facing, rays.u(i));
          expect_close(at(direction, i), expected);
        }
        add(direction, hash);
      }
    }
    hashes.push_back(hash.value());
  });
  for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes.front());
}

TEST(RoughLanes, FindFacetsAsGgxDoes) {
  std::vector<std::uint64_t> hashes;
  for_each_instruction_set([&] {
    BitHash hash;
    for (const double alpha : {0.01, 0.1, 0.9}) {
      const RaysAtRoughFaces rays;
      const auto facets = std::make_unique<FacetLanes>();
      find_facets(*rays.lanes, *rays.samples, alpha, *facets);
      for (std::size_t i = 0; i < kCount; ++i) {
        const Vec3 ray = at(rays.lanes->direction, i), normal = at(rays.lanes->normal, i);
        const SurfaceFrame across = surface_frame(normal);
        const Vec3 arrived{dot(ray, across.u), dot(ray, across.v), dot(ray, normal)};
        const auto u = rays.u(i);
        expect_close(at(facets->at.direction, i), arrived);
        FacetRay met{arrived, {}};
        reach_facet(met, alpha, u[2]);
        EXPECT_NEAR(facets->below[i], met.below, kRounding);
        expect_close(at(facets->at.normal, i), ggx_normal(-arrived, {0, 0, 1}, alpha, u[0], u[1]));
      }
      add(facets->at.normal, hash);
      for (const double below : facets->below) hash.add(below);
    }
    hashes.push_back(hash.value());
  });
  for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes.front());
}

TEST(RoughLanes, LeaveFacetsAsTheMicrosurfaceDoes) {
  TestNumbers numbers;
  const auto rays = std::make_unique<RoughSamples>();
  auto& [z, below, u] = rays->u;
  for (std::size_t i = 0; i < kCount; ++i) {
    z[i] = numbers.between(-0.2, 1);
    below[i] = i % 8 == 0 ? 1.0 : numbers.unit();
    u[i] = numbers.unit();
  }
  int stay = 0;
  for_each_instruction_set([&] {
    escape_facets(kCount, 0.5, z, below, u, rays->keep);
    for (std::size_t i = 0; i < kCount; ++i) {
      FacetRay ray{{std::sqrt(1 - z[i] * z[i]), 0, z[i]}, {}, below[i]};
      const bool reaches = reach_facet(ray, 0.5, u[i]);
      stay += reaches;
      EXPECT_EQ(rays->keep[i], reaches ? 0 : 1);
    }
  });
  EXPECT_GT(stay, 10);
}

TEST(RoughLanes, TurnToTheWorldOnTheRightSide) {
  for_each_instruction_set([] {
    const RaysAtRoughFaces rays;
    const auto facets = std::make_unique<FacetLanes>();
    auto& behind = rays.samples->keep;
    find_facets(*rays.lanes, *rays.samples, 0.3, *facets);
    auto local = facets->at.direction;
    for (std::size_t i = 0; i < kCount; ++i) behind[i] = i % 2 == 0 ? 1 : 0;
    turn_to_world(*facets, rays.lanes->normal, behind, local);
    for (std::size_t i = 0; i < kCount; ++i) {
      // They came downwards: those that are to stay above are mirrored at the face.
      const Vec3 ray = at(rays.lanes->direction, i), normal = at(rays.lanes->normal, i);
      expect_close(at(local, i), i % 2 == 0 ? ray : ray - normal * (2 * dot(ray, normal)));
    }
  });
}

}  // namespace
}  // namespace vitrail
