#include "optics/fresnel.h"

namespace vitrail {

FresnelShares fresnel(const IndexPair& index, const Refraction& refraction) {
  if (refraction.total) return {1, 0};
  const double n1 = index.from, n2 = index.to, c1 = refraction.cos_in, c2 = refraction.cos_out;
  const double across = n1 * c1 + n2 * c2;  // denominator of the s amplitude
  const double along = n2 * c1 + n1 * c2;   // ... and of the p amplitude
  if (!(across > 0) || !(along > 0)) return {1, 0};

  // Write both numerators as (n2 - n1) times something: n1^2 c1^2 - n2^2 c2^2 = n1^2 - n2^2 by Snell's law.
  const double difference = index.step() * (n1 + n2);
  const double sine_squared = (1 - c1) * (1 + c1);
  const double eta = index.eta();
  const double r_s = -difference / (across * across);
  const double r_p = difference * (c1 * c1 - eta * eta * sine_squared) / (along * along);

  const double flow = 4 * n1 * n2 * c1 * c2;
  return {(r_s * r_s + r_p * r_p) / 2, (flow / (across * across) + flow / (along * along)) / 2};
}

}  // namespace vitrail
