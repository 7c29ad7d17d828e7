#include "render/light_bins.h"

#include <cmath>
#include <optional>

#include "render/camera.h"
#include "render/first_hit.h"
#include "render/pixel_sums.h"

namespace vitrail {
namespace {

constexpr std::size_t kPhotonsPerBlock = 4096, kBlocksAtOnce = 256;

// A camera ray must end this close to the photon, in gather radii: photon positions are floats.
constexpr double kSamePlace = 1.0 / 16;

struct Deposit {
  int x, y;
  Rgb radiance;
};

// What the pixel that sees a photon gets from it, if one does.
std::optional<Deposit> deposit_of(const Picture& picture, const FirstHitFinder& camera, const PhotonMap::Photon& photon,
                                  double radius_m) {
  const std::optional<ImagePoint> seen = project(picture.camera, picture.image, photon.position);
  if (!seen) return {};
  const int x = static_cast<int>(std::floor(seen->x)), y = static_cast<int>(std::floor(seen->y));
  if (x < 0 || y < 0 || x >= picture.image.width || y >= picture.image.height) return {};

  // The photon must lie on the first surface that this place of the pixel sees, on the side that is seen.
  const FirstHit hit = camera.through(seen->x, seen->y);
  const Arrival& arrival = hit.arrival;
  if (arrival.escaped || length(arrival.hit.point - photon.position) > kSamePlace * radius_m) return {};
  if (!(dot(arrival.event.facing_normal, photon.normal) > 0)) return {};
  const double pixels_per_m2 = seen->pixels_per_facing_m2 * hit.cosine, ratio = hit.ior_ratio;
  return Deposit{x, y,
                 arrival.transmittance * arrival.event.diffuse * photon.flux * (pixels_per_m2 * ratio * ratio / M_PI)};
}

}  // namespace

std::size_t deposit_blocks(const PhotonMap& map) { return (map.size() + kPhotonsPerBlock - 1) / kPhotonsPerBlock; }

double deposit_in_pixels(const World& world, const Picture& picture, const PhotonMap& map, int half,
                         const Workers& workers, Film& film) {
  const std::size_t blocks = deposit_blocks(map);
  const FirstHitFinder camera(world, picture);
  PixelSums sums(film);
  double cpu_s = 0;
  std::vector<std::optional<Deposit>> deposits;
  for (std::size_t begin = 0; begin < blocks && !workers.monitor.interrupted(); begin += kBlocksAtOnce) {
    // Find the pixels of some blocks on all threads, ...
    const std::size_t count = std::min(kBlocksAtOnce, blocks - begin), first = begin * kPhotonsPerBlock;
    deposits.assign(std::min(count * kPhotonsPerBlock, map.size() - first), {});
    cpu_s += workers.for_each_block(count, [&](std::uint64_t b) {
      const std::size_t end = std::min(deposits.size(), (b + 1) * kPhotonsPerBlock);
      for (std::size_t i = b * kPhotonsPerBlock; i < end; ++i) {
        deposits[i] = deposit_of(picture, camera, map.photon(first + i), map.radius_m());
      }
    });

    // ... and add them up in their order on this one.
    for (const std::optional<Deposit>& deposit : deposits) {
      if (deposit) sums.add(deposit->x, deposit->y, deposit->radiance);
    }
  }
  sums.develop(film, half, Layer::caustic);
  return cpu_s;
}

}  // namespace vitrail
