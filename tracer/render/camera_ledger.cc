#include "render/camera_ledger.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace vitrail {

const char* name_of(Limit limit) {
  switch (limit) {
    case Limit::max_reflections:
      return "max_reflections";
    case Limit::max_transmissions:
      return "max_transmissions";
  }
  throw std::logic_error("no such limit");
}

void LightByBranch::add(double share, Rgb light) {
  const double sum = light.r + light.g + light.b;
  all += sum;
  for (std::size_t i = 0; i < kWeakShares.size(); ++i) weak[i] += share < kWeakShares[i] ? sum : 0;
}

LightByBranch& LightByBranch::operator+=(const LightByBranch& other) {
  all += other.all;
  for (std::size_t i = 0; i < weak.size(); ++i) weak[i] += other.weak[i];
  return *this;
}

void CameraLedger::add(const CutBranch& branch) {
  by_limit_[static_cast<std::size_t>(branch.limit)] += branch.share;
  by_layer_[static_cast<std::size_t>(branch.layer)] += branch.share;
  by_object_[branch.object] += branch.share;
}

void CameraLedger::close(const PixelBlock& block) {
  const auto most = std::max_element(by_object_.begin(), by_object_.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  worst_ = {.block = block, .cut = cut()};
  if (most != by_object_.end()) worst_.object = most->first;
  if (cut(Limit::max_reflections) > cut(Limit::max_transmissions)) worst_.limit = Limit::max_reflections;
  by_object_.clear();
}

CameraLedger& CameraLedger::operator+=(const CameraLedger& other) {
  looks_ += other.looks_;
  for (std::size_t i = 0; i < by_limit_.size(); ++i) by_limit_[i] += other.by_limit_[i];
  for (std::size_t i = 0; i < by_layer_.size(); ++i) by_layer_[i] += other.by_layer_[i];
  light_ += other.light_;
  if (other.worst_.cut > worst_.cut) worst_ = other.worst_;
  return *this;
}

double CameraLedger::cut() const { return mean(by_limit_[0] + by_limit_[1]); }
double CameraLedger::cut(Limit limit) const { return mean(by_limit_[static_cast<std::size_t>(limit)]); }
double CameraLedger::cut(Layer layer) const { return mean(by_layer_[static_cast<std::size_t>(layer)]); }
double CameraLedger::weak(std::size_t place) const { return light_.all > 0 ? light_.weak.at(place) / light_.all : 0; }

std::string warning_of(const CameraLedger& ledger, const Scene& scene, double tolerated) {
  const CameraLedger::Worst& worst = ledger.worst();
  if (!(worst.cut > tolerated)) return {};
  const bool mirrored = worst.limit == Limit::max_reflections;
  char text[160];
  std::snprintf(text, sizeof text, "up to %.2g %% of the pixels x %d to %d, y %d to %d was cut after %d %s",
                100 * worst.cut, worst.block.x0, worst.block.x1 - 1, worst.block.y0, worst.block.y1 - 1,
                mirrored ? scene.transport.max_reflections : scene.transport.max_transmissions,
                mirrored ? "reflections" : "transmissions");
  return std::string(text) + ", most of it at `" + scene.objects[worst.object].name + "`; raise transport." +
         name_of(worst.limit);
}

}  // namespace vitrail
