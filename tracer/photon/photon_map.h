/// The photon map: photons sorted into grid cells as large as the gather disc, and the flat-disc estimate on them.
//
/// Cells are hashed with a lattice: bucket = (i + j*A + k*B) mod M. Cells next to each other along the first axis are
/// next to each other in memory, so the 27 cells around a query are nine contiguous runs. A, B and M are chosen so that
/// these nine runs never overlap, hence no photon is ever counted twice; photons of far cells that share a bucket fail
/// the distance test. No bound on the extent of the scene is needed.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "photon/gather_kernel.h"

namespace vitrail {

/// One photon where it met a diffuse surface. 28 bytes.
struct PhotonRecord {
  float position[3];         // metres, relative to the frame's origin
  float flux[3];             // W per channel; already divided by the number of photons emitted
  std::int8_t normal[3];     // the surface normal on the side where the photon arrived, times 127
  std::int8_t reserved = 0;  // keeps the record free of padding
};
static_assert(sizeof(PhotonRecord) == 28);

/// Photons keep float positions relative to a double origin near the glass, so a far-away scene loses nothing.
struct PhotonFrame {
  Vec3 origin;
};

inline PhotonRecord make_photon(const PhotonFrame& frame, Vec3 position, Vec3 normal_of_arrival, Rgb flux) {
  const Vec3 p = position - frame.origin, n = normal_of_arrival;
  const auto byte = [](double c) { return static_cast<std::int8_t>(c * 127 + std::copysign(0.5, c)); };
  return {{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)},
          {static_cast<float>(flux.r), static_cast<float>(flux.g), static_cast<float>(flux.b)},
          {byte(n.x), byte(n.y), byte(n.z)}};
}

/// A place where the camera asks for the light that photons bring. 48 bytes.
struct GatherQuery {
  Vec3 position;
  Vec3 normal;  // unit, on the side the camera path came from; only photons that arrived on this side count
};

class PhotonMap {
 public:
  /// Take the photons of all blocks, in block order, and sort them into cells for discs of radius `radius_m`.
  PhotonMap(const PhotonFrame& frame, std::vector<std::vector<PhotonRecord>> blocks, double radius_m);

  /// Irradiance per channel, W/m2: the flux inside the disc of radius R on the tangent plane over pi R^2. Photons
  /// farther than R/4 from the tangent plane, or on a surface turned more than about 75 degrees away, are left out. The
  /// sum is taken in an order fixed by the photons alone: the same bits on every instruction set and thread.
  Rgb irradiance(const GatherQuery& query) const;

  std::size_t size() const { return size_; }

  /// A stored photon, in the order of the cells. The normal is rounded to bytes.
  struct Photon {
    Vec3 position, normal;
    Rgb flux;
  };
  Photon photon(std::size_t index) const;
  double radius_m() const { return radius_m_; }

  /// Peak bytes while a map of `count` photons is made; the blocks it is made from are given up on the way.
  static std::size_t predicted_bytes(std::size_t count);

 private:
  std::uint32_t row_of(std::int64_t j, std::int64_t k) const;
  int collect_runs(const float (&center)[3], PhotonRun* runs) const;
  /// A photon on its way into its cell.
  struct Bucketed {
    PhotonRecord photon;
    std::uint32_t bucket;
  };
  std::uint32_t bucket_of(const PhotonRecord& photon) const;
  void choose_lattice(const std::vector<std::vector<PhotonRecord>>& blocks);
  void sort_into_cells(std::vector<std::vector<PhotonRecord>>& blocks);
  void sort_partition(std::span<const Bucketed> partition, std::uint32_t place, std::uint32_t first,
                      std::uint32_t count);

  PhotonFrame frame_;
  double radius_m_;
  double rows_per_m_;   // across rows
  double cells_per_m_;  // along rows, finer
  std::size_t size_ = 0;
  std::array<int, 3> axis_ = {0, 1, 2};  // the longest extent first: runs of cells lie along it
  std::uint32_t mask_ = 0, stride_j_ = 0, stride_k_ = 0;
  std::vector<std::uint32_t> start_;  // first photon of each bucket, one more at the end

  /// Structure of arrays, padded by one vector so that the kernel may read past the end.
  std::array<std::vector<float>, 3> position_;
  std::array<std::vector<float>, 3> flux_;
  std::vector<std::uint32_t> normal_;  // three signed bytes
};

}  // namespace vitrail
