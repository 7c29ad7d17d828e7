#include "render/light_bins.h"

#include <cmath>
#include <optional>

#include "base/cpu_clock.h"
#include "base/parallel.h"
#include "material/surface.h"
#include "photon/pass.h"
#include "render/camera.h"

namespace vitrail {
namespace {

constexpr std::size_t kPhotonsPerBlock = 4096, kBlocksAtOnce = 256;

// A look must end this close to the photon, in gather radii: photon positions are floats.
constexpr double kSamePlace = 1.0 / 16;

struct Deposit {
  int x = -1, y = 0;
  Rgb radiance;
};

// What the pixel that sees a photon gets from it; x = -1 if none does.
Deposit deposit_of(const Scene& scene, const Intersector& intersector, const PhotonMap::Photon& photon,
                   double radius_m) {
  const std::optional<ImagePoint> seen = project(scene.camera, scene.image, photon.position);
  if (!seen) return {};
  const int x = static_cast<int>(std::floor(seen->x)), y = static_cast<int>(std::floor(seen->y));
  if (x < 0 || y < 0 || x >= scene.image.width || y >= scene.image.height) return {};

  // Look there: the photon must lie on the first surface, on the side that is seen.
  const Ray ray = camera_ray(scene.camera, scene.image, seen->x, seen->y);
  const MediumSet media = intersector.media_at(ray.origin);
  const Arrival arrival = advance(scene, intersector, ray, {}, media, 0, !scene.paper.disperse_camera);
  if (arrival.escaped || length(arrival.hit.point - photon.position) > kSamePlace * radius_m) return {};
  const Vec3 normal = arrival.event.facing_normal;
  if (!(dot(normal, photon.normal) > 0)) return {};
  const double cosine = -dot(ray.direction, normal), ratio = ior_in(scene, media, 0) / arrival.event.index.from;
  const double pixels_per_m2 = seen->pixels_per_facing_m2 * cosine;
  return {x, y, arrival.transmittance * arrival.event.diffuse * photon.flux * (pixels_per_m2 * ratio * ratio / M_PI)};
}

}  // namespace

bool takes_light_bins(const Scene& scene) {
  if (scene.settings.solver != "auto") return scene.settings.solver == "light_bins";
  const double pixels = static_cast<double>(scene.image.width) * scene.image.height;
  return static_cast<double>(scene.settings.photons) >= kPhotonsForBins * pixels;
}

bool counts_in_pixels(const Scene& scene) { return takes_light_bins(scene) || takes_beams(scene); }

double deposit_in_pixels(const Scene& scene, const Intersector& intersector, const PhotonMap& map, int half,
                         unsigned threads, Monitor& monitor, Film& film) {
  const std::size_t blocks = (map.size() + kPhotonsPerBlock - 1) / kPhotonsPerBlock;
  std::vector<double> cpu_s(blocks);
  std::vector<Deposit> deposits;
  monitor.begin("light_bins", blocks);
  for (std::size_t begin = 0; begin < blocks && !monitor.interrupted(); begin += kBlocksAtOnce) {
    // Find the pixels of some blocks on all threads, ...
    const std::size_t count = std::min(kBlocksAtOnce, blocks - begin), first = begin * kPhotonsPerBlock;
    deposits.assign(std::min(count * kPhotonsPerBlock, map.size() - first), {});
    parallel_blocks(count, threads, [&](std::uint64_t b, unsigned) {
      const double start = thread_cpu_s();
      const std::size_t end = std::min(deposits.size(), (b + 1) * kPhotonsPerBlock);
      for (std::size_t i = b * kPhotonsPerBlock; i < end; ++i) {
        deposits[i] = deposit_of(scene, intersector, map.photon(first + i), map.radius_m());
      }
      cpu_s[begin + b] = thread_cpu_s() - start;
      monitor.advance(1);
    });

    // ... and add them up in their order on this one.
    for (const Deposit& deposit : deposits) {
      if (deposit.x >= 0) film.at(half, deposit.x, deposit.y)[Layer::caustic] += deposit.radiance;
    }
  }
  double sum = 0;
  for (double s : cpu_s) sum += s;
  return sum;
}

}  // namespace vitrail
