// The sorted grid and its flat-disc estimate, against a plain loop over all photons.
#include "photon/photon_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/frame.h"
#include "base/random.h"

namespace vitrail {
namespace {

using Blocks = std::vector<std::vector<PhotonRecord>>;

// Photons on a square of half width `half` in the plane through `center` with a normal, unit flux each, in two blocks.
Blocks photons_on_square(const PhotonFrame& frame, Vec3 center, Vec3 normal, double half, std::uint32_t count) {
  Blocks blocks(2);
  const SurfaceFrame axes = surface_frame(normal);
  const Stream stream = stream_of(11, Purpose::kEmissionPosition);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto [a, b] = sobol_2d(stream, i);
    const Vec3 at = center + axes.u * (half * (2 * a - 1)) + axes.v * (half * (2 * b - 1));
    blocks[i % 2].push_back(make_photon(frame, at, normal, {1, 2, 4}));
  }
  return blocks;
}

// The same estimate with no grid: every photon is tested. Doubles, so a photon on the rim may differ by rounding.
Rgb plain_irradiance(const Blocks& blocks, const PhotonFrame& frame, const GatherQuery& query, double radius) {
  Rgb sum;
  for (const auto& block : blocks) {
    for (const PhotonRecord& photon : block) {
      const Vec3 at{photon.position[0], photon.position[1], photon.position[2]};
      const Vec3 d = at + frame.origin - query.position;
      const double offset = dot(d, query.normal);
      const Vec3 n{photon.normal[0] / 127.0, photon.normal[1] / 127.0, photon.normal[2] / 127.0};
      if (length_squared(d) - offset * offset >= radius * radius || std::abs(offset) >= radius / 4) continue;
      if (dot(n, query.normal) > 0) sum += Rgb{photon.flux[0], photon.flux[1], photon.flux[2]};
    }
  }
  return sum * (1 / (M_PI * radius * radius));
}

// Planes in every direction, near and far from the origin, dense and sparse cells: the grid finds what the loop finds.
TEST(PhotonMap, AgreesWithALoopOverAllPhotons) {
  const Vec3 normals[] = {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}, normalise(Vec3{1, 1, 1}), normalise(Vec3{-0.3, 0.2, 0.9})};
  for (const Vec3 normal : normals) {
    for (const double radius : {0.02, 0.1, 0.7}) {
      for (const Vec3 center : {Vec3{0, 0, 0}, Vec3{1e5, -3, 2e4}}) {
        const PhotonFrame frame{center};
        const Blocks blocks = photons_on_square(frame, center, normal, 1.0, 5000);
        const PhotonMap map(frame, blocks, radius);
        ASSERT_EQ(map.size(), 5000u);
        const SurfaceFrame axes = surface_frame(normal);
        for (std::uint32_t i = 0; i < 100; ++i) {
          const auto [a, b] = sobol_2d(stream_of(3, Purpose::kPixel), i);
          const GatherQuery query{center + axes.u * (2.4 * a - 1.2) + axes.v * (2.4 * b - 1.2), normal};
          const Rgb expected = plain_irradiance(blocks, frame, query, radius), found = map.irradiance(query);
          // One photon on the rim may fall to the other side when positions are rounded to float.
          const double one_photon = 1 / (M_PI * radius * radius);
          EXPECT_NEAR(found.r, expected.r, 1.001 * one_photon);
          EXPECT_NEAR(found.g, 2 * found.r, 1e-6 * found.r);
          EXPECT_NEAR(found.b, 4 * found.r, 1e-6 * found.r);
        }
      }
    }
  }
}

// A photon at 1e9 m must not make the grid large, nor be found anywhere else.
TEST(PhotonMap, OutliersCostNothing) {
  const PhotonFrame frame{{0, 0, 0}};
  Blocks blocks = photons_on_square(frame, {0, 0, 0}, {0, 1, 0}, 1.0, 20000);
  const Rgb before = PhotonMap(frame, blocks, 0.1).irradiance({{0.2, 0, 0.1}, {0, 1, 0}});
  blocks[0].push_back(make_photon(frame, {1e9, 0, -3e8}, {0, 1, 0}, {1, 1, 1}));
  const PhotonMap map(frame, blocks, 0.1);
  EXPECT_NEAR(map.irradiance({{0.2, 0, 0.1}, {0, 1, 0}}).r, before.r, 1e-6 * before.r);
  EXPECT_GT(map.irradiance({{1e9, 0, -3e8}, {0, 1, 0}}).r, 0);
}

// Light that arrives on one side of a sheet is not seen from the other, nor is light on a wall standing on it.
TEST(PhotonMap, KeepsSidesAndWallsApart) {
  const PhotonFrame frame{{0, 0, 0}};
  const Blocks floor = photons_on_square(frame, {0, 0, 0}, {0, 1, 0}, 1.0, 5000);
  const PhotonMap floor_map(frame, floor, 0.2);
  EXPECT_GT(floor_map.irradiance({{0, 0, 0}, {0, 1, 0}}).r, 0);
  EXPECT_EQ(floor_map.irradiance({{0, 0, 0}, {0, -1, 0}}).r, 0);
  const Blocks wall = photons_on_square(frame, {0, 0, 0}, {1, 0, 0}, 1.0, 5000);
  EXPECT_EQ(PhotonMap(frame, wall, 0.2).irradiance({{0.05, 0, 0}, {0, 1, 0}}).r, 0);
}

// Every length times 8 is the same picture of 1/64 the irradiance, to the last bit.
TEST(PhotonMap, ScalesExactlyByPowersOfTwo) {
  const Vec3 normal = normalise(Vec3{0.2, 1, 0.1}), center{0.3, 0.1, -0.7};
  const PhotonFrame frame{center}, frame_8{center * 8};
  Blocks blocks = photons_on_square(frame, center, normal, 1.0, 3000), blocks_8 = blocks;
  for (auto& block : blocks_8) {
    for (auto& photon : block) {
      for (float& x : photon.position) x *= 8;
    }
  }
  const PhotonMap map(frame, blocks, 0.15), map_8(frame_8, blocks_8, 1.2);
  for (double t : {-0.5, 0.0, 0.125, 0.4}) {
    const Vec3 at = center + surface_frame(normal).u * t;
    EXPECT_EQ(map.irradiance({at, normal}).r, 64 * map_8.irradiance({at * 8, normal}).r);
  }
}

/// The kernel for 16 floats at a time and the one for 8 give the same bits.

TEST(PhotonMap, IsEmptyWithoutPhotons) {
  EXPECT_EQ(PhotonMap({}, Blocks(3), 0.1).irradiance({{0, 0, 0}, {0, 1, 0}}), (Rgb{0, 0, 0}));
}

}  // namespace
}  // namespace vitrail
