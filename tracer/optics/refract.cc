#include "optics/refract.h"

#include <algorithm>

namespace vitrail {

namespace {

/// Above this eta, (1 - eta)(1 + eta) + (eta c1)^2 loses eta^2 units of rounding and 1 - (eta sin)^2 only eta; below
/// it the two are equally good at all angles but the first is better near eta = 1.
constexpr double kSteep = 2;

}  // namespace

Vec3 reflect(Vec3 direction, Vec3 normal) { return normalise(direction - normal * (2 * dot(direction, normal))); }

Refraction refract(Vec3 direction, Vec3 facing_normal, const IndexPair& index) {
  Refraction result;
  result.cos_in = std::clamp(-dot(direction, facing_normal), 0.0, 1.0);

  // Form the radicand from the difference of the indices, so that matched media bend nothing at any angle [O 2.3];
  // far into the thinner medium light must arrive along the normal, and there the sine keeps the digits.
  const double eta = index.eta();
  const double one_minus_eta = index.step() / index.to;
  const Vec3 along = direction + facing_normal * result.cos_in;
  const double k = eta > kSteep ? 1 - eta * eta * length_squared(along)
                                : one_minus_eta * (1 + eta) + (eta * result.cos_in) * (eta * result.cos_in);
  if (k < 0) {
    result.total = true;
    return result;
  }

  // Matched media keep the very same direction, to the last bit.
  result.cos_out = std::sqrt(k);
  if (index.step() == 0) {
    result.cos_out = result.cos_in;
    result.direction = direction;
    return result;
  }
  result.direction = normalise(along * eta - facing_normal * result.cos_out);
  return result;
}

Refraction refract_literal(Vec3 direction, Vec3 facing_normal, const IndexPair& index) {
  Refraction result;
  const double c1 = dot(direction, facing_normal);
  const double eta = index.eta();
  const double c2 = std::sqrt((1 - eta * eta) * (1 - c1 * c1));
  const Vec3 bent = (direction + facing_normal * c1) * eta - facing_normal * c2;
  result.cos_in = std::clamp(-c1, 0.0, 1.0);

  // Follow the formula wherever it yields a direction at all.
  if (!(length_squared(bent) > 0)) {
    result.total = true;
    return result;
  }
  result.direction = normalise(bent);
  result.cos_out = std::clamp(-dot(result.direction, facing_normal), 0.0, 1.0);
  return result;
}

}  // namespace vitrail
