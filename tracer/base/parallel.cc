#include "base/parallel.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace vitrail {

unsigned thread_count(unsigned requested) {
  if (requested > 0) return requested;
  const unsigned offered = std::thread::hardware_concurrency();
  return offered > 0 ? offered : 1;
}

void parallel_blocks(std::uint64_t blocks, unsigned threads,
                     const std::function<void(std::uint64_t block, unsigned worker)>& work) {
  std::atomic<std::uint64_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;

  // Take the next block until none is left; a failure takes all the rest.
  const auto run = [&](unsigned worker) {
    try {
      for (std::uint64_t block; (block = next.fetch_add(1, std::memory_order_relaxed)) < blocks;) work(block, worker);
    } catch (...) {
      next.store(blocks, std::memory_order_relaxed);
      const std::lock_guard<std::mutex> lock(failure_mutex);
      if (!failure) failure = std::current_exception();
    }
  };

  // Let the calling thread work too, so that one thread means no thread is started.
  {
    std::vector<std::jthread> helpers;
    for (unsigned worker = 1; worker < threads && worker < blocks; ++worker) helpers.emplace_back(run, worker);
    run(0);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace vitrail
