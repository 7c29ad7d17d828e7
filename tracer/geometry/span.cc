#include "geometry/span.h"

namespace vitrail {

bool first_event(const Span* begin, const Span* end, const Departure* left, ShapeHit& hit) {
  const bool inside = left != nullptr && left->inside;
  for (const Span* span = begin; span != end; ++span) {
    if (!(span->out > 0)) continue;

    // Inside by departure: this span holds the ray unless it only starts ahead; then the ray has come out already.
    if (inside) {
      if (span->in > 0) break;
      hit = {span->out, span->face_out, false};
      return true;
    }

    // Outside by departure: a span that seems to hold the ray already was left or is missed by a hair.
    if (left != nullptr && !(span->in > 0)) continue;

    // No departure: the origin alone decides.
    hit = span->in > 0 ? ShapeHit{span->in, span->face_in, true} : ShapeHit{span->out, span->face_out, false};
    return true;
  }
  if (!inside) return false;
  hit = {0, left->face, false};
  return true;
}

}  // namespace vitrail
