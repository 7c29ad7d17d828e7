#include "scene/sky_image.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vitrail {

namespace {

// The interval of a cumulative sum that holds `value`, and where in it.
struct Place {
  std::size_t index = 0;
  double fraction = 0;
};

Place find_place(const double* cumulative, std::size_t count, double value) {
  const double* const above = std::upper_bound(cumulative + 1, cumulative + count, value);
  const auto index = static_cast<std::size_t>(above - (cumulative + 1));
  const double width = cumulative[index + 1] - cumulative[index];
  return {index, width > 0 ? std::clamp((value - cumulative[index]) / width, 0.0, 1.0) : 0.5};
}

}  // namespace

SkyImage::SkyImage(int width, int height, std::vector<Rgb> radiance)
    : width_(width), height_(height), radiance_(std::move(radiance)), row_power_(1, 0.0) {
  // Weigh each pixel by its radiance and solid angle.
  for (int row = 0; row < height_; ++row) {
    const double solid_angle = 2 * M_PI / width_ * (top_cosine(row) - top_cosine(row + 1));
    pixel_power_.push_back(0);
    for (int column = 0; column < width_; ++column) {
      const Rgb& light = radiance_[static_cast<std::size_t>(row * width_ + column)];
      total_ += light * solid_angle;
      pixel_power_.push_back(pixel_power_.back() + (light.r + light.g + light.b) * solid_angle);
    }
    row_power_.push_back(row_power_.back() + pixel_power_.back());
  }
}

double SkyImage::top_cosine(int row) const {
  return row == 0 ? 1 : row == height_ ? -1 : std::cos(M_PI * row / height_);
}

Rgb SkyImage::towards(Vec3 direction) const {
  const double longitude = std::atan2(direction.x, direction.z), polar = std::acos(std::clamp(direction.y, -1.0, 1.0));
  const int column = static_cast<int>((0.5 - longitude / (2 * M_PI)) * width_);
  const int row = static_cast<int>(polar / M_PI * height_);
  return radiance_[static_cast<std::size_t>(std::clamp(row, 0, height_ - 1) * width_ +
                                            std::clamp(column, 0, width_ - 1))];
}

SkyImage::Draw SkyImage::draw(double u, double v) const {
  const double power = row_power_.back();
  if (!(power > 0)) return {{0, 1, 0}, {}, 0};
  const Place row = find_place(row_power_.data(), row_power_.size() - 1, v * power);
  const double* const pixels = pixel_power_.data() + row.index * (static_cast<std::size_t>(width_) + 1);
  const Place column = find_place(pixels, static_cast<std::size_t>(width_), u * pixels[width_]);

  // Spread evenly over the pixel's solid angle.
  const int r = static_cast<int>(row.index);
  const double height = top_cosine(r) + (top_cosine(r + 1) - top_cosine(r)) * row.fraction;
  const double around = std::sqrt(std::max(0.0, (1 - height) * (1 + height)));
  const double longitude = M_PI - 2 * M_PI * (static_cast<double>(column.index) + column.fraction) / width_;
  const Rgb light = radiance_[row.index * static_cast<std::size_t>(width_) + column.index];
  const Vec3 direction{around * std::sin(longitude), height, around * std::cos(longitude)};
  return {direction, light, (light.r + light.g + light.b) / power};
}

}  // namespace vitrail
