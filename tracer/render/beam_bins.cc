#include "render/beam_bins.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "render/camera.h"
#include "render/first_hit.h"
#include "render/pixel_sums.h"
#include "render/polygon.h"

namespace vitrail {
namespace {

constexpr std::size_t kBeamsPerBlock = 1024, kBlocksAtOnce = 256;

// In the image a beam is taken as evenly lit. It is cut in four while perspective makes its corners differ by more.
constexpr double kPerspective = 1.05;
constexpr int kMostCuts = 8;

// A camera ray must end this close to the plane of the beam, of the distances involved.
constexpr double kRounding = 0x1p-36;

struct Deposit {
  int x, y;
  Rgb radiance;
};

/// A beam, or a part of one: where its corners are, and what the whole chart would bring to each.
struct Piece {
  std::array<Vec3, 3> corner;
  std::array<Rgb, 3> power;
  double share;
};

class BeamPainter {
 public:
  BeamPainter(const World& world, const Picture& picture) : picture_(picture), camera_(world, picture) {}

  void paint(const BeamMap& map, std::size_t index, std::vector<Deposit>& deposits) {
    const Beam& beam = map.beam(index);
    sides_ = map.sides_of(beam);
    Piece piece{{sides_.p, sides_.q, sides_.r}, {}, beam.share};
    normal_ = {};
    for (int k = 0; k < 3; ++k) {
      const BeamCorner& corner = map.corner(beam.corner[k]);
      piece.power[k] = {corner.power[0], corner.power[1], corner.power[2]};
      normal_ += Vec3{corner.normal[0], corner.normal[1], corner.normal[2]};
    }
    const Vec3 across = cross(sides_.q - sides_.p, sides_.r - sides_.p);
    plane_ = dot(across, across) > 0 ? normalise(across) : Vec3{};
    deposits_ = &deposits;
    paint(piece, kMostCuts);
  }

 private:
  void paint(const Piece& piece, int cuts) {
    std::array<ImagePoint, 3> seen;
    int visible = 0;
    double least = INFINITY, most = 0;
    for (const Vec3& corner : piece.corner) {
      const std::optional<ImagePoint> point = project(picture_.camera, picture_.image, corner);
      if (!point) continue;
      seen[visible++] = *point;
      least = std::min(least, point->pixels_per_facing_m2);
      most = std::max(most, point->pixels_per_facing_m2);
    }
    if (visible == 0) return;
    if (visible == 3 && is_off_image(seen)) return;
    if (cuts > 0 && (visible < 3 || most > kPerspective * least)) {
      paint_quarters(piece, cuts - 1);
    } else if (visible == 3) {
      paint_flat(piece, seen);
    }
  }

  void paint_quarters(const Piece& piece, int cuts) {
    std::array<Vec3, 3> middle;
    std::array<Rgb, 3> power;
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      middle[k] = (piece.corner[k] + piece.corner[next]) * 0.5;
      power[k] = (piece.power[k] + piece.power[next]) * 0.5;
    }
    for (int k = 0; k < 3; ++k) {
      const int before = (k + 2) % 3;
      paint({{piece.corner[k], middle[k], middle[before]}, {piece.power[k], power[k], power[before]}, piece.share / 4},
            cuts);
    }
    paint({middle, power, piece.share / 4}, cuts);
  }

  bool is_off_image(const std::array<ImagePoint, 3>& seen) const {
    const auto [left, right] = std::minmax({seen[0].x, seen[1].x, seen[2].x});
    const auto [top, bottom] = std::minmax({seen[0].y, seen[1].y, seen[2].y});
    return right < 0 || bottom < 0 || left >= picture_.image.width || top >= picture_.image.height;
  }

  // Cut the piece into rows and those into columns, within the image.
  void paint_flat(const Piece& piece, const std::array<ImagePoint, 3>& seen) {
    Polygon whole;
    for (const ImagePoint& point : seen) whole.add({point.x, point.y});
    const double area = area_of(whole).area;
    const auto [left, right] = columns_of(whole);
    const auto [top, bottom] = rows_of(whole);
    if (!(area > 0) || (left == right && top == bottom)) {
      deposit(piece, seen, area_of(whole).middle, 1);
      return;
    }
    for (int y = top; y <= bottom; ++y) {
      const Polygon row = between_rows(whole, y, y + 1);
      const auto [first, last] = columns_of(row);
      for (int x = first; x <= last; ++x) {
        const AreaAndMiddle part = area_of(between_columns(row, x, x + 1));
        if (part.area > 0) deposit(piece, seen, part.middle, part.area / area);
      }
    }
  }

  // The first and last pixel that a polygon touches, within the image.
  std::array<int, 2> columns_of(const Polygon& polygon) const {
    double low = INFINITY, high = -INFINITY;
    for (int k = 0; k < polygon.size; ++k) {
      low = std::min(low, polygon.corners[k].x);
      high = std::max(high, polygon.corners[k].x);
    }
    return within_image(low, high, picture_.image.width);
  }
  std::array<int, 2> rows_of(const Polygon& polygon) const {
    double low = INFINITY, high = -INFINITY;
    for (int k = 0; k < polygon.size; ++k) {
      low = std::min(low, polygon.corners[k].y);
      high = std::max(high, polygon.corners[k].y);
    }
    return within_image(low, high, picture_.image.height);
  }
  static std::array<int, 2> within_image(double low, double high, int size) {
    if (!(low <= high)) return {0, -1};
    return {static_cast<int>(std::floor(std::clamp(low, 0.0, size - 1.0))),
            static_cast<int>(std::floor(std::clamp(high, 0.0, size - 1.0)))};
  }

  // Give a share of the piece to the pixel around a place of the image, if the surface is what is seen there.
  void deposit(const Piece& piece, const std::array<ImagePoint, 3>& seen, Polygon::Corner place, double share) {
    const int x = static_cast<int>(std::floor(place.x)), y = static_cast<int>(std::floor(place.y));
    if (x < 0 || y < 0 || x >= picture_.image.width || y >= picture_.image.height) return;
    const FirstHit hit = camera_.through(place.x, place.y);
    const Arrival& arrival = hit.arrival;
    if (arrival.escaped || !(dot(arrival.event.facing_normal, normal_) > 0) || is_elsewhere(arrival.hit.point)) return;
    const double pixels_per_m2 = seen_at(arrival.hit.point, seen) * hit.cosine, ratio = hit.ior_ratio;
    deposits_->push_back({x, y,
                          arrival.transmittance * arrival.event.diffuse * power_at(piece, seen, place) *
                              (piece.share * share * pixels_per_m2 * ratio * ratio / M_PI)});
  }

  bool is_elsewhere(Vec3 point) const {
    const Vec3 from_beam = point - sides_.p;
    const double rounding = kRounding * (sides_.longest + length(point) + length(picture_.camera.position));
    return length(from_beam) > 2 * sides_.longest + rounding ||
           std::abs(dot(from_beam, plane_)) > sides_.room + rounding;
  }

  double seen_at(Vec3 point, const std::array<ImagePoint, 3>& seen) const {
    const std::optional<ImagePoint> there = project(picture_.camera, picture_.image, point);
    return there ? there->pixels_per_facing_m2 : seen[0].pixels_per_facing_m2;
  }

  // Between the corners the power is taken as linear in the image; as their mean where they lie on a line.
  static Rgb power_at(const Piece& piece, const std::array<ImagePoint, 3>& seen, Polygon::Corner place) {
    const double ax = seen[1].x - seen[0].x, ay = seen[1].y - seen[0].y;
    const double bx = seen[2].x - seen[0].x, by = seen[2].y - seen[0].y;
    const double px = place.x - seen[0].x, py = place.y - seen[0].y, twice = ax * by - bx * ay;
    double v = 1.0 / 3, w = 1.0 / 3;
    if (twice != 0) {
      v = std::clamp((px * by - bx * py) / twice, 0.0, 1.0);
      w = std::clamp((ax * py - px * ay) / twice, 0.0, 1.0 - v);
    }
    return piece.power[0] * (1 - v - w) + piece.power[1] * v + piece.power[2] * w;
  }

  const Picture& picture_;
  FirstHitFinder camera_;
  BeamMap::Sides sides_;
  Vec3 normal_, plane_;  // of the surface where the beam lands, of any length; of the beam's plane, unit or nothing
  std::vector<Deposit>* deposits_ = nullptr;
};

}  // namespace

std::size_t deposit_blocks(const BeamMap& map) { return (map.size() + kBeamsPerBlock - 1) / kBeamsPerBlock; }

double deposit_beams(const World& world, const Picture& picture, const BeamMap& map, int half, const Workers& workers,
                     Film& film) {
  const std::size_t blocks = deposit_blocks(map);
  PixelSums sums(film);
  double cpu_s = 0;
  std::vector<std::vector<Deposit>> deposits(kBlocksAtOnce);
  for (std::size_t begin = 0; begin < blocks && !workers.monitor.interrupted(); begin += kBlocksAtOnce) {
    // Cut the beams of some blocks on all threads, ...
    const std::size_t count = std::min(kBlocksAtOnce, blocks - begin);
    for (std::vector<Deposit>& of_block : deposits) of_block.clear();
    cpu_s += workers.for_each_block(count, [&](std::uint64_t b) {
      BeamPainter painter(world, picture);
      const std::size_t first = (begin + b) * kBeamsPerBlock, last = std::min(map.size(), first + kBeamsPerBlock);
      for (std::size_t i = first; i < last; ++i) painter.paint(map, i, deposits[b]);
    });

    // ... and add them up in their order on this one.
    for (const std::vector<Deposit>& of_block : deposits) {
      for (const Deposit& deposit : of_block) sums.add(deposit.x, deposit.y, deposit.radiance);
    }
  }
  sums.develop(film, half, Layer::caustic);
  return cpu_s;
}

}  // namespace vitrail
