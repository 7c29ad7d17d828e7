#include "photon/trace.h"

#include <algorithm>
#include <array>
#include <memory>

#include "photon/photon_tree.h"
#include "photon/photon_wave.h"

namespace vitrail {
namespace {

// The solids a light ray starts in; most lights are outside every box, and then nothing else is asked.
class StartMedia {
 public:
  explicit StartMedia(const PhotonPass& pass) : intersector_(pass.intersector) {
    for (std::uint32_t i = 0; i < pass.scene.objects.size(); ++i) {
      if (pass.scene.material_of(i).transmits()) boxes_.push_back(intersector_.object_bounds(i));
    }
  }
  MediumSet at(Vec3 point) const {
    for (const Bounds& box : boxes_) {
      const bool outside = point.x < box.min.x || point.y < box.min.y || point.z < box.min.z || point.x > box.max.x ||
                           point.y > box.max.y || point.z > box.max.z;
      if (!outside) return intersector_.media_at(point);
    }
    return {};
  }

 private:
  const Intersector& intersector_;
  std::vector<Bounds> boxes_;
};

constexpr std::uint32_t kSamplesAtOnce = 256;

// Points of a block in columns, so that vector instructions map them.
struct PointColumns {
  std::array<double, kSamplesAtOnce> a, b, x, y;

  void map(std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const UnitPoint point = unit_point(a[i], b[i]);
      x[i] = point.x;
      y[i] = point.y;
    }
  }
  UnitPoint at(std::uint32_t i) const { return {a[i], b[i], x[i], y[i]}; }
};

struct SampleColumns {
  PointColumns first, second;
  bool four = false;

  void draw(Stream stream, std::uint32_t index, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
      if (four) {
        const auto u = sobol_4d(stream, index + i);
        first.a[i] = u[0];
        first.b[i] = u[1];
        second.a[i] = u[2];
        second.b[i] = u[3];
      } else {
        const auto u = sobol_2d(stream, index + i);
        first.a[i] = u[0];
        first.b[i] = u[1];
      }
    }
    first.map(count);
    if (four) second.map(count);
  }
  EmissionSample at(std::uint32_t i) const { return {first.at(i), four ? second.at(i) : UnitPoint{}}; }
};

// Emit the photons of a block and hand each to `follow(ray, media, flux, index)`.
template <typename Follow>
void emit_block(const PhotonPass& pass, const Chart& chart, Stream stream, std::uint64_t first, std::uint64_t count,
                const Follow& follow) {
  const double share = 1 / static_cast<double>(chart.count);
  const StartMedia media(pass);
  const auto samples = std::make_unique<SampleColumns>();
  samples->four = needs_four(chart);
  for (std::uint64_t done = 0; done < count; done += kSamplesAtOnce) {
    const auto size = static_cast<std::uint32_t>(std::min<std::uint64_t>(kSamplesAtOnce, count - done));
    samples->draw(stream, static_cast<std::uint32_t>(first + done), size);
    for (std::uint32_t i = 0; i < size; ++i) {
      const Emission emission = emit(chart, samples->at(i));
      if (is_black(emission.power)) continue;
      follow(emission.ray, media.at(emission.ray.origin), emission.power * share,
             static_cast<std::uint32_t>(first + done) + i);
    }
  }
}

}  // namespace

PhotonBlock trace_photons(const PhotonPass& pass, const Chart& chart, Stream stream, std::uint64_t first,
                          std::uint64_t count, PhotonWay way) {
  PhotonBlock block;
  block.photons.reserve(count);
  const Stream on_the_way = within(stream, static_cast<std::uint64_t>(Purpose::kPhotonRoughness));
  if (way == PhotonWay::automatic && PhotonWave::suits(pass.scene)) {
    PhotonWave wave(pass, chart.target, on_the_way, block);
    emit_block(pass, chart, stream, first, count,
               [&](const Ray& ray, const MediumSet& inside, Rgb flux, std::uint32_t) { wave.add(ray, inside, flux); });
    wave.finish();
  } else {
    PhotonTree tree(pass, chart.target, on_the_way, block);
    emit_block(pass, chart, stream, first, count,
               [&](const Ray& ray, const MediumSet& inside, Rgb flux, std::uint32_t index) {
                 Flight flight{ray, {}, inside, flux, kLeastPhotonShare * largest_channel(flux)};
                 flight.index = index;
                 tree.follow(flight);
               });
  }
  return block;
}

}  // namespace vitrail
