#include "geometry/embree_search.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/embree_shim.h"

namespace vitrail {

namespace {

/// In a unit cube, origin, direction and boxes are rounded to float on a way of at most 8 units: that moves a ray by
/// less than 1e-6 against its boxes. Boxes and horizons are wider by twice that.
constexpr double kMargin = 0x1p-19;

/// A search in the coordinates of the tree: the ray starts near the cube however far it comes from.
struct TreeRay {
  float origin[3], direction[3];
  double skipped = 0;  // metres left out before the cube
};

/// What a callback needs to decide in double.
struct RayQuery {
  const Ray& ray;
  const Departures& departures;
  double skipped = 0;
  Nearest* nearest = nullptr;               // closest hit, or ...
  double t_max = 0;                         // ... any hit before this,
  bool found = false;                       // which is noted here, or ...
  std::vector<TreeItem>* around = nullptr;  // every item whose box is met
};

}  // namespace

struct EmbreeSearch::State {
  const std::vector<Primitive>& primitives;
  std::vector<TreeItem> items;
  embree::Device device;
  embree::Scene scene;  // after the device, so that it goes first

  // Boxes are brought to the unit cube by a shift and a power of two: the walk is the same at any scale.
  Vec3 center;
  double scale = 1;

  State(const std::vector<Primitive>& asked, std::vector<TreeItem> held) : primitives(asked), items(std::move(held)) {
    measure();
    build();
  }

  Bounds item_bounds(const TreeItem& item) const {
    const Primitive& primitive = primitives[item.object];
    return item.triangle == TreeItem::kWhole ? bounds(primitive)
                                             : std::get<Mesh>(primitive).triangle_bounds(item.triangle);
  }

  bool meets(std::uint32_t index, const RayQuery& query, ShapeHit& hit) const {
    const TreeItem item = items[index];
    const Departure* left = departure_of(query.departures, item.object);
    const Primitive& primitive = primitives[item.object];
    if (item.triangle == TreeItem::kWhole) return intersect(primitive, query.ray, left, hit);
    return std::get<Mesh>(primitive).intersect_triangle(item.triangle, query.ray, left, hit);
  }

  /// A distance in metres as a float of the tree that is certainly not too small.
  float horizon(double t, double skipped) const {
    return std::nextafter(static_cast<float>((t - skipped) * scale * (1 + kMargin) + 2 * kMargin),
                          std::numeric_limits<float>::infinity());
  }

  TreeRay tree_ray(const Ray& ray) const;
  void measure();
  void build();
};

namespace {

void bounds_of_item(const RTCBoundsFunctionArguments* arguments) {
  const auto& state = *static_cast<const EmbreeSearch::State*>(arguments->geometryUserPtr);
  const Bounds box = state.item_bounds(state.items[arguments->primID]);
  const Vec3 low = (box.min - state.center) * state.scale, high = (box.max - state.center) * state.scale;
  RTCBounds& out = *arguments->bounds_o;
  out.lower_x = static_cast<float>(low.x - kMargin), out.upper_x = static_cast<float>(high.x + kMargin);
  out.lower_y = static_cast<float>(low.y - kMargin), out.upper_y = static_cast<float>(high.y + kMargin);
  out.lower_z = static_cast<float>(low.z - kMargin), out.upper_z = static_cast<float>(high.z + kMargin);
}

void intersect_item(const RTCIntersectFunctionNArguments* arguments) {
  embree::set_valid(arguments, false);
  if (arguments->N != 1 || arguments->valid[0] == 0) return;
  const auto& state = *static_cast<const EmbreeSearch::State*>(arguments->geometryUserPtr);
  const RayQuery& query = embree::Query<RayQuery>::of(arguments->context);

  if (query.around != nullptr) {
    query.around->push_back(state.items[arguments->primID]);
    return;
  }

  // Note the hit, and tell Embree only how far it still has to look.
  ShapeHit hit;
  if (!state.meets(arguments->primID, query, hit)) return;
  query.nearest->offer(state.items[arguments->primID].object, hit);
  auto& ray = *reinterpret_cast<RTCRayHit*>(arguments->rayhit);
  const float horizon = state.horizon(query.nearest->horizon(), query.skipped);
  if (horizon < ray.ray.tfar) ray.ray.tfar = horizon;
  ray.hit.geomID = arguments->geomID;
  embree::set_valid(arguments, true);
}

void occlude_item(const RTCOccludedFunctionNArguments* arguments) {
  embree::set_valid(arguments, false);
  if (arguments->N != 1 || arguments->valid[0] == 0) return;
  const auto& state = *static_cast<const EmbreeSearch::State*>(arguments->geometryUserPtr);
  RayQuery& query = embree::Query<RayQuery>::of(arguments->context);
  ShapeHit hit;
  if (!state.meets(arguments->primID, query, hit) || !(hit.t < query.t_max)) return;
  query.found = true;
  reinterpret_cast<RTCRay*>(arguments->ray)->tfar = -std::numeric_limits<float>::infinity();
  embree::set_valid(arguments, true);
}

}  // namespace

void EmbreeSearch::State::measure() {
  Bounds all;
  for (const TreeItem& item : items) all.add(item_bounds(item));
  center = all.min + (all.max - all.min) * 0.5;
  const double half = largest_coordinate(all.max - all.min) * 0.5;
  if (half > 0) scale = std::ldexp(1.0, -std::ilogb(half) - 1);
}

void EmbreeSearch::State::build() {
  // One thread builds small trees faster than many wake up, and leaves the sanitizers in peace.
  device.reset(rtcNewDevice(items.size() < 100000 ? "threads=1" : nullptr));
  if (!device) throw std::runtime_error("Embree does not start on this machine");
  scene.reset(rtcNewScene(device.get()));
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_MEDIUM);

  const embree::Geometry geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER));
  rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(items.size()));
  rtcSetGeometryUserData(geometry.get(), this);
  rtcSetGeometryMask(geometry.get(), 0xffffffffu);
  rtcSetGeometryBoundsFunction(geometry.get(), bounds_of_item, nullptr);
  rtcSetGeometryIntersectFunction(geometry.get(), intersect_item);
  rtcSetGeometryOccludedFunction(geometry.get(), occlude_item);
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometry(scene.get(), geometry.get());
  rtcCommitScene(scene.get());
  if (rtcGetDeviceError(device.get()) != RTC_ERROR_NONE) throw std::runtime_error("Embree cannot build its tree");
}

TreeRay EmbreeSearch::State::tree_ray(const Ray& ray) const {
  TreeRay result;
  // Leave out the way to the sphere of radius 2 around the cube: all boxes lie within sqrt(3) of its centre.
  Vec3 origin = (ray.origin - center) * scale;
  const double ahead = -dot(origin, ray.direction);
  if (ahead > 4) {
    result.skipped = (ahead - 2) / scale;
    origin = (ray.at(result.skipped) - center) * scale;
  }
  for (int axis = 0; axis < 3; ++axis) {
    result.origin[axis] = static_cast<float>(origin[axis]);
    result.direction[axis] = static_cast<float>(ray.direction[axis]);
  }
  return result;
}

EmbreeSearch::EmbreeSearch(const std::vector<Primitive>& primitives, std::vector<TreeItem> items)
    : state_(std::make_unique<State>(primitives, std::move(items))) {}

EmbreeSearch::~EmbreeSearch() = default;

void EmbreeSearch::closest(const Ray& ray, const Departures& departures, Nearest& nearest) const {
  const TreeRay tree_ray = state_->tree_ray(ray);
  RayQuery payload{.ray = ray, .departures = departures, .skipped = tree_ray.skipped, .nearest = &nearest};
  embree::Query<RayQuery> query(payload);
  RTCRayHit hit;
  embree::set_ray(hit.ray, tree_ray.origin, tree_ray.direction, state_->horizon(nearest.horizon(), tree_ray.skipped));
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  embree::intersect(state_->scene.get(), query.context, hit);
}

void EmbreeSearch::around(Vec3 point, std::vector<TreeItem>& items) const {
  // A ray that ends where it starts meets the boxes around it; they are wide enough for its rounding.
  const Ray ray{point, {0, 0, 1}};
  const Departures none;
  const TreeRay tree_ray = state_->tree_ray(ray);
  if (tree_ray.skipped > 0) return;
  RayQuery payload{.ray = ray, .departures = none, .around = &items};
  embree::Query<RayQuery> query(payload);
  RTCRayHit hit;
  embree::set_ray(hit.ray, tree_ray.origin, tree_ray.direction, static_cast<float>(kMargin));
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  embree::intersect(state_->scene.get(), query.context, hit);
}

bool EmbreeSearch::occluded(const Ray& ray, const Departures& departures, double t_max) const {
  const TreeRay tree_ray = state_->tree_ray(ray);
  RayQuery payload{.ray = ray, .departures = departures, .skipped = tree_ray.skipped, .t_max = t_max};
  embree::Query<RayQuery> query(payload);
  RTCRay shadow;
  embree::set_ray(shadow, tree_ray.origin, tree_ray.direction, state_->horizon(t_max, tree_ray.skipped));
  embree::occluded(state_->scene.get(), query.context, shadow);
  return payload.found;
}

}  // namespace vitrail
