#include "photon/trace.h"

#include <algorithm>
#include <memory>

#include "photon/photon_tree.h"
#include "photon/wave/photon_wave.h"

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
  bool is_outside(Vec3 point) const {
    for (const Bounds& box : boxes_) {
      const bool outside = point.x < box.min.x || point.y < box.min.y || point.z < box.min.z || point.x > box.max.x ||
                           point.y > box.max.y || point.z > box.max.z;
      if (!outside) return false;
    }
    return true;
  }
  MediumSet at(Vec3 point) const { return is_outside(point) ? MediumSet{} : intersector_.media_at(point); }

 private:
  const Intersector& intersector_;
  std::vector<Bounds> boxes_;
};

// Photons under way at once: enough to fill the vectors to the last branch, few enough to stay in the cache.
constexpr std::size_t kAtOnce = 256;

// Draw the points, and map them all together.
void draw(const Chart& chart, Stream stream, std::uint32_t first, std::size_t count, EmissionColumns& columns) {
  const bool four = needs_four(chart);
  columns.count = count;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t index = first + static_cast<std::uint32_t>(i);
    if (four) {
      const auto u = sobol_4d(stream, index);
      columns.first.a[i] = u[0];
      columns.first.b[i] = u[1];
      columns.second.a[i] = u[2];
      columns.second.b[i] = u[3];
    } else {
      const auto u = sobol_2d(stream, index);
      columns.first.a[i] = u[0];
      columns.first.b[i] = u[1];
    }
  }
  columns.first.map(count);
  if (four) columns.second.map(count);
}

// Emit the photons of a block and hand them on, some at a time, with the index of the first.
template <typename Follow>
void emit_block(const Chart& chart, Stream stream, std::uint64_t first, std::uint64_t count, const Follow& follow) {
  const double share = 1 / static_cast<double>(chart.count);
  const auto columns = std::make_unique<EmissionColumns>();
  for (std::uint64_t done = 0; done < count; done += EmissionColumns::kCapacity) {
    const auto size = static_cast<std::size_t>(std::min<std::uint64_t>(EmissionColumns::kCapacity, count - done));
    const auto index = static_cast<std::uint32_t>(first + done);
    draw(chart, stream, index, size, *columns);
    emit(chart, *columns);
    for (auto& channel : columns->power) {
      for (std::size_t i = 0; i < size; ++i) channel[i] *= share;
    }
    follow(*columns, index);
  }
}

Ray ray_of(const EmissionColumns& columns, std::size_t i) {
  return {{columns.origin[0][i], columns.origin[1][i], columns.origin[2][i]},
          {columns.direction[0][i], columns.direction[1][i], columns.direction[2][i]}};
}

Rgb power_of(const EmissionColumns& columns, std::size_t i) {
  return {columns.power[0][i], columns.power[1][i], columns.power[2][i]};
}

}  // namespace

PhotonBlock trace_photons(const PhotonPass& pass, const Chart& chart, Stream stream, std::uint64_t first,
                          std::uint64_t count, Strategy strategy) {
  PhotonBlock block;
  block.photons.reserve(count);
  const Stream lots = within(stream, static_cast<std::uint64_t>(Purpose::kPhotonRoughness));
  const BandCombs combs(pass.scene, chart, stream);
  const PhotonBranches branches = pass.scene.settings.branch_share == 0 ? PhotonBranches() : PhotonBranches(lots);
  const StartMedia media(pass);
  if (strategy == Strategy::automatic && PhotonWave::suits(pass.scene)) {
    PhotonWave wave(pass, chart.target, lots, combs, branches, block);
    emit_block(chart, stream, first, count, [&](const EmissionColumns& columns, std::uint32_t index) {
      for (std::size_t i = 0; i < columns.count; ++i) {
        const Rgb power = power_of(columns, i);
        if (is_black(power)) continue;
        const Ray ray = ray_of(columns, i);
        const auto own = index + static_cast<std::uint32_t>(i);
        media.is_outside(ray.origin) ? wave.add(ray, power, own) : wave.add(ray, media.at(ray.origin), power, own);
      }
      if (wave.size() >= kAtOnce) wave.finish();
    });
    wave.finish();
  } else {
    PhotonStore store(pass.frame, block);
    PhotonTree tree(pass, chart.target, lots, store, block.ledger, combs, branches);
    emit_block(chart, stream, first, count, [&](const EmissionColumns& columns, std::uint32_t index) {
      for (std::size_t i = 0; i < columns.count; ++i) {
        const Rgb power = power_of(columns, i);
        if (is_black(power)) continue;
        const Ray ray = ray_of(columns, i);
        tree.follow({.path = {.ray = ray, .media = media.at(ray.origin), .weight = power},
                     .least = kLeastPhotonShare * largest_channel(power),
                     .index = index + static_cast<std::uint32_t>(i)});
      }
    });
  }
  return block;
}

}  // namespace vitrail
