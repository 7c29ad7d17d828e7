#include "photon/halves.h"

#include <algorithm>

namespace vitrail {
namespace {

// A power of two, so that each block of a chart is a net of its own.
constexpr std::uint64_t kPhotonsPerBlock = 8192;

}  // namespace

std::vector<ChartBlock> plan_blocks(const std::vector<Chart>& charts) {
  std::vector<ChartBlock> plan;
  for (std::uint64_t half = 0; half < 2; ++half) {
    for (std::uint32_t c = 0; c < charts.size(); ++c) {
      for (std::uint64_t first = 0; first < charts[c].count; first += kPhotonsPerBlock) {
        plan.push_back({half, c, first, std::min(kPhotonsPerBlock, charts[c].count - first)});
      }
    }
  }
  return plan;
}

}  // namespace vitrail
