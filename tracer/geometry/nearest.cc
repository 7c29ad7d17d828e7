#include "geometry/nearest.h"

namespace vitrail {

void Nearest::offer_close(std::uint32_t object, const ShapeHit& hit) {
  const Candidate candidate{hit.t, object, hit.face, hit.entering};

  // Keep the list in order, one entry an object, the farthest dropped when it is full.
  InlineVector<Candidate, 6> kept;
  bool placed = false;
  for (const Candidate& other : found_) {
    if (other.object == object) {
      const bool stays = other.t < hit.t || (other.t == hit.t && other.face <= hit.face);
      if (stays) return;
      continue;
    }
    if (!placed && candidate.before(other)) {
      kept.push_back(candidate);
      placed = true;
    }
    kept.push_back(other);
  }
  if (!placed) kept.push_back(candidate);

  // Drop what has fallen out of the window of a nearer hit.
  found_.clear();
  for (const Candidate& other : kept)
    if (other.t <= kept[0].t + window(kept[0].t)) found_.push_back(other);
}

}  // namespace vitrail
