#pragma once
/// Embree 3 and 4 under one set of names: only what user geometry with single rays needs.

#if VITRAIL_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <memory>
#include <type_traits>

namespace vitrail::embree {

/// What Embree hands out, given back on every path.
struct Release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
template <typename Handle>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Release>;
using Device = Owned<RTCDevice>;
using Scene = Owned<RTCScene>;
using Geometry = Owned<RTCGeometry>;

#if VITRAIL_EMBREE_MAJOR >= 4
using Context = RTCRayQueryContext;
inline void init(Context& context) { rtcInitRayQueryContext(&context); }
#else
using Context = RTCIntersectContext;
inline void init(Context& context) { rtcInitIntersectContext(&context); }
#endif

/// The context of one query with a value of ours behind it: the extension that both versions guarantee to hand on.
template <typename Payload>
struct Query {
  Context context;
  Payload* payload;

  explicit Query(Payload& value) : payload(&value) { init(context); }
  static Payload& of(Context* context) { return *reinterpret_cast<Query*>(context)->payload; }
};

inline void set_ray(RTCRay& ray, const float origin[3], const float direction[3], float tfar) {
  ray.org_x = origin[0], ray.org_y = origin[1], ray.org_z = origin[2];
  ray.dir_x = direction[0], ray.dir_y = direction[1], ray.dir_z = direction[2];
  ray.tnear = 0, ray.tfar = tfar, ray.time = 0;
  ray.mask = 0xffffffffu, ray.id = 0, ray.flags = 0;
}

inline void intersect(RTCScene scene, Context& context, RTCRayHit& hit) {
#if VITRAIL_EMBREE_MAJOR >= 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  rtcIntersect1(scene, &hit, &arguments);
#else
  rtcIntersect1(scene, &context, &hit);
#endif
}

inline void occluded(RTCScene scene, Context& context, RTCRay& ray) {
#if VITRAIL_EMBREE_MAJOR >= 4
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  rtcOccluded1(scene, &ray, &arguments);
#else
  rtcOccluded1(scene, &context, &ray);
#endif
}

/// What a callback must say about its ray: version 4 asks for it, version 3 does not mind.
template <typename Arguments>
void set_valid(const Arguments* arguments, bool hit) {
#if VITRAIL_EMBREE_MAJOR >= 4
  arguments->valid[0] = hit ? -1 : 0;
#else
  static_cast<void>(arguments), static_cast<void>(hit);
#endif
}

}  // namespace vitrail::embree
