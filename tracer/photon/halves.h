#pragma once
/// The course of every pass: plan blocks for both halves, trace them on all threads, build one map for each half.

#include <array>
#include <utility>
#include <vector>

#include "base/workers.h"
#include "light/light.h"

namespace vitrail {

/// A run of photons of one chart.
struct ChartBlock {
  std::uint64_t half;
  std::uint32_t chart;
  std::uint64_t first, count;
};

/// All photons of all charts, first those of one half, then those of the other.
std::vector<ChartBlock> plan_blocks(const std::vector<Chart>& charts);

template <typename Block>
struct TracedHalves {
  std::array<std::vector<Block>, 2> half;  // in the order of the plan, whichever thread took which block
  double cpu_s = 0;
};

/// Trace every block of a plan; each has a member `half`. Blocks left out by an interruption stay empty.
template <typename Planned, typename Trace>
auto trace_halves(const std::vector<Planned>& plan, const char* phase, const Workers& workers, const Trace& trace) {
  std::vector<decltype(trace(plan.front()))> blocks(plan.size());
  TracedHalves<typename decltype(blocks)::value_type> traced;
  workers.monitor.begin(phase, plan.size());
  traced.cpu_s = workers.for_each_block(plan.size(), [&](std::uint64_t b) { blocks[b] = trace(plan[b]); });
  for (std::size_t b = 0; b < blocks.size(); ++b) traced.half[plan[b].half].push_back(std::move(blocks[b]));
  return traced;
}

/// Call build(half) for both halves, one thread each; neither if the work was interrupted. Returns CPU seconds.
template <typename Build>
double build_halves(const Workers& workers, const Build& build) {
  workers.monitor.begin("photon_sort", 2);
  return workers.for_each_block(2, build);
}

}  // namespace vitrail
