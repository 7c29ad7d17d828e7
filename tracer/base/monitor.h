#pragma once
/// How long work says how far it is, and hears that it should stop. Safe to call from many threads.

#include <cstdint>
#include <string>

namespace vitrail {

class Monitor {
 public:
  virtual ~Monitor() = default;

  /// A phase of `total` units begins ("photon_pass", "photon_sort", "camera"), ...
  virtual void begin(const std::string& phase, std::uint64_t total) = 0;
  /// ... and one or more of its units are done.
  virtual void advance(std::uint64_t units) = 0;
  /// Whether to finish the blocks at hand and take no new ones.
  virtual bool interrupted() const = 0;
};

/// Says nothing and never stops.
class SilentMonitor : public Monitor {
 public:
  void begin(const std::string&, std::uint64_t) override {}
  void advance(std::uint64_t) override {}
  bool interrupted() const override { return false; }
};

}  // namespace vitrail
