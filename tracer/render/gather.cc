#include "render/gather.h"

#include <algorithm>
#include <array>

#include "light/sampling.h"

namespace vitrail {
namespace {

// A disc is looked into this often per pixel and half, shared out over the pixel's samples.
constexpr int kDiscSamplesPerPixel = 16;

// The answers to the requests of one half of one pixel.
class Gatherer {
 public:
  Gatherer(const LitWorld& world, const Picture& picture, std::uint64_t pixel, int half)
      : maps_(world.maps.caustic),
        settings_(world.scene.settings),
        half_(half),
        looks_(std::max(1, kDiscSamplesPerPixel / std::max(1, picture.samples))),
        stream_(stream_of(settings_.seed, Purpose::kGatherDisc, pixel, static_cast<std::uint64_t>(half))) {}

  Rgb irradiance(const GatherRequest& request) {
    if (!settings_.gather_disc || !maps_.beams[half_] || !request.on_flat)
      return maps_.irradiance(half_, request.query);
    const Rgb by_photons = maps_.half[half_] ? maps_.half[half_]->irradiance(request.query) : Rgb{};
    return by_photons + mean_of_beams(request.query);
  }

 private:
  // Photons are gathered over the disc; beams are looked up in places drawn evenly from it. The order of the points is
  // their own, or they would go with those of the pixel.
  Rgb mean_of_beams(const GatherQuery& query) {
    const SurfaceFrame frame = surface_frame(query.normal);
    Rgb sum;
    for (int i = 0; i < looks_; ++i) {
      const auto [a, b] = padded_2d(stream_, drawn_++);
      const UnitPoint place = unit_point(a, b);
      const Vec3 aside = (frame.u * place.x + frame.v * place.y) * settings_.gather_radius_m;
      sum += maps_.beams[half_]->irradiance({query.position + aside, query.normal});
    }
    return sum * (1.0 / looks_);
  }

  const PhotonMaps& maps_;
  const Settings& settings_;
  int half_, looks_;
  Stream stream_;
  std::uint32_t drawn_ = 0;
};

}  // namespace

void gather(const LitWorld& world, const Picture& picture, const Tile& tile, const std::vector<GatherRequest>& requests,
            Film& film) {
  const auto width = static_cast<std::uint32_t>(tile.x1 - tile.x0);
  for (std::size_t begin = 0, end = 0; begin < requests.size(); begin = end) {
    const std::uint32_t in_tile = requests[begin].pixel;
    while (end < requests.size() && requests[end].pixel == in_tile) ++end;
    const int x = tile.x0 + static_cast<int>(in_tile % width), y = tile.y0 + static_cast<int>(in_tile / width);
    const auto pixel =
        static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(picture.image.width) + static_cast<std::uint64_t>(x);
    for (int half = 0; half < 2; ++half) {
      Gatherer gatherer(world, picture, pixel, half);
      Rgb sum;
      for (std::size_t r = begin; r < end; ++r) {
        if (requests[r].both_halves || requests[r].half == half)
          sum += requests[r].weight * gatherer.irradiance(requests[r]);
      }
      film.add(half, x, y, Layer::caustic, sum);
    }
  }
}

}  // namespace vitrail
