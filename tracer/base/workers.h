#pragma once
/// Threads that share out blocks of work, say how far they are, and stop when they are asked to.

#include "base/monitor.h"
#include "base/parallel.h"

namespace vitrail {

struct Workers {
  unsigned threads;
  Monitor& monitor;

  /// Call work(block) once for every block in [0, blocks), in no order; each is a unit of the monitor's phase. Blocks
  /// that have not begun when the monitor interrupts are left out. Returns the CPU seconds of all blocks.
  double for_each_block(std::uint64_t blocks, const std::function<void(std::uint64_t block)>& work) const;
};

}  // namespace vitrail
