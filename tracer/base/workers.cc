#include "base/workers.h"

#include <numeric>
#include <vector>

#include "base/cpu_clock.h"

namespace vitrail {

double Workers::for_each_block(std::uint64_t blocks, const std::function<void(std::uint64_t block)>& work) const {
  std::vector<double> cpu_s(blocks);
  parallel_blocks(blocks, threads, [&](std::uint64_t block, unsigned) {
    if (monitor.interrupted()) return;
    const double start = thread_cpu_s();
    work(block);
    cpu_s[block] = thread_cpu_s() - start;
    monitor.advance(1);
  });
  return std::accumulate(cpu_s.begin(), cpu_s.end(), 0.0);
}

}  // namespace vitrail
