#include "photon/beams/lattice_rays.h"

#include <algorithm>

namespace vitrail {
namespace {

// Light that lands so many radii of the scene away, near the horizon of an infinite floor, is too thin to be seen.
constexpr double kFarInRadii = 100;

BeamCorner corner_of(const Landing& landing) {
  const auto as_floats = [](const auto& v, float* to) {
    for (int c = 0; c < 3; ++c) to[c] = static_cast<float>(v[c]);
  };
  BeamCorner corner{landing.position, {}, {}};
  as_floats(landing.normal, corner.normal);
  as_floats(landing.flux, corner.power);
  return corner;
}

}  // namespace

std::uint32_t LatticeRays::at(std::uint32_t a, std::uint32_t b) {
  const auto [found, is_new] =
      index_.try_emplace(static_cast<std::uint64_t>(a) << 32 | b, static_cast<std::uint32_t>(rays_.size()));
  if (is_new) rays_.push_back(followed(a, b));
  return found->second;
}

LatticeRay LatticeRays::followed(std::uint32_t a, std::uint32_t b) {
  LatticeRay ray{a, b, a / pieces_, b / pieces_, static_cast<std::uint32_t>(ends_.size()), 0, {}};
  follow(ray.x, ray.y);
  for (const Landing& landing : landings_) {
    const bool far = length(landing.position - pass_.frame.origin) > kFarInRadii * pass_.radius_m;
    ends_.push_back({landing.signature, static_cast<std::uint32_t>(block_.corners.size()), far});
    block_.corners.push_back(corner_of(landing));
  }
  ray.end_count = static_cast<std::uint32_t>(landings_.size());
  if (ray.end_count > 0) ++block_.landed_rays;
  ray.ledger = ledger_;
  std::sort(ends_.begin() + ray.first_end, ends_.end(),
            [](const RayEnd& x, const RayEnd& y) { return x.signature < y.signature; });
  return ray;
}

void LatticeRays::follow(double x, double y) {
  ledger_ = {};
  landings_.clear();
  ++block_.rays;
  const Emission emission = emit(chart_, {unit_point(x, y), {}});
  if (is_black(emission.power)) return;
  tree_.follow({.path = {.ray = emission.ray,
                         .media = pass_.intersector.media_at(emission.ray.origin),
                         .weight = emission.power},
                .least = kLeastPhotonShare * largest_channel(emission.power)});
}

const RayEnd* LatticeRays::end_of(std::uint32_t ray, PathSignature signature) const {
  const LatticeRay& from = rays_[ray];
  const auto first = ends_.begin() + from.first_end, last = first + from.end_count;
  const auto found =
      std::lower_bound(first, last, signature, [](const RayEnd& end, PathSignature s) { return end.signature < s; });
  return found != last && found->signature == signature ? &*found : nullptr;
}

}  // namespace vitrail
