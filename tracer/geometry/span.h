#pragma once
/// The pieces of a line inside a solid, and the first event on them. Every solid answers a ray through this, so that
/// what goes in also comes out: rounding may move an event, never lose one.

#include <cstdint>

#include "base/ray.h"
#include "geometry/hit.h"

namespace vitrail {

/// A surface met at distance t: the answer of one shape.
struct ShapeHit {
  double t = 0;
  std::uint32_t face = 0;
  bool entering = false;
};

/// A point brought back onto a face, with what the face is like there.
struct SurfacePoint {
  Vec3 point;
  Vec3 normal;          // unit, outward
  double s = 0, q = 0;  // surface coordinates of flat shapes, metres
};

/// One piece of a line inside a solid, and the faces that bound it.
struct Span {
  double in = -kInfinity, out = kInfinity;
  std::uint32_t face_in = 0, face_out = 0;

  bool is_empty() const { return !(in < out); }
  /// Cut away what lies before or behind a face.
  void enter(double t, std::uint32_t face) {
    if (t > in) in = t, face_in = face;
  }
  void leave(double t, std::uint32_t face) {
    if (t < out) out = t, face_out = face;
  }
};

/// The face a ray departs from, if it is one of these; its distance is then exactly zero and not computed.
inline bool departs_from(const Departure* left, std::uint32_t face) { return left != nullptr && left->face == face; }

/// The first event of a ray on a convex solid. A ray that is known to go on inside leaves now at the latest; one that
/// goes away from a convex solid never comes back.
inline bool first_event(const Span& span, const Departure* left, ShapeHit& hit) {
  if (left != nullptr) {
    if (!left->inside) return false;
    hit = {span.out > 0 ? span.out : 0.0, span.face_out, false};
    return true;
  }
  if (span.is_empty() || !(span.out > 0)) return false;
  hit = span.in > 0 ? ShapeHit{span.in, span.face_in, true} : ShapeHit{span.out, span.face_out, false};
  return true;
}

/// The first event on any solid, from its spans in order along the line.
bool first_event(const Span* begin, const Span* end, const Departure* left, ShapeHit& hit);

}  // namespace vitrail
