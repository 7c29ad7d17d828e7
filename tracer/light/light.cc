#include "light/light.h"

#include <cmath>

namespace vitrail {
namespace {

template <typename... Cases>
struct Overload : Cases... {
  using Cases::operator()...;
};

Chart chart_for(const Emitter& emitter, const Target& target, const Surroundings& surroundings) {
  Chart chart;
  const auto set = [&](auto domain) {
    chart.power = domain.power;
    chart.domain = domain;
  };
  std::visit(Overload{[&](const DirectionalLight& light) { set(aim(light, target, surroundings)); },
                      [&](const PointLight& light) { set(aim(light, target)); },
                      [&](const SpotLight& light) { set(aim(light, target)); },
                      [&](const AreaLight& light) { set(aim(light, target)); },
                      [&](const EnvironmentLight& light) { set(aim(light, target, surroundings)); }},
             emitter);
  return chart;
}

double total(Rgb power) { return power.r + power.g + power.b; }

}  // namespace

Illumination illuminate(const Light& light, Vec3 point, Vec3 normal, const UnitPoint& sample) {
  return std::visit(Overload{[&](const EnvironmentLight& l) { return illuminate(l, normal, sample); },
                             [&](const auto& l) { return illuminate(l, point, sample); }},
                    light.emitter);
}

bool is_delta(const Light& light) {
  return std::visit(
      Overload{[](const DirectionalLight& l) { return l.angular_diameter_deg == 0; },
               [](const PointLight&) { return true; }, [](const SpotLight&) { return true; },
               [](const AreaLight& l) { return l.collimated; }, [](const EnvironmentLight&) { return false; }},
      light.emitter);
}

Rgb sky_radiance(const Light& light, Vec3 direction) {
  const auto* environment = std::get_if<EnvironmentLight>(&light.emitter);
  if (environment == nullptr) return {};
  return environment->image ? environment->image->towards(direction) : environment->radiance;
}

std::vector<Chart> make_charts(const Scene& scene, const Targets& targets, std::uint64_t photons_per_half) {
  std::vector<Chart> charts;
  double sum = 0;
  for (std::uint32_t l = 0; l < scene.lights.size(); ++l) {
    for (const Target& target : targets.targets) {
      Chart chart = chart_for(scene.lights[l].emitter, target, targets.surroundings);
      if (!(total(chart.power) > 0)) continue;
      chart.light = l;
      chart.target = target.object;
      sum += total(chart.power);
      charts.push_back(chart);
    }
  }

  // Round each share up, so that no chart with power goes without photons.
  for (Chart& chart : charts) {
    chart.count =
        static_cast<std::uint64_t>(std::ceil(static_cast<double>(photons_per_half) * (total(chart.power) / sum)));
  }
  return charts;
}

bool needs_four(const Chart& chart) {
  return std::visit(
      Overload{[](const DirectionalChart& c) { return c.one_minus_cos > 0; }, [](const ConeChart&) { return false; },
               [](const AreaChart& c) { return !c.collimated; }, [](const EnvironmentChart&) { return true; }},
      chart.domain);
}

Emission emit(const Chart& chart, const EmissionSample& sample) {
  return std::visit([&](const auto& domain) { return emit(domain, sample); }, chart.domain);
}

void emit(const Chart& chart, EmissionColumns& columns) {
  std::visit(
      [&](const auto& domain) {
        for (std::size_t i = 0; i < columns.count; ++i) columns.set(i, emit(domain, columns.sample(i)));
      },
      chart.domain);
}

}  // namespace vitrail
