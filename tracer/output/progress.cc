#include "output/progress.h"

#include <csignal>

#include "base/cpu_clock.h"

namespace vitrail {
namespace {

constexpr double kSecondsBetweenLines = 0.1;

volatile std::sig_atomic_t asked_to_stop = 0;

extern "C" void ask_to_stop(int) { asked_to_stop = 1; }

}  // namespace

ProgressLines::ProgressLines(std::FILE* stream) : stream_(stream) {
  asked_to_stop = 0;
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
}

ProgressLines::~ProgressLines() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

void ProgressLines::begin(const std::string& phase, std::uint64_t total) {
  const std::lock_guard<std::mutex> lock(mutex_);
  phase_ = phase;
  total_ = total;
  done_ = 0;
  write_line();
}

void ProgressLines::advance(std::uint64_t units) {
  const std::lock_guard<std::mutex> lock(mutex_);
  done_ += units;
  if (done_ == total_ || wall_s() - last_line_s_ >= kSecondsBetweenLines) write_line();
}

bool ProgressLines::interrupted() const { return asked_to_stop != 0; }

void ProgressLines::write_line() {
  last_line_s_ = wall_s();
  if (!stream_) return;
  std::fprintf(stream_, "{\"phase\": \"%s\", \"done\": %llu, \"total\": %llu}\n", phase_.c_str(),
               static_cast<unsigned long long>(done_), static_cast<unsigned long long>(total_));
  std::fflush(stream_);
}

}  // namespace vitrail
