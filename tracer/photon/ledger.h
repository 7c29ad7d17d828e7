#pragma once
/// Where the power of the photons went, per channel. It closes: emitted = stored + absorbed + escaped +
/// truncated.

#include "base/vec3.h"

namespace vitrail {

/// Watts per channel of all photons that met their target.
struct Ledger {
  Rgb emitted;    // left the light and met the object it was aimed at, or what followed bands and branches stand for
  Rgb stored;     // ended on a diffuse surface after at least one mirror or glass face
  Rgb absorbed;   // kept by a surface (1 - d - r - t, and d where nothing is stored) or by a medium
  Rgb escaped;    // left the scene
  Rgb truncated;  // cut off: too many bounces, or, where every branch is followed, too faint

  Ledger& operator+=(const Ledger& other);
  Ledger scaled(double factor) const;

  /// The largest relative difference between the two sides over the channels; 0 for an empty ledger.
  double closure() const;
};

}  // namespace vitrail
