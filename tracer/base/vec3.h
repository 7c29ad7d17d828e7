#pragma once
/// Vectors of three doubles for positions and directions, and colours as a type of their own.

#include <cmath>

namespace vitrail {

struct Vec3 {
  double x = 0, y = 0, z = 0;

  constexpr double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr double& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr bool operator==(const Vec3&) const = default;
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(Vec3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr Vec3 operator*(double s, Vec3 a) { return a * s; }
constexpr Vec3 operator/(Vec3 a, double s) { return {a.x / s, a.y / s, a.z / s}; }
constexpr Vec3& operator+=(Vec3& a, Vec3 b) { return a = a + b; }

constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
constexpr double length_squared(Vec3 a) { return dot(a, a); }
inline double length(Vec3 a) { return std::sqrt(dot(a, a)); }
inline Vec3 normalise(Vec3 a) { return a / length(a); }

/// The largest coordinate without its sign; exact under scaling by powers of two, unlike a length.
constexpr double largest_coordinate(Vec3 a) {
  const double x = a.x < 0 ? -a.x : a.x, y = a.y < 0 ? -a.y : a.y, z = a.z < 0 ? -a.z : a.z;
  return x > y ? (x > z ? x : z) : (y > z ? y : z);
}
inline bool is_finite(Vec3 a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

/// A linear Rec. 709 / D65 triplet: a share, a radiance or a power, as the name of the variable says.
struct Rgb {
  double r = 0, g = 0, b = 0;

  constexpr double operator[](int channel) const { return channel == 0 ? r : channel == 1 ? g : b; }
  constexpr double& operator[](int channel) { return channel == 0 ? r : channel == 1 ? g : b; }
  constexpr bool operator==(const Rgb&) const = default;
};

constexpr Rgb operator+(Rgb a, Rgb b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
constexpr Rgb operator-(Rgb a, Rgb b) { return {a.r - b.r, a.g - b.g, a.b - b.b}; }
constexpr Rgb operator*(Rgb a, Rgb b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
constexpr Rgb operator*(Rgb a, double s) { return {a.r * s, a.g * s, a.b * s}; }
constexpr Rgb operator*(double s, Rgb a) { return a * s; }
constexpr Rgb& operator+=(Rgb& a, Rgb b) { return a = a + b; }
constexpr Rgb& operator*=(Rgb& a, Rgb b) { return a = a * b; }
constexpr double largest_channel(Rgb a) { return a.r > a.g ? (a.r > a.b ? a.r : a.b) : (a.g > a.b ? a.g : a.b); }
constexpr bool is_black(Rgb a) { return a.r == 0 && a.g == 0 && a.b == 0; }

}  // namespace vitrail
