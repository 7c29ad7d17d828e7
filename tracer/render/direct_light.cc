#include "render/direct_light.h"

namespace vitrail {

DirectLight direct_light(const Scene& scene, const Intersector& intersector, Vec3 point, Vec3 normal,
                         const Departures& departures, LightDraw draw, int samples_per_light) {
  DirectLight result;
  for (std::size_t l = 0; l < scene.lights.size(); ++l) {
    const Light& light = scene.lights[l];
    const int samples = is_sharp(light) ? 1 : samples_per_light;
    const Stream stream = within(draw.stream, l);
    Rgb sum;
    for (int s = 0; s < samples; ++s) {
      const auto index = draw.sample * static_cast<std::uint32_t>(samples) + static_cast<std::uint32_t>(s);
      const auto u = padded_2d(stream, index);
      const Illumination from = illuminate(light, point, normal, unit_point(u[0], u[1]));
      const double cosine = dot(from.toward, normal);
      if (!(cosine > 0) || is_black(from.irradiance)) continue;
      if (scene.plan.shadow) {
        ++result.shadow_rays;
        if (intersector.occluded({point, from.toward}, departures, from.distance)) continue;
      }
      sum += from.irradiance * cosine;
    }
    result.irradiance += samples == 1 ? sum : sum * (1.0 / samples);
  }
  return result;
}

}  // namespace vitrail
