#include "photon/photon_map.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

// For readers of pbrt: this is the photon map of [J96], not that of progressive photon mapping (pbrt's SPPM stores the
// camera's visible points and streams photons past them). Photons are stored and sorted once, then the camera asks for
// irradiance at points.
//
// The grid is uniform and hashed. A cell is as wide as the gather disc's reach across rows and half of that along them,
// so a query touches 3 x 3 rows of cells. A row's cells have consecutive bucket numbers, and photons are sorted by
// bucket, so a query reads nine contiguous runs of the sorted arrays, whatever lies in them: no tree, no pointers, no
// priority queue. Photons of far cells that share a bucket are rejected by their distance. `choose_lattice` picks a
// dense grid where the photons fill a compact box, and a hash with odd strides otherwise; `rows_stay_apart` ensures
// that the nine runs never overlap, so that no photon counts twice.
//
// The sort is a radix sort of two passes: into at most 2^8 partitions by the leading bits of the bucket, then each
// partition by counting. Each pass writes to few enough places at a time to stay in the cache, and both are stable, so
// the order of photons, and with it every sum, depends on the order of emission alone.

namespace vitrail {
namespace {

constexpr std::size_t kPadding = PhotonColumns::kPadding;
constexpr int kRadixBits = 8;  // photons are first sorted into 2^8 partitions

// Photons at most R/4 off the tangent plane lie at most sqrt(1 + 1/16) R = 1.0308 R away; 33/32 R covers that with
// room for rounding. Cells are that wide across rows, and half of it along them, so that runs fit the disc closely.
constexpr double kOffsetLimit = 0.25;
constexpr double kReachPerRadius = 33.0 / 32;
constexpr int kCellsPerReach = 2;

// The photon's normal must have a quarter of the query normal's largest component: cos 75 degrees at most.
constexpr double kNormalAgreement = 0.25;

// Cell coordinates saturate far away; saturation keeps neighbours neighbours.
std::int64_t cell_of(double metres, double cells_per_m) {
  constexpr double kLimit = 1 << 28;
  return static_cast<std::int64_t>(std::floor(std::clamp(metres * cells_per_m, -kLimit, kLimit)));
}

// Rows (dj, dk) at most two cells apart must differ by more than a run reaches to both sides, in either direction.
bool rows_stay_apart(std::uint32_t a, std::uint32_t b, std::uint32_t mask) {
  constexpr std::uint32_t kLongestRun = 2 * (kCellsPerReach + 1) + 1;
  for (int dj = -2; dj <= 2; ++dj) {
    for (int dk = -2; dk <= 2; ++dk) {
      if (dj == 0 && dk == 0) continue;
      const std::uint32_t shift = (static_cast<std::uint32_t>(dj) * a + static_cast<std::uint32_t>(dk) * b) & mask;
      if (shift < kLongestRun || mask - shift < kLongestRun) return false;
    }
  }
  return true;
}

}  // namespace

PhotonMap::PhotonMap(const PhotonFrame& frame, std::vector<std::vector<PhotonRecord>> blocks, double radius_m)
    : frame_(frame),
      radius_m_(radius_m),
      rows_per_m_(1 / (radius_m * kReachPerRadius)),
      cells_per_m_(kCellsPerReach * rows_per_m_) {
  for (const auto& block : blocks) size_ += block.size();
  if (size_ == 0) return;
  choose_lattice(blocks);
  sort_into_cells(blocks);
}

// Take a dense grid where the photons fill a compact box, and scattered rows where they do not.
void PhotonMap::choose_lattice(const std::vector<std::vector<PhotonRecord>>& blocks) {
  std::array<float, 3> low, high;
  low.fill(std::numeric_limits<float>::infinity());
  high.fill(-std::numeric_limits<float>::infinity());
  for (const auto& block : blocks) {
    for (const PhotonRecord& photon : block) {
      for (int a = 0; a < 3; ++a) {
        low[a] = std::min(low[a], photon.position[a]);
        high[a] = std::max(high[a], photon.position[a]);
      }
    }
  }
  std::sort(axis_.begin(), axis_.end(), [&](int a, int b) {
    const float extent_a = high[a] - low[a], extent_b = high[b] - low[b];
    return extent_a != extent_b ? extent_a > extent_b : a < b;
  });
  double cells[3];
  for (int a = 0; a < 3; ++a) {
    const double per_m = a == 0 ? cells_per_m_ : rows_per_m_;
    cells[a] = std::ceil((static_cast<double>(high[axis_[a]]) - low[axis_[a]]) * per_m) + 4 * kCellsPerReach;
  }

  // Spend at most two buckets a photon on a dense grid; hash with odd strides otherwise.
  const double most = std::max(65536.0, 2.0 * static_cast<double>(size_));
  const double dense = cells[0] * cells[1] * cells[2];
  if (dense <= most) {
    mask_ = std::bit_ceil(static_cast<std::uint32_t>(dense)) - 1;
    stride_j_ = static_cast<std::uint32_t>(cells[0]);
    stride_k_ = stride_j_ * static_cast<std::uint32_t>(cells[1]);
  } else {
    mask_ = std::bit_ceil(static_cast<std::uint32_t>(std::min(most, 0x1p31))) - 1;
    stride_j_ = 0x9e3779b1u & mask_;
    stride_k_ = 0x85ebca77u & mask_;
  }
  while (!rows_stay_apart(stride_j_, stride_k_, mask_)) {
    stride_j_ = (stride_j_ + 6) & mask_;
    stride_k_ = (stride_k_ * 5 + 34) & mask_;
  }
}

std::uint32_t PhotonMap::row_of(std::int64_t j, std::int64_t k) const {
  return static_cast<std::uint32_t>(j) * stride_j_ + static_cast<std::uint32_t>(k) * stride_k_;
}

std::uint32_t PhotonMap::bucket_of(const PhotonRecord& photon) const {
  const std::int64_t i = cell_of(photon.position[axis_[0]], cells_per_m_);
  const std::int64_t j = cell_of(photon.position[axis_[1]], rows_per_m_);
  const std::int64_t k = cell_of(photon.position[axis_[2]], rows_per_m_);
  return (static_cast<std::uint32_t>(i) + row_of(j, k)) & mask_;
}

// Sort in two steps that each stay in the cache: by the leading bits of the bucket into a few hundred partitions, then
// each partition by counting. Both are stable, so photons of a cell keep the order of emission.
void PhotonMap::sort_into_cells(std::vector<std::vector<PhotonRecord>>& blocks) {
  const int low_bits = std::max(0, static_cast<int>(std::bit_width(mask_)) - kRadixBits);
  const std::size_t partition_count = static_cast<std::size_t>(mask_ >> low_bits) + 1;
  std::vector<std::uint32_t> partition_start(partition_count + 2, 0), bucket(size_);
  std::size_t next = 0;
  for (const auto& block : blocks) {
    for (const PhotonRecord& photon : block) {
      bucket[next] = bucket_of(photon);
      ++partition_start[(bucket[next++] >> low_bits) + 2];
    }
  }
  for (std::size_t h = 2; h < partition_start.size(); ++h) partition_start[h] += partition_start[h - 1];

  // Give up each block as soon as it is in the partitions.
  std::vector<Bucketed> partitions(size_);
  next = 0;
  for (auto& block : blocks) {
    for (const PhotonRecord& photon : block) {
      const std::uint32_t b = bucket[next++];
      partitions[partition_start[(b >> low_bits) + 1]++] = {photon, b};
    }
    std::vector<PhotonRecord>().swap(block);
  }

  start_.resize(static_cast<std::size_t>(mask_) + 2);
  for (auto& column : position_) column.resize(size_ + kPadding);
  for (auto& column : flux_) column.resize(size_ + kPadding);
  normal_.resize(size_ + kPadding);
  for (std::size_t h = 0; h < partition_count; ++h) {
    sort_partition({partitions.data() + partition_start[h], partitions.data() + partition_start[h + 1]},
                   partition_start[h], static_cast<std::uint32_t>(h) << low_bits, std::uint32_t{1} << low_bits);
  }
  start_.back() = static_cast<std::uint32_t>(size_);
}

// Counting sort of the buckets first .. first + count into the columns from `place` on.
void PhotonMap::sort_partition(std::span<const Bucketed> partition, std::uint32_t place, std::uint32_t first,
                               std::uint32_t count) {
  std::uint32_t* const start = start_.data() + first;
  std::fill(start, start + count, 0);
  for (const Bucketed& h : partition) ++start[h.bucket - first];
  for (std::uint32_t b = 0; b < count; ++b) {
    const std::uint32_t photons = start[b];
    start[b] = place;
    place += photons;
  }
  for (const Bucketed& h : partition) {
    const std::uint32_t to = start[h.bucket - first]++;
    for (int a = 0; a < 3; ++a) {
      position_[a][to] = h.photon.position[axis_[a]];
      flux_[a][to] = h.photon.flux[a];
    }
    const auto byte = [&](int a) { return static_cast<std::uint32_t>(static_cast<std::uint8_t>(h.photon.normal[a])); };
    normal_[to] = byte(axis_[0]) | byte(axis_[1]) << 8 | byte(axis_[2]) << 16;
  }

  // Each start has moved to the end of its bucket, which is the start of the next: move them back by one.
  for (std::uint32_t b = count; b-- > 1;) start[b] = start[b - 1];
  if (count > 0) start[0] = place - static_cast<std::uint32_t>(partition.size());
}

PhotonMap::Photon PhotonMap::photon(std::size_t index) const {
  Photon photon;
  for (int a = 0; a < 3; ++a) {
    photon.position[axis_[a]] = position_[a][index];
    photon.normal[axis_[a]] = static_cast<std::int8_t>((normal_[index] >> (8 * a)) & 255u) / 127.0;
    photon.flux[a] = flux_[a][index];
  }
  photon.position += frame_.origin;
  return photon;
}

// Collect the occupied runs of the nine rows around a point, each cut to the chord of the sphere that the disc lies in.
int PhotonMap::collect_runs(const float (&center)[3], PhotonRun* runs) const {
  const double reach = radius_m_ * kReachPerRadius;
  const std::int64_t row[2] = {cell_of(center[1], rows_per_m_), cell_of(center[2], rows_per_m_)};
  double gap_squared[2][3];
  for (int a = 0; a < 2; ++a) {
    const double below = center[1 + a] - static_cast<double>(row[a]) * reach;
    gap_squared[a][0] = below * below;
    gap_squared[a][1] = 0;
    gap_squared[a][2] = (reach - below) * (reach - below);
  }
  int count = 0;
  for (int dk = -1; dk <= 1; ++dk) {
    for (int dj = -1; dj <= 1; ++dj) {
      const double left = reach * reach - gap_squared[0][dj + 1] - gap_squared[1][dk + 1];
      if (!(left > 0)) continue;
      const double half = std::sqrt(left);
      const std::int64_t first = cell_of(center[0] - half, cells_per_m_);
      const std::int64_t last = cell_of(center[0] + half, cells_per_m_);
      const std::uint32_t bucket = (static_cast<std::uint32_t>(first) + row_of(row[0] + dj, row[1] + dk)) & mask_;
      const std::uint32_t cells = static_cast<std::uint32_t>(last - first) + 1;

      // A run that wraps around the table has two pieces.
      const std::uint32_t in_table = std::min(cells, mask_ - bucket + 1);
      const PhotonRun run{start_[bucket], start_[bucket + in_table]};
      if (run.begin != run.end) runs[count++] = run;
      if (in_table < cells && start_[cells - in_table] != 0) runs[count++] = {0, start_[cells - in_table]};
    }
  }
  return count;
}

Rgb PhotonMap::irradiance(const GatherQuery& query) const {
  if (size_ == 0) return {0, 0, 0};
  const Vec3 from_origin = query.position - frame_.origin;
  const double p[3] = {from_origin.x, from_origin.y, from_origin.z};
  const double n[3] = {query.normal.x, query.normal.y, query.normal.z};

  // Describe the disc in the floats of the frame and the axis order of the cells.
  GatherDisc disc;
  int largest = 0;
  for (int a = 0; a < 3; ++a) {
    disc.center[a] = static_cast<float>(p[axis_[a]]);
    disc.normal[a] = static_cast<float>(n[axis_[a]]);
    if (std::abs(disc.normal[a]) > std::abs(disc.normal[largest])) largest = a;
  }
  disc.radius_squared = static_cast<float>(radius_m_ * radius_m_);
  disc.offset_squared = static_cast<float>(kOffsetLimit * kOffsetLimit * radius_m_ * radius_m_);
  disc.normal_shift = 24 - 8 * largest;
  disc.normal_flip = disc.normal[largest] < 0 ? -1 : 0;
  const double least = std::max(1.0, kNormalAgreement * 127 * std::abs(disc.normal[largest]));
  disc.normal_least = static_cast<std::int32_t>(least) << 24;

  PhotonRun runs[2 * 9];
  const int run_count = collect_runs(disc.center, runs);
  const PhotonColumns columns{{position_[0].data(), position_[1].data(), position_[2].data()},
                              {flux_[0].data(), flux_[1].data(), flux_[2].data()},
                              normal_.data()};
  return flux_in_disc(columns, runs, run_count, disc) * (1 / (M_PI * radius_m_ * radius_m_));
}

std::size_t PhotonMap::predicted_bytes(std::size_t count) {
  const std::size_t columns = 7 * sizeof(float) * (count + kPadding);
  const std::size_t table = sizeof(std::uint32_t) * std::bit_ceil(std::max<std::size_t>(65536, 2 * count));
  const std::size_t on_the_way = (sizeof(Bucketed) + sizeof(std::uint32_t)) * count;
  return columns + table + on_the_way;
}

}  // namespace vitrail
