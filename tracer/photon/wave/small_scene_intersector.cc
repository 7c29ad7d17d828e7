#include "photon/wave/small_scene_intersector.h"

#include <cmath>

namespace vitrail {
namespace {

// Two surfaces this close together, relative to the coordinates, are left to the exact search.
constexpr double kTooClose = 0x1p-30;

// The columns of a chunk as plain pointers. None overlaps another, which the loops promise with `ivdep`.
struct Columns {
  const double *ox, *oy, *oz;
  const double *dx, *dy, *dz;
  const std::int64_t* departed;
  double *nearest, *next;
  std::int64_t* met;

  explicit Columns(RayChunk& rays)
      : ox(rays.origin[0]),
        oy(rays.origin[1]),
        oz(rays.origin[2]),
        dx(rays.direction[0]),
        dy(rays.direction[1]),
        dz(rays.direction[2]),
        departed(rays.departed),
        nearest(rays.nearest.data()),
        next(rays.next.data()),
        met(rays.met.data()) {}

  // Enter a hit at distance t into the answers of a ray.
  void offer(int i, double t, std::int64_t what) const {
    const bool nearer = t < nearest[i];
    const double behind = t < next[i] ? t : next[i];
    next[i] = nearer ? nearest[i] : behind;
    met[i] = nearer ? what : met[i];
    nearest[i] = nearer ? t : nearest[i];
  }
};

// A ray that goes on inside a ball leaves at the far root; one that went away from it never comes back [O 2.14].
void meet_sphere(const SphereShape& sphere, std::int32_t object, RayChunk& rays) {
  const Columns c(rays);
  const double cx = sphere.center.x, cy = sphere.center.y, cz = sphere.center.z, radius = sphere.radius;
  const std::int64_t enters = HitId{object, true}.lane(), leaves = HitId{object, false}.lane();
  const int count = rays.count;
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) {
    const double x = cx - c.ox[i], y = cy - c.oy[i], z = cz - c.oz[i];
    const double b = x * c.dx[i] + y * c.dy[i] + z * c.dz[i];

    // Take the closest approach of the line, whose distance to the centre keeps its digits from afar [O 2.11].
    const double qx = x - c.dx[i] * b, qy = y - c.dy[i] * b, qz = z - c.dz[i] * b;
    const double distance = std::sqrt(qx * qx + qy * qy + qz * qz);
    const double rest = (radius - distance) * (radius + distance);
    const double h = std::sqrt(rest > 0 ? rest : 0.0);
    const double in = b - h, out = b + h;
    const double ahead = in > 0 ? in : (out > 0 ? out : kInfinity);
    const double from_elsewhere = rest > 0 ? ahead : kInfinity;
    const double through = b > 0 ? 2 * b : 0.0;
    const bool inside = c.departed[i] == enters, outside = c.departed[i] == leaves;
    const double t = inside ? through : (outside ? kInfinity : from_elsewhere);
    const bool entering = !inside & (in > 0);
    c.offer(i, t, entering ? enters : leaves);
  }
}

// `contains(x, y, z)` of a point on the plane, relative to `point`, limits the flat shape.
template <typename Contains>
void meet_flat(Vec3 point, Vec3 normal, const Contains& contains, std::int32_t object, RayChunk& rays) {
  const Columns c(rays);
  const std::int64_t enters = HitId{object, true}.lane(), leaves = HitId{object, false}.lane();
  const int count = rays.count;
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) {
    const double x = c.ox[i] - point.x, y = c.oy[i] - point.y, z = c.oz[i] - point.z;
    const double height = x * normal.x + y * normal.y + z * normal.z;
    const double climb = c.dx[i] * normal.x + c.dy[i] * normal.y + c.dz[i] * normal.z;
    const double t = -height / climb;
    const bool departed = (c.departed[i] == leaves) | (c.departed[i] == enters);
    const bool within = contains(x + c.dx[i] * t, y + c.dy[i] * t, z + c.dz[i] * t);
    const bool hit = (t > 0) & (t < kInfinity) & !departed & within;
    c.offer(i, hit ? t : kInfinity, climb < 0 ? enters : leaves);
  }
}

void meet_rectangle(const RectangleShape& r, std::int32_t object, RayChunk& rays) {
  const Vec3 u = normalise(r.u), v = normalise(r.v);
  const double half_u = length(r.u), half_v = length(r.v);
  const auto contains = [=](double x, double y, double z) {
    const double a = x * u.x + y * u.y + z * u.z, b = x * v.x + y * v.y + z * v.z;
    return (std::abs(a) <= half_u) & (std::abs(b) <= half_v);
  };
  meet_flat(r.center, normalise(cross(r.u, r.v)), contains, object, rays);
}

void meet_disc(const DiscShape& disc, std::int32_t object, RayChunk& rays) {
  const double radius = disc.radius;
  const auto contains = [=](double x, double y, double z) { return std::sqrt(x * x + y * y + z * z) <= radius; };
  meet_flat(disc.center, disc.normal, contains, object, rays);
}

// Any other shape answers ray by ray.
void meet_one_by_one(const Primitive& primitive, std::int32_t object, RayChunk& rays) {
  const Columns c(rays);
  for (int i = 0; i < rays.count; ++i) {
    const Ray ray{{c.ox[i], c.oy[i], c.oz[i]}, {c.dx[i], c.dy[i], c.dz[i]}};
    const HitId departed = HitId::of_lane(c.departed[i]);
    const Departure departure{static_cast<std::uint32_t>(object),
                              static_cast<std::uint32_t>(rays.states[i].departed_face), departed.entering};
    ShapeHit hit;
    if (!intersect(primitive, ray, departed.object == object ? &departure : nullptr, hit)) continue;
    if (hit.t < c.nearest[i]) rays.met_face[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(hit.face);
    c.offer(i, hit.t, HitId{object, hit.entering}.lane());
  }
}

// Compare the gap behind the nearest hit with what rounding of these coordinates may do.
void judge_gaps(RayChunk& rays) {
  const Columns c(rays);
  std::int64_t* too_close = rays.too_close.data();
  const int count = rays.count;
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) {
    const double x = std::abs(c.ox[i]), y = std::abs(c.oy[i]), z = std::abs(c.oz[i]);
    const double xy = x > y ? x : y, reach = xy > z ? xy : z;
    too_close[i] = c.next[i] - c.nearest[i] <= (reach + c.nearest[i]) * kTooClose ? 1 : 0;
  }
}

}  // namespace

bool SmallSceneIntersector::suits(const Scene& scene) {
  if (scene.objects.size() > kMost) return false;
  for (const Object& object : scene.objects) {
    if (std::holds_alternative<MeshShape>(object.shape)) return false;
  }
  return true;
}

SmallSceneIntersector::SmallSceneIntersector(const Scene& scene) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Shape& shape = scene.objects[i].shape;
    items_.push_back({static_cast<std::int32_t>(i), shape, make_primitive(shape)});
  }
}

void SmallSceneIntersector::find(RayChunk& rays) const {
  rays.nearest.fill(kInfinity);
  rays.next.fill(kInfinity);
  rays.met.fill(kNoObject);
  rays.met_face.fill(0);
  const auto everywhere = [](double, double, double) { return true; };
  for (const Item& item : items_) {
    if (const auto* sphere = std::get_if<SphereShape>(&item.shape)) {
      meet_sphere(*sphere, item.object, rays);
    } else if (const auto* plane = std::get_if<PlaneShape>(&item.shape)) {
      meet_flat(plane->point, plane->normal, everywhere, item.object, rays);
    } else if (const auto* rectangle = std::get_if<RectangleShape>(&item.shape)) {
      meet_rectangle(*rectangle, item.object, rays);
    } else if (const auto* disc = std::get_if<DiscShape>(&item.shape)) {
      meet_disc(*disc, item.object, rays);
    } else {
      meet_one_by_one(item.primitive, item.object, rays);
    }
  }
  judge_gaps(rays);
}

void SmallSceneIntersector::settle(std::uint32_t object, const std::int32_t* faces, int count,
                                   SurfaceLanes& lanes) const {
  const Item& item = items_[object];
  auto& [px, py, pz] = lanes.point;
  auto& [nx, ny, nz] = lanes.normal;
  if (const auto* sphere = std::get_if<SphereShape>(&item.shape)) {
    const Vec3 center = sphere->center;
    const double radius = sphere->radius;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      const double x = px[i] - center.x, y = py[i] - center.y, z = pz[i] - center.z;
      const double per_size = 1 / std::sqrt(x * x + y * y + z * z);
      nx[i] = x * per_size;
      ny[i] = y * per_size;
      nz[i] = z * per_size;
      px[i] = center.x + nx[i] * radius;
      py[i] = center.y + ny[i] * radius;
      pz[i] = center.z + nz[i] * radius;
    }
    return;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const SurfacePoint at = surface(item.primitive, {px[i], py[i], pz[i]}, static_cast<std::uint32_t>(faces[i]));
    for (int a = 0; a < 3; ++a) {
      lanes.point[a][i] = at.point[a];
      lanes.normal[a][i] = at.normal[a];
    }
  }
}

}  // namespace vitrail
