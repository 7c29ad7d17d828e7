// Ray against quadric and plane as in pbrt's `Shape::Intersect`, turned inside out: one shape, a column of rays. No ray
// leaves the loop early; a ray that misses has its hit at infinity, and a mask selects what it knows of the nearest hit
// so far. Sphere hits use the distance of closest approach, which keeps its digits from afar, in place of the
// discriminant b^2 - c [O 2.11]. A ray that departs from a shape knows so by the object's number, and needs no epsilon.

#include "photon/wave/intersect_lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "photon/wave/intersect_lanes.cc"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

#include "photon/wave/vec3_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace vitrail::HWY_NAMESPACE {

// The sides of an object as its lanes name them.
struct Sides {
  Ints enters, leaves;

  explicit HWY_INLINE Sides(std::int32_t object)
      : enters(hn::Set(kInts, HitId{object, true}.lane())), leaves(hn::Set(kInts, HitId{object, false}.lane())) {}
};

HWY_INLINE Mask is_side(const RayChunk& rays, std::size_t i, Ints side) {
  return hn::RebindMask(kDoubles, hn::LoadU(kInts, rays.departed + i) == side);
}

// Enter hits at distance t into the answers: before the nearest so far, or before the next.
HWY_INLINE void enter(RayChunk& rays, std::size_t i, Doubles t, Mask entering, const Sides& sides) {
  const Doubles nearest = hn::Load(kDoubles, &rays.nearest[i]), next = hn::Load(kDoubles, &rays.next[i]);
  const Ints met = hn::Load(kInts, &rays.met[i]);
  const Ints side = hn::IfThenElse(hn::RebindMask(kInts, entering), sides.enters, sides.leaves);
  const Mask is_nearer = t < nearest;
  hn::Store(select(is_nearer, nearest, select(t < next, t, next)), kDoubles, &rays.next[i]);
  hn::Store(hn::IfThenElse(hn::RebindMask(kInts, is_nearer), side, met), kInts, &rays.met[i]);
  hn::Store(select(is_nearer, t, nearest), kDoubles, &rays.nearest[i]);
}

// A ray that goes on inside a ball leaves at the far root; one that went away from it never comes back [O 2.14].
void intersect_sphere(const SphereShape& sphere, std::int32_t object, RayChunk& rays) {
  const Doubles zero = broadcast(0), never = broadcast(kInfinity), radius = broadcast(sphere.radius);
  const Doubles reach = broadcast(sphere.radius * sphere.radius * (1 + 0x1p-40));
  const Doubles behind = broadcast(-sphere.radius * (1 + 0x1p-40));
  const Vec3Lanes center = broadcast(sphere.center);
  const Sides sides(object);
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.count); i += kWidth) {
    const Vec3Lanes ray = load(rays.direction, i), to_center = center - load(rays.origin, i);
    const Doubles closest_at = dot(to_center, ray);
    const Vec3Lanes offset = to_center - ray * closest_at;
    const Doubles distance_squared = dot(offset, offset);
    const Mask inside = is_side(rays, i, sides.enters), outside = is_side(rays, i, sides.leaves);

    // Leave out roots where every ray of the vector passes by, or has passed, by more than rounding: most do in a scene
    // of many balls.
    const Mask near = hn::And(distance_squared<reach, closest_at> behind);
    if (hn::AllFalse(kDoubles, hn::Or(near, inside))) continue;
    const Doubles distance = hn::Sqrt(distance_squared);
    const Doubles half_chord_squared = (radius - distance) * (radius + distance);
    const Mask meets = half_chord_squared > zero;
    const Doubles half_chord = hn::Sqrt(select(meets, half_chord_squared, zero));
    const Doubles in = closest_at - half_chord, out = closest_at + half_chord;

    // Take the first root ahead, unless the ray departs from this very sphere.
    const Doubles ahead = select(in > zero, in, select(out > zero, out, never));
    const Doubles through = select(closest_at > zero, broadcast(2) * closest_at, zero);
    const Doubles t = select(inside, through, select(outside, never, select(meets, ahead, never)));
    enter(rays, i, t, hn::AndNot(inside, in > zero), sides);
  }
}

// `contains(from_point)` limits the flat shape to some places on its plane.
template <typename Contains>
HWY_INLINE void intersect_flat(Vec3 on_plane, Vec3 plane_normal, const Contains& contains, std::int32_t object,
                               RayChunk& rays) {
  const Doubles zero = broadcast(0), never = broadcast(kInfinity);
  const Vec3Lanes point = broadcast(on_plane), normal = broadcast(plane_normal);
  const Sides sides(object);
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.count); i += kWidth) {
    const Vec3Lanes ray = load(rays.direction, i), from_point = load(rays.origin, i) - point;
    const Doubles height = dot(from_point, normal), climb = dot(ray, normal);
    const Doubles t = hn::Neg(height) / climb;
    const Mask departed = hn::Or(is_side(rays, i, sides.leaves), is_side(rays, i, sides.enters));
    const Mask ahead = hn::And(t > zero, t < never);
    const Mask hit = hn::And(hn::AndNot(departed, ahead), contains(from_point + ray * t));
    enter(rays, i, select(hit, t, never), climb < zero, sides);
  }
}

struct Everywhere {
  HWY_INLINE Mask operator()(const Vec3Lanes&) const { return hn::FirstN(kDoubles, kWidth); }
};

struct InRectangle {
  Vec3 u, v;  // unit
  double half_u, half_v;
  HWY_INLINE Mask operator()(const Vec3Lanes& at) const {
    return hn::And(hn::Abs(dot(at, broadcast(u))) <= broadcast(half_u),
                   hn::Abs(dot(at, broadcast(v))) <= broadcast(half_v));
  }
};

struct InDisc {
  double radius;
  HWY_INLINE Mask operator()(const Vec3Lanes& at) const { return hn::Sqrt(dot(at, at)) <= broadcast(radius); }
};

void intersect_plane(const PlaneShape& plane, std::int32_t object, RayChunk& rays) {
  intersect_flat(plane.point, plane.normal, Everywhere{}, object, rays);
}

void intersect_rectangle(const RectangleShape& r, std::int32_t object, RayChunk& rays) {
  const InRectangle contains{normalise(r.u), normalise(r.v), length(r.u), length(r.v)};
  intersect_flat(r.center, normalise(cross(r.u, r.v)), contains, object, rays);
}

void intersect_disc(const DiscShape& disc, std::int32_t object, RayChunk& rays) {
  intersect_flat(disc.center, disc.normal, InDisc{disc.radius}, object, rays);
}

// Compare the gap behind the nearest hit with what rounding of these coordinates may do: two surfaces closer together
// than this, relative to the coordinates, are left to the exact search.
void find_ties_lanes(RayChunk& rays) {
  const Doubles too_close = broadcast(0x1p-30);
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.count); i += kWidth) {
    const Vec3Lanes origin = load(rays.origin, i);
    const Doubles x = hn::Abs(origin.x), y = hn::Abs(origin.y), z = hn::Abs(origin.z);
    const Doubles xy = select(x > y, x, y), reach = select(xy > z, xy, z);
    const Doubles nearest = hn::Load(kDoubles, &rays.nearest[i]), next = hn::Load(kDoubles, &rays.next[i]);
    const Mask tie = next - nearest <= (reach + nearest) * too_close;
    hn::Store(hn::IfThenElseZero(hn::RebindMask(kInts, tie), hn::Set(kInts, 1)), kInts, &rays.too_close[i]);
  }
}

void project_sphere(const SphereShape& sphere, int count, SurfaceLanes& lanes) {
  const Vec3Lanes center = broadcast(sphere.center);
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); i += kWidth) {
    const Vec3Lanes normal = normalise(load(lanes.point, i) - center);
    store(normal, lanes.normal, i);
    store(center + normal * broadcast(sphere.radius), lanes.point, i);
  }
}

}  // namespace vitrail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vitrail {

HWY_EXPORT(intersect_sphere);
HWY_EXPORT(intersect_plane);
HWY_EXPORT(intersect_rectangle);
HWY_EXPORT(intersect_disc);
HWY_EXPORT(find_ties_lanes);
HWY_EXPORT(project_sphere);

void intersect(const SphereShape& sphere, std::int32_t object, RayChunk& rays) {
  HWY_DYNAMIC_DISPATCH(intersect_sphere)(sphere, object, rays);
}
void intersect(const PlaneShape& plane, std::int32_t object, RayChunk& rays) {
  HWY_DYNAMIC_DISPATCH(intersect_plane)(plane, object, rays);
}
void intersect(const RectangleShape& rectangle, std::int32_t object, RayChunk& rays) {
  HWY_DYNAMIC_DISPATCH(intersect_rectangle)(rectangle, object, rays);
}
void intersect(const DiscShape& disc, std::int32_t object, RayChunk& rays) {
  HWY_DYNAMIC_DISPATCH(intersect_disc)(disc, object, rays);
}
void find_ties(RayChunk& rays) { HWY_DYNAMIC_DISPATCH(find_ties_lanes)(rays); }
void project(const SphereShape& sphere, int count, SurfaceLanes& lanes) {
  HWY_DYNAMIC_DISPATCH(project_sphere)(sphere, count, lanes);
}

}  // namespace vitrail
#endif
