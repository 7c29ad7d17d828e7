#include "photon/trace.h"

#include "photon/photon_tree.h"
#include "photon/photon_wave.h"

namespace vitrail {
namespace {

// Emit the photons of a block and hand each to `follow(ray, media, flux)`.
template <typename Follow>
void emit_block(const PhotonPass& pass, const Chart& chart, Stream stream, std::uint64_t first, std::uint64_t count,
                const Follow& follow) {
  const double share = 1 / static_cast<double>(chart.count);
  const bool flat = !needs_four(chart);
  for (std::uint64_t i = first; i < first + count; ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    EmissionSample sample{};
    if (flat) {
      const auto [a, b] = sobol_2d(stream, index);
      sample = {a, b, 0, 0};
    } else {
      sample = sobol_4d(stream, index);
    }
    const Emission emission = emit(chart, sample);
    if (is_black(emission.power)) continue;
    follow(emission.ray, pass.intersector.media_at(emission.ray.origin), emission.power * share);
  }
}

}  // namespace

PhotonBlock trace_photons(const PhotonPass& pass, const Chart& chart, Stream stream, std::uint64_t first,
                          std::uint64_t count, PhotonWay way) {
  PhotonBlock block;
  block.photons.reserve(count);
  if (way == PhotonWay::automatic && PhotonWave::suits(pass.scene)) {
    PhotonWave wave(pass, chart.target, block);
    emit_block(pass, chart, stream, first, count,
               [&](const Ray& ray, const MediumSet& media, Rgb flux) { wave.add(ray, media, flux); });
    wave.finish();
  } else {
    PhotonTree tree(pass, chart.target, block);
    emit_block(pass, chart, stream, first, count, [&](const Ray& ray, const MediumSet& media, Rgb flux) {
      tree.follow({ray, {}, media, flux, kLeastPhotonShare * largest_channel(flux)});
    });
  }
  return block;
}

}  // namespace vitrail
