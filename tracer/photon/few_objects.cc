#include "photon/few_objects.h"

#include <cmath>

namespace vitrail {
namespace {

// Enter a hit at distance t of an object into the answers of a lane.
inline void offer(RayLanes& lanes, int i, double t, std::int64_t met, std::int64_t face) {
  const bool nearer = t < lanes.nearest[i];
  const double behind = t < lanes.next[i] ? t : lanes.next[i];
  lanes.next[i] = nearer ? lanes.nearest[i] : behind;
  lanes.met[i] = nearer ? met : lanes.met[i];
  lanes.met_face[i] = nearer ? face : lanes.met_face[i];
  lanes.nearest[i] = nearer ? t : lanes.nearest[i];
}

// A ray that goes on inside a ball leaves at the far root; one that went away from it never comes back [O 2.14].
void meet_sphere(const SphereShape& sphere, std::int64_t object, RayLanes& lanes) {
  const double cx = sphere.center.x, cy = sphere.center.y, cz = sphere.center.z, radius = sphere.radius;
  for (int i = 0; i < lanes.count; ++i) {
    const double x = cx - lanes.origin_x[i], y = cy - lanes.origin_y[i], z = cz - lanes.origin_z[i];
    const double dx = lanes.direction_x[i], dy = lanes.direction_y[i], dz = lanes.direction_z[i];
    const double b = x * dx + y * dy + z * dz;

    // Take the closest approach of the line, whose distance to the centre keeps its digits from afar [O 2.11].
    const double qx = x - dx * b, qy = y - dy * b, qz = z - dz * b;
    const double distance = std::sqrt(qx * qx + qy * qy + qz * qz);
    const double rest = (radius - distance) * (radius + distance);
    const double h = std::sqrt(rest > 0 ? rest : 0.0);
    const double in = b - h, out = b + h;
    const double ahead = in > 0 ? in : (out > 0 ? out : kInfinity);
    const double from_outside = rest > 0 ? ahead : kInfinity;
    const double through = 2 * b > 0 ? 2 * b : 0.0;
    const bool inside = lanes.departed[i] == 2 * object + 1, outside = lanes.departed[i] == 2 * object;
    const double t = inside ? through : (outside ? kInfinity : from_outside);
    const std::int64_t entering = inside ? 0 : (in > 0 ? 1 : 0);
    offer(lanes, i, t, 2 * object + entering, 0);
  }
}

// `contains(x, y, z)` of a point relative to `point` on the plane limits the flat shape.
template <typename Contains>
void meet_flat(Vec3 point, Vec3 normal, const Contains& contains, std::int64_t object, RayLanes& lanes) {
  for (int i = 0; i < lanes.count; ++i) {
    const double x = lanes.origin_x[i] - point.x, y = lanes.origin_y[i] - point.y, z = lanes.origin_z[i] - point.z;
    const double dx = lanes.direction_x[i], dy = lanes.direction_y[i], dz = lanes.direction_z[i];
    const double height = x * normal.x + y * normal.y + z * normal.z;
    const double climb = dx * normal.x + dy * normal.y + dz * normal.z;
    const double t = -height / climb;
    const bool departed = (lanes.departed[i] & ~std::int64_t{1}) == 2 * object;
    const bool hit = (t > 0) & (t < kInfinity) & !departed & contains(x + dx * t, y + dy * t, z + dz * t);
    offer(lanes, i, hit ? t : kInfinity, 2 * object + (climb < 0 ? 1 : 0), 0);
  }
}

void meet_rectangle(const RectangleShape& r, std::int64_t object, RayLanes& lanes) {
  const Vec3 u = normalise(r.u), v = normalise(r.v);
  const double half_u = length(r.u), half_v = length(r.v);
  const auto contains = [=](double x, double y, double z) {
    const double a = x * u.x + y * u.y + z * u.z, b = x * v.x + y * v.y + z * v.z;
    return (std::abs(a) <= half_u) & (std::abs(b) <= half_v);
  };
  meet_flat(r.center, normalise(cross(r.u, r.v)), contains, object, lanes);
}

void meet_disc(const DiscShape& disc, std::int64_t object, RayLanes& lanes) {
  const double radius = disc.radius;
  const auto contains = [=](double x, double y, double z) { return std::sqrt(x * x + y * y + z * z) <= radius; };
  meet_flat(disc.center, disc.normal, contains, object, lanes);
}

// Any other shape answers ray by ray.
void meet_one_by_one(const Primitive& primitive, std::int64_t object, RayLanes& lanes) {
  for (int i = 0; i < lanes.count; ++i) {
    const Ray ray{{lanes.origin_x[i], lanes.origin_y[i], lanes.origin_z[i]},
                  {lanes.direction_x[i], lanes.direction_y[i], lanes.direction_z[i]}};
    const bool is_departed = lanes.departed[i] != RayLanes::kNone && lanes.departed[i] >> 1 == object;
    const Departure departure{static_cast<std::uint32_t>(object), static_cast<std::uint32_t>(lanes.departed_face[i]),
                              (lanes.departed[i] & 1) != 0};
    ShapeHit hit;
    if (!intersect(primitive, ray, is_departed ? &departure : nullptr, hit)) continue;
    offer(lanes, i, hit.t, 2 * object + (hit.entering ? 1 : 0), hit.face);
  }
}

}  // namespace

bool FewObjects::suit(const Scene& scene) {
  if (scene.objects.size() > kMost) return false;
  for (const Object& object : scene.objects) {
    if (std::holds_alternative<MeshShape>(object.shape)) return false;
  }
  return true;
}

FewObjects::FewObjects(const Scene& scene) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Shape& shape = scene.objects[i].shape;
    items_.push_back({static_cast<std::int64_t>(i), shape, make_primitive(shape)});
  }
}

void FewObjects::find(RayLanes& lanes) const {
  for (int i = 0; i < lanes.count; ++i) {
    lanes.nearest[i] = lanes.next[i] = kInfinity;
    lanes.met[i] = RayLanes::kNone;
    lanes.met_face[i] = 0;
  }
  const auto everywhere = [](double, double, double) { return true; };
  for (const Item& item : items_) {
    if (const auto* sphere = std::get_if<SphereShape>(&item.shape)) {
      meet_sphere(*sphere, item.object, lanes);
    } else if (const auto* plane = std::get_if<PlaneShape>(&item.shape)) {
      meet_flat(plane->point, plane->normal, everywhere, item.object, lanes);
    } else if (const auto* rectangle = std::get_if<RectangleShape>(&item.shape)) {
      meet_rectangle(*rectangle, item.object, lanes);
    } else if (const auto* disc = std::get_if<DiscShape>(&item.shape)) {
      meet_disc(*disc, item.object, lanes);
    } else {
      meet_one_by_one(item.primitive, item.object, lanes);
    }
  }
}

SurfacePoint FewObjects::surface(std::uint32_t object, Vec3 point, std::uint32_t face) const {
  const Item& item = items_[object];
  if (const auto* sphere = std::get_if<SphereShape>(&item.shape)) {
    const Vec3 normal = normalise(point - sphere->center);
    return {sphere->center + normal * sphere->radius, normal};
  }
  return vitrail::surface(item.primitive, point, face);
}

}  // namespace vitrail
