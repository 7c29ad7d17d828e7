/// The gather kernel against a plain loop, bit for bit, on every instruction set.

#include "build_scene.h"
#include "each_instruction_set.h"
#include "photon/gather_kernel.h"

namespace vitrail {
namespace {

constexpr std::size_t kPhotons = 1000;

struct Photons {
  std::array<std::vector<float>, 3> position, flux;
  std::vector<std::uint32_t> normal;

  Photons() : normal(kPhotons + PhotonColumns::kPadding) {
    TestNumbers numbers;
    for (int a = 0; a < 3; ++a) {
      for (std::size_t i = 0; i < normal.size(); ++i) {
        position[a].push_back(static_cast<float>(numbers.between(-1, 1) * (a == 1 ? 0.3 : 1)));
        flux[a].push_back(static_cast<float>(numbers.unit()));
        // Three signed bytes of any value.
        normal[i] |= static_cast<std::uint32_t>(numbers.between(0, 256)) << (8 * a);
      }
    }
  }
  PhotonColumns columns() const {
    return {{position[0].data(), position[1].data(), position[2].data()},
            {flux[0].data(), flux[1].data(), flux[2].data()},
            normal.data()};
  }
};

// The definition: photon by photon, lane i mod 16 of its run, lanes added half onto half.
Rgb plain_flux_in_disc(const Photons& photons, const std::vector<PhotonRun>& runs, const GatherDisc& disc) {
  float lanes[3][16] = {};
  for (const PhotonRun& run : runs) {
    for (std::uint32_t i = run.begin; i < run.end; ++i) {
      float d[3], offset = 0, squared = 0;
      for (int a = 0; a < 3; ++a) {
        d[a] = photons.position[a][i] - disc.center[a];
        offset = a == 0 ? d[a] * disc.normal[a] : offset + d[a] * disc.normal[a];
        squared = a == 0 ? d[a] * d[a] : squared + d[a] * d[a];
      }
      const float along_squared = squared - offset * offset;
      const auto side = static_cast<std::int32_t>(photons.normal[i] << disc.normal_shift) ^ disc.normal_flip;
      if (!(along_squared < disc.radius_squared) || !(offset * offset < disc.offset_squared)) continue;
      if (side < disc.normal_least) continue;
      for (int c = 0; c < 3; ++c) lanes[c][(i - run.begin) % 16] += photons.flux[c][i];
    }
  }
  for (int half = 8; half > 0; half /= 2) {
    for (int c = 0; c < 3; ++c) {
      for (int i = 0; i < half; ++i) lanes[c][i] += lanes[c][i + half];
    }
  }
  return {lanes[0][0], lanes[1][0], lanes[2][0]};
}

TEST(GatherKernel, GivesTheBitsOfAPlainLoopOnEveryInstructionSet) {
  const Photons photons;
  // Runs of every length to 40, so that they end at every lane.
  std::vector<PhotonRun> runs;
  for (std::uint32_t begin = 0, length = 0; length <= 40 && begin + length < kPhotons; begin += length++) {
    runs.push_back({begin, begin + length});
  }
  ASSERT_EQ(runs.size(), 41u);
  for_each_instruction_set([&] {
    BitHash hash;
    for (int byte = 0; byte < 3; ++byte) {
      for (const std::int32_t flip : {0, -1}) {
        for (const float radius : {0.3f, 0.9f}) {
          const GatherDisc disc{
              {0.1f, 0.05f, -0.2f}, {0.2f, 0.96f, 0.19f}, radius * radius, 0.04f, 24 - 8 * byte, flip, 24 << 24};
          const Rgb expected = plain_flux_in_disc(photons, runs, disc);
          const Rgb found = flux_in_disc(photons.columns(), runs.data(), static_cast<int>(runs.size()), disc);
          EXPECT_GT(expected.r, 0);
          EXPECT_EQ(found, expected);
          for (int c = 0; c < 3; ++c) hash.add(found[c]);
        }
      }
    }
    EXPECT_EQ(hash.value(), 3237402228269092369u);  // on every machine
  });
}

TEST(GatherKernel, FindsNothingWithoutRuns) {
  for_each_instruction_set([] { EXPECT_EQ(flux_in_disc(Photons().columns(), nullptr, 0, {}), (Rgb{0, 0, 0})); });
}

}  // namespace
}  // namespace vitrail
