#pragma once
/// Progress as JSON lines, and Ctrl-C that lets the work at hand be finished.

#include <atomic>
#include <cstdio>
#include <mutex>

#include "base/monitor.h"

namespace vitrail {

/// Writes {"phase", "done", "total"} lines to a stream, at most about ten a second and always the first and last of a
/// phase; silent if the stream is null. While it lives, SIGINT and SIGTERM ask for an early end.
class ProgressLines : public Monitor {
 public:
  explicit ProgressLines(std::FILE* stream);
  ~ProgressLines() override;
  ProgressLines(const ProgressLines&) = delete;
  ProgressLines& operator=(const ProgressLines&) = delete;

  void begin(const std::string& phase, std::uint64_t total) override;
  void advance(std::uint64_t units) override;
  bool interrupted() const override;

 private:
  void write_line();

  std::FILE* stream_;
  std::mutex mutex_;
  std::string phase_;
  std::uint64_t done_ = 0, total_ = 0;
  double last_line_s_ = 0;
};

}  // namespace vitrail
