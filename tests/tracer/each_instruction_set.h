#pragma once
/// Run the kernels once for each instruction set that they are compiled for and that this machine has, and compare
/// bits.

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <bit>
#include <cstdint>
#include <vector>

namespace vitrail {

/// Call `check` with the kernels of each instruction set in turn; give the choice back to Highway at the end.
template <typename Check>
void for_each_instruction_set(const Check& check) {
  const std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
  ASSERT_FALSE(targets.empty());
  for (const std::int64_t target : targets) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(target);
    check();
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().DeInit();
}

/// A hash of bits (FNV-1a), which has to come out alike on every machine.
class BitHash {
 public:
  void add(double value) {
    for (int shift = 0; shift < 64; shift += 8) {
      state_ = (state_ ^ ((std::bit_cast<std::uint64_t>(value) >> shift) & 255)) * 1099511628211ull;
    }
  }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 14695981039346656037ull;
};

}  // namespace vitrail
