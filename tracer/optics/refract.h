#pragma once
/// Snell's law and the mirror, in forms that lose nothing for nearly equal indices and at grazing incidence.

#include "base/vec3.h"

namespace vitrail {

/// The two indices at an interface, each with its distance from 1 so that n = 1 + 1e-12 keeps its digits [O 2.2].
struct IndexPair {
  double from = 1, to = 1;
  double from_minus_one = 0, to_minus_one = 0;

  double eta() const { return from / to; }
  /// to - from, exact for indices near 1.
  double step() const { return to_minus_one - from_minus_one; }
};

/// Mirror a direction at a surface [S eq. 3]; `normal` may have either sign.
Vec3 reflect(Vec3 direction, Vec3 normal);

struct Refraction {
  bool total = false;  // total internal reflection: no direction
  double cos_in = 0;   // c1 > 0
  double cos_out = 0;  // c2, 0 at total reflection
  Vec3 direction;      // unit
};

/// Refract at a surface whose normal faces the arriving ray (dot(direction, normal) <= 0) [S eq. 5 corrected, O 1.2]:
/// k = (1-eta)(1+eta) + (eta c1)^2; total reflection where k < 0, else eta (d + c1 n) - sqrt(k) n.
Refraction refract(Vec3 direction, Vec3 facing_normal, const IndexPair& index);

/// The printed equation 5: c1 = d.n with n facing the ray, c2 = sqrt((1-eta^2)(1-c1^2)). Wrong at every angle but the
/// normal one, kept as a curiosity; where the root is not a number the ray is totally reflected [O 1.1 row 7].
Refraction refract_literal(Vec3 direction, Vec3 facing_normal, const IndexPair& index);

}  // namespace vitrail
