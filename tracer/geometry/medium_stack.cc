#include "geometry/medium_stack.h"

#include "base/diagnostic.h"

namespace vitrail {

void MediumSet::enter(std::uint32_t object, bool counted) {
  for (int i = 0; i < size_; ++i)
    if (objects_[i] == object) {
      if (counted) ++counts_[i];
      return;
    }
  if (size_ == kCapacity)
    throw LimitError({"scene.objects", "have more than 15 solids around one point", "nest fewer solids"});

  // Keep the objects in order, so that equal sets are equal whatever way led there.
  int place = size_++;
  for (; place > 0 && objects_[place - 1] > object; --place) {
    objects_[place] = objects_[place - 1];
    counts_[place] = counts_[place - 1];
  }
  objects_[place] = object;
  counts_[place] = 1;
}

void MediumSet::leave(std::uint32_t object) {
  for (int i = 0; i < size_; ++i) {
    if (objects_[i] != object) continue;
    if (--counts_[i] > 0) return;
    --size_;
    for (int next = i; next < size_; ++next) {
      objects_[next] = objects_[next + 1];
      counts_[next] = counts_[next + 1];
    }
    return;
  }
}

bool MediumSet::contains(std::uint32_t object) const {
  for (int i = 0; i < size_; ++i)
    if (objects_[i] == object) return true;
  return false;
}

std::uint32_t MediumSet::dominant(const Scene& scene) const {
  std::uint32_t best = kAir;
  for (int i = 0; i < size_; ++i)
    if (best == kAir || scene.objects[objects_[i]].priority > scene.objects[best].priority) best = objects_[i];
  return best;
}

}  // namespace vitrail
