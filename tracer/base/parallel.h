#pragma once
/// Blocks of work shared out over threads. Which thread takes which block is left to chance, so results must not depend
/// on it: write to a place of the block's own, or add associatively.

#include <cstdint>
#include <functional>

namespace vitrail {

/// The number of threads a request means: itself, or what the machine offers for 0.
unsigned thread_count(unsigned requested);

/// Call work(block, worker) once for every block in [0, blocks), worker in [0, threads). Return when all are done.
/// The first exception thrown by a block ends the sharing out and is thrown again here.
void parallel_blocks(std::uint64_t blocks, unsigned threads,
                     const std::function<void(std::uint64_t block, unsigned worker)>& work);

}  // namespace vitrail
