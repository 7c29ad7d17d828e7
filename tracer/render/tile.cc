#include "render/tile.h"

#include <algorithm>

#include "base/cpu_clock.h"
#include "light/light.h"
#include "render/camera.h"
#include "render/gather.h"

namespace vitrail {
namespace {

constexpr int kTileSide = 32;

// A light with an extent is sampled this often per pixel, shared out over the pixel's samples.
constexpr int kLightSamplesPerPixel = 16;

// The samples of one pixel: one through its centre, or two independent sets of Owen-Sobol points.
struct PixelSampler {
  int per_half;
  bool centred;  // one sample, through the centre, ...
  bool shared;   // ... which serves both halves where nothing but the photons to gather tells them apart

  PixelSampler(const Scene& scene, int samples)
      : per_half(std::max(1, (samples + 1) / 2)), centred(samples <= 1), shared(centred && !is_random(scene)) {}

  // Whether two paths through one place may see two things: by rough faces, lamps with an extent, or a final gather.
  static bool is_random(const Scene& scene) {
    const bool extended =
        std::any_of(scene.lights.begin(), scene.lights.end(), [](const Light& light) { return !is_delta(light); });
    return extended || scene.plan.roughness || scene.transport.indirect == Indirect::photons;
  }

  std::array<double, 2> at(std::uint64_t seed, std::uint64_t pixel, int half, int sample) const {
    if (centred) return {0.5, 0.5};
    const Stream stream = stream_of(seed, Purpose::kPixel, pixel, static_cast<std::uint64_t>(half));
    return sobol_2d(stream, static_cast<std::uint32_t>(sample));
  }
};

// Follow every sample of a pixel and add what is seen at once; leave the rest in `requests`.
class PixelRenderer {
 public:
  PixelRenderer(const LitWorld& world, const Picture& picture, Film& film, TileStatistics& statistics)
      : world_(world),
        picture_(picture),
        film_(film),
        statistics_(statistics),
        sampler_(world.scene, picture.samples),
        tracer_(world),
        media_(world.intersector.media_at(picture.camera.position)) {}

  void render(int x, int y, std::uint32_t pixel_in_tile, std::vector<GatherRequest>& requests) {
    const double share = 1.0 / sampler_.per_half;
    bool shared = sampler_.shared;
    for (int half = 0; half < (shared ? 1 : 2); ++half) {
      HalfPixel sum;
      for (int sample = 0; sample < sampler_.per_half; ++sample) {
        trace_sample(x, y, half, sample);
        shared = shared && !result_.left_to_chance;
        for (int l = 0; l < kLayerCount; ++l) sum.layers[l] += result_.radiance.layers[l];
        for (GatherRequest request : result_.requests) {
          request.weight = request.weight * share;
          request.pixel = pixel_in_tile;
          request.half = static_cast<std::uint8_t>(half);
          request.both_halves = shared;
          requests.push_back(request);
        }
      }
      if (sampler_.per_half > 1) {
        for (Rgb& layer : sum.layers) layer = layer * share;
      }
      film_.add(half, x, y, sum);
      if (shared) film_.add(1, x, y, sum);
    }
  }

 private:
  void trace_sample(int x, int y, int half, int sample) {
    const std::uint64_t seed = world_.scene.settings.seed;
    const auto pixel = static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(picture_.image.width) +
                       static_cast<std::uint64_t>(x);
    const auto [dx, dy] = sampler_.at(seed, pixel, half, sample);
    CameraPath path{};
    path.ray = camera_ray(picture_.camera, picture_.image, x + dx, y + dy);
    const bool from_one_place = picture_.camera.kind == CameraKind::perspective;
    path.media = from_one_place ? media_ : world_.intersector.media_at(path.ray.origin);
    path.branch = stream_of(seed, Purpose::kCameraBranch, pixel, static_cast<std::uint64_t>(half));
    path.half = half;
    // Where nothing is random but which weak branches are followed, nothing else is drawn.
    if (!sampler_.shared) {
      const auto stream = [&](Purpose purpose) {
        return stream_of(seed, purpose, pixel, static_cast<std::uint64_t>(half));
      };
      path.draw = {stream(Purpose::kLightSample), static_cast<std::uint32_t>(sample)};
      path.rough = stream(Purpose::kCameraRoughness);
      path.gather = stream(Purpose::kFinalGather);
      path.light_samples = std::max(1, kLightSamplesPerPixel / std::max(1, picture_.samples));
    }
    tracer_.trace(path, result_);
    statistics_.counters.camera_rays += result_.rays;
    statistics_.counters.shadow_rays += result_.shadow_rays;
    statistics_.ledger.add_look();
    for (const CutBranch& branch : result_.cut) statistics_.ledger.add(branch);
    statistics_.ledger.add(result_.light);
  }

  const LitWorld& world_;
  const Picture& picture_;
  Film& film_;
  TileStatistics& statistics_;
  PixelSampler sampler_;
  CameraTracer tracer_;
  MediumSet media_;  // around the place where a perspective camera stands
  PathResult result_;
};

}  // namespace

TileStatistics& TileStatistics::operator+=(const TileStatistics& other) {
  counters += other.counters;
  ledger += other.ledger;
  camera_cpu_s += other.camera_cpu_s;
  gather_cpu_s += other.gather_cpu_s;
  return *this;
}

std::vector<Tile> tiles_of(const Image& image) {
  std::vector<Tile> tiles;
  for (int y = 0; y < image.height; y += kTileSide) {
    for (int x = 0; x < image.width; x += kTileSide) {
      tiles.push_back({x, y, std::min(x + kTileSide, image.width), std::min(y + kTileSide, image.height)});
    }
  }
  return tiles;
}

TileStatistics render_tile(const LitWorld& world, const Picture& picture, const Tile& tile, Film& film) {
  TileStatistics statistics;
  std::vector<GatherRequest> requests;
  const double start = thread_cpu_s();
  PixelRenderer renderer(world, picture, film, statistics);
  std::uint32_t pixel = 0;
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) renderer.render(x, y, pixel++, requests);
  }
  statistics.ledger.close({tile.x0, tile.y0, tile.x1, tile.y1});
  const double traced = thread_cpu_s();
  statistics.camera_cpu_s = traced - start;
  gather(world, picture, tile, requests, film);
  for (const GatherRequest& request : requests) statistics.counters.gather_queries += request.both_halves ? 2 : 1;
  statistics.gather_cpu_s = thread_cpu_s() - traced;
  return statistics;
}

}  // namespace vitrail
