#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

#include "base/diagnostic.h"
#include "base/exact.h"
#include "base/frame.h"
#include "base/parallel.h"

namespace vitrail {
namespace {

TEST(ParallelBlocks, CallsEveryBlockOnce) {
  for (unsigned threads : {1u, 2u, 7u}) {
    std::vector<std::atomic<int>> calls(1000);
    parallel_blocks(calls.size(), threads, [&](std::uint64_t block, unsigned worker) {
      EXPECT_LT(worker, threads);
      ++calls[block];
    });
    for (const auto& count : calls) EXPECT_EQ(count, 1);
  }
}

TEST(ParallelBlocks, PassesOnAFailureAndStops) {
  std::atomic<int> calls{0};
  const auto work = [&](std::uint64_t block, unsigned) {
    ++calls;
    if (block == 3) throw std::runtime_error("block 3");
  };
  EXPECT_THROW(parallel_blocks(1000000, 2, work), std::runtime_error);
  EXPECT_LT(calls, 1000000);
}

TEST(ParallelBlocks, DoesNothingForNoBlocks) {
  parallel_blocks(0, 4, [](std::uint64_t, unsigned) { FAIL(); });
}

TEST(Diagnostic, SaysWhereWhatAndWhatToDo) {
  const InputError error({{"scene.image.width", "is 0", "write 1 or more"}, {"b", "c", "d"}});
  EXPECT_STREQ(error.what(), "scene.image.width: is 0; write 1 or more\nb: c; d");
}

TEST(Exact, KeepsWhatRoundingLoses) {
  const Exact sum = exact_sum(1e16, 1.5);
  EXPECT_EQ(sum.value, 1e16 + 2);
  EXPECT_EQ(sum.error, -0.5);
  const Exact product = exact_product(1 + 0x1p-30, 1 + 0x1p-30);
  EXPECT_EQ(product.value, 1 + 0x1p-29);
  EXPECT_EQ(product.error, 0x1p-60);
}

TEST(SurfaceFrame, FollowsTheRuleOfTheSceneLanguage) {
  EXPECT_EQ(surface_frame({0, 1, 0}).u, (Vec3{1, 0, 0}));
  EXPECT_EQ(surface_frame({0, 1, 0}).v, (Vec3{0, 0, -1}));
  EXPECT_EQ(surface_frame({1, 0, 0}).u, (Vec3{0, 0, 1}));
}

}  // namespace
}  // namespace vitrail
