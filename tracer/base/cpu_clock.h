#pragma once
/// CPU seconds, which do not count waiting for other work on the machine.

#include <ctime>

namespace vitrail {

inline double seconds_of(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

inline double thread_cpu_s() { return seconds_of(CLOCK_THREAD_CPUTIME_ID); }
inline double process_cpu_s() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); }
inline double wall_s() { return seconds_of(CLOCK_MONOTONIC); }

}  // namespace vitrail
