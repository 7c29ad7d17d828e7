#pragma once
/// How unpolarised light divides at a dielectric interface.

#include "optics/refract.h"

namespace vitrail {

/// R and T formed each on its own, never as 1 - the other: T keeps its digits at grazing incidence, R between nearly
/// equal media [O 2.1, 2.6].
struct FresnelShares {
  double R = 0, T = 1;
};

/// Shares for a refraction that is not total; (1, 0) for one that is.
FresnelShares fresnel(const IndexPair& index, const Refraction& refraction);

}  // namespace vitrail
