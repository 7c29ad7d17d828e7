#pragma once
/// Small scenes for the tests, built as values.

#include <cmath>
#include <string>

#include "scene/scene.h"

namespace vitrail {

inline constexpr double kPi = 3.14159265358979323846;
inline double radians(double degrees) { return degrees * kPi / 180; }
inline double degrees(double radians) { return radians * 180 / kPi; }
/// What a film keeps of a radiance below 4 is off by at most half a step of a float.
inline constexpr double kFilmRounding = 0x1p-23;
/// atan2 and not acos: right for small angles too.
inline double angle_between(Vec3 a, Vec3 b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

inline Material glass(double ior, Rgb transmission = {1, 1, 1}, bool fresnel = false) {
  Material material;
  material.name = "glass";
  material.transmission = transmission;
  material.ior_by_band = {ior};
  material.ior_minus_one_by_band = {ior - 1};
  material.camera_ior = ior;
  material.fresnel = fresnel;
  return material;
}

inline Material diffuse(double albedo) {
  Material material;
  material.name = "diffuse";
  material.diffuse = Rgb{albedo, albedo, albedo};
  material.ior_by_band = {1};
  material.ior_minus_one_by_band = {0};
  return material;
}

inline Frame turned_about_z(double angle_deg, Vec3 origin = {}) {
  const double c = std::cos(radians(angle_deg)), s = std::sin(radians(angle_deg));
  return {origin, {{c, -s, 0}, {s, c, 0}, {0, 0, 1}}, false};
}

/// A general rotation, none of its entries zero.
inline Frame turned(Vec3 origin = {}) {
  const Vec3 a = normalise({1, 2, 3}), b = normalise(cross(a, {-2, 1, 1})), c = cross(a, b);
  return {origin, {a, b, c}, false};
}

class SceneBuilder {
 public:
  SceneBuilder() { scene.bands.push_back({"all", {1, 1, 1}, {}}); }
  std::uint32_t add(const Material& material) {
    scene.materials.push_back(material);
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
  }
  std::uint32_t add(const std::string& name, const Shape& shape, std::uint32_t material, int priority = 0) {
    scene.objects.push_back({name, material, priority, shape});
    return static_cast<std::uint32_t>(scene.objects.size() - 1);
  }

  Scene scene;
};

/// A point source of test directions and positions: the same everywhere, no quality asked for.
class TestNumbers {
 public:
  double unit() {
    state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }
  double between(double low, double high) { return low + (high - low) * unit(); }
  Vec3 in_cube(double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }
  Vec3 direction() {
    while (true) {
      const Vec3 v = in_cube(1);
      const double size = length(v);
      if (size > 0.1 && size < 1) return v / size;
    }
  }

 private:
  std::uint64_t state_ = 88172645463325252ull;
};

}  // namespace vitrail
