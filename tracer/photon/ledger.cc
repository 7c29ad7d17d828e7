#include "photon/ledger.h"

#include <algorithm>
#include <cmath>

namespace vitrail {

Ledger& Ledger::operator+=(const Ledger& other) {
  emitted += other.emitted;
  stored += other.stored;
  absorbed += other.absorbed;
  escaped += other.escaped;
  truncated += other.truncated;
  return *this;
}

Ledger Ledger::scaled(double factor) const {
  return {emitted * factor, stored * factor, absorbed * factor, escaped * factor, truncated * factor};
}

double Ledger::closure() const {
  double worst = 0;
  const Rgb spent = stored + absorbed + escaped + truncated;
  for (int channel = 0; channel < 3; ++channel) {
    if (emitted[channel] == 0 && spent[channel] == 0) continue;
    worst = std::max(worst, std::abs(emitted[channel] - spent[channel]) / emitted[channel]);
  }
  return worst;
}

}  // namespace vitrail
