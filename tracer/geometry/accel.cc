#include "geometry/accel.h"

#include <algorithm>

#include "base/diagnostic.h"
#include "geometry/embree_search.h"
#include "geometry/nearest.h"
#include "geometry/primitive.h"
#include "geometry/solids_alone.h"

namespace vitrail {

namespace {

/// Where the two searches take the same time (benchmark `closest_hit`, spheres, the cheapest to ask): the list answers
/// 1.3 times as many rays at 4 primitives, the tree 1.3 times as many at 16 and twice as many at 32.
constexpr std::uint64_t kLongestList = 8;
constexpr double kUnit = 0x1p-53;  // the rounding of one operation

/// The distance by which rounding may move a hit: a few operations on the coordinates it is computed from.
double hit_error(const Ray& ray, double t, double coordinate_scale) {
  return 16 * kUnit * (largest_coordinate(ray.origin) + t + coordinate_scale);
}

}  // namespace

struct Intersector::State {
  const Scene& scene;
  std::vector<Primitive> primitives;  // by object
  std::vector<std::uint32_t> list;    // objects that every ray asks: all in a small scene, else those without an end
  std::unique_ptr<EmbreeSearch> tree;
  std::vector<bool> alone;                   // by object, if there is a tree: `solids_alone`
  std::vector<std::uint32_t> listed_solids;  // of glass, to be asked one by one whether they hold a point
  Bounds bounds;
  std::uint64_t primitive_count = 0;

  explicit State(const Scene& asked) : scene(asked) {}
  void choose_search(Search search);
  bool is_alone_inside(const Departures& departures) const {
    return tree != nullptr && departures.size() == 1 && departures[0].inside && alone[departures[0].object];
  }
  Nearest nearest(const Ray& ray, const Departures& departures) const;
  void leave_mesh(const Ray& ray, const Departure& left, Nearest& found) const;
  /// Describe a candidate as a crossing of the hit; the point on its surface.
  Vec3 add_crossing(const Ray& ray, const Nearest::Candidate& candidate, Hit& hit) const;
};

namespace {

std::uint64_t part_count(const Primitive& primitive) {
  const auto* mesh = std::get_if<Mesh>(&primitive);
  return mesh == nullptr ? 1 : mesh->triangle_count();
}

}  // namespace

void Intersector::State::choose_search(Search search) {
  // Ask few primitives one after the other; put many into a tree, except those without an end and those so large
  // against the typical one that their boxes would hold everything.
  const bool all_listed = search == Search::list || (search == Search::automatic && primitive_count <= kLongestList);
  std::vector<double> sizes;
  for (const Primitive& primitive : primitives)
    if (const Bounds box = vitrail::bounds(primitive); box.is_finite())
      sizes.push_back(largest_coordinate(box.max - box.min));
  std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2), sizes.end());
  const double typical = sizes.empty() ? 0 : sizes[sizes.size() / 2];

  std::vector<TreeItem> items;
  std::uint64_t large = 0;
  for (std::uint32_t object = 0; object < primitives.size(); ++object) {
    const Bounds box = vitrail::bounds(primitives[object]);
    const bool is_large = box.is_finite() && largest_coordinate(box.max - box.min) > 1024 * typical && ++large <= 16;
    const auto* mesh = std::get_if<Mesh>(&primitives[object]);
    if (all_listed || !box.is_finite() || (is_large && mesh == nullptr)) {
      list.push_back(object);
    } else if (mesh == nullptr) {
      items.push_back({object, TreeItem::kWhole});
    } else {
      for (std::uint32_t triangle = 0; triangle < mesh->triangle_count(); ++triangle)
        items.push_back({object, triangle});
    }
  }
  // A mesh is held as triangles, which do not tell inside from outside: ask it as a whole.
  for (std::uint32_t object = 0; object < primitives.size(); ++object) {
    const bool listed = std::find(list.begin(), list.end(), object) != list.end();
    const bool is_mesh = std::holds_alternative<Mesh>(primitives[object]);
    if (scene.material_of(object).transmits() && (listed || is_mesh)) listed_solids.push_back(object);
  }
  if (items.empty()) return;
  tree = std::make_unique<EmbreeSearch>(primitives, std::move(items));
  alone = solids_alone(primitives, list);
}

Nearest Intersector::State::nearest(const Ray& ray, const Departures& departures) const {
  Nearest found(ray);
  for (const std::uint32_t object : list) {
    ShapeHit hit;
    if (intersect(primitives[object], ray, departure_of(departures, object), hit)) found.offer(object, hit);
  }
  // A ray inside a solid that stands alone comes to its own face before any other of the tree.
  if (is_alone_inside(departures)) {
    ShapeHit hit;
    if (intersect(primitives[departures[0].object], ray, &departures[0], hit)) {
      found.offer(departures[0].object, hit);
      return found;
    }
  }
  if (tree) tree->closest(ray, departures, found);
  for (const Departure& left : departures)
    if (left.inside && std::holds_alternative<Mesh>(primitives[left.object])) [[unlikely]]
      leave_mesh(ray, left, found);
  return found;
}

void Intersector::State::leave_mesh(const Ray& ray, const Departure& left, Nearest& found) const {
  // A ray inside a mesh goes out next. If the next triangle is entered, or none is met, it started so close to an edge
  // that rounding let it slip past the way out: it leaves here and now.
  const ShapeHit now{0, left.face, false};
  for (const Nearest::Candidate& candidate : found.all())
    if (candidate.object == left.object) {
      if (candidate.entering) found.offer(left.object, now);
      return;
    }
  const Mesh& mesh = std::get<Mesh>(primitives[left.object]);
  ShapeHit next;
  if (found.empty() ||
      (mesh.is_near_edge(ray.origin, left.face) && (!mesh.intersect(ray, &left, next) || next.entering)))
    found.offer(left.object, now);
}

Vec3 Intersector::State::add_crossing(const Ray& ray, const Nearest::Candidate& candidate, Hit& hit) const {
  const Primitive& primitive = primitives[candidate.object];
  const SurfacePoint at = surface(primitive, ray.at(candidate.t), candidate.face);
  const auto* mesh = std::get_if<Mesh>(&primitive);
  hit.crossings.push_back(
      {.t = candidate.t,
       .object = candidate.object,
       .face = candidate.face,
       .entering = candidate.entering,
       .counted = mesh != nullptr,
       .s = at.s,
       .q = at.q,
       .normal = at.normal,
       .shading_normal = mesh != nullptr ? mesh->shading_normal(at.point, candidate.face) : at.normal});
  return at.point;
}

Intersector::Intersector(const Scene& scene, Search search) : state_(std::make_unique<State>(scene)) {
  for (const Object& object : scene.objects) {
    state_->primitives.push_back(make_primitive(object.shape));
    const auto* mesh = std::get_if<Mesh>(&state_->primitives.back());
    if (mesh != nullptr && scene.materials[object.material].transmits() && !mesh->open_fault().empty())
      throw InputError({{object.name, mesh->open_fault() + ", and it is of glass",
                         "close the mesh with outward triangles, or take an opaque material"}});
    state_->primitive_count += part_count(state_->primitives.back());
    const Bounds box = vitrail::bounds(state_->primitives.back());
    if (box.is_finite()) state_->bounds.add(box);
  }
  state_->choose_search(search);
}

Intersector::~Intersector() = default;
Intersector::Intersector(Intersector&&) noexcept = default;
Intersector& Intersector::operator=(Intersector&&) noexcept = default;

bool Intersector::closest(const Ray& ray, const Departures& departures, Hit& hit) const {
  const Nearest found = state_->nearest(ray, departures);
  if (found.empty()) return false;
  const Nearest::Candidate& first = found.first();
  hit.t = first.t;
  hit.crossings.clear();
  hit.point = state_->add_crossing(ray, first, hit);
  if (found.all().size() == 1) return true;

  // Add the faces that lie on this one within rounding: the gap along the ray, seen along the normal.
  const double slant = std::abs(dot(ray.direction, hit.crossings[0].normal));
  const auto error = [&](const Nearest::Candidate& c) {
    return hit_error(ray, c.t, coordinate_scale(state_->primitives[c.object]));
  };
  for (int i = 1; i < found.all().size(); ++i) {
    const Nearest::Candidate& other = found.all()[i];
    if ((other.t - first.t) * slant <= error(first) + error(other)) state_->add_crossing(ray, other, hit);
  }
  std::sort(hit.crossings.begin(), hit.crossings.end(),
            [](const Crossing& a, const Crossing& b) { return a.object < b.object; });
  return true;
}

bool Intersector::occluded(const Ray& ray, const Departures& departures, double t_max) const {
  // A light on a surface is not behind that surface: leave out what rounding cannot tell from the light itself.
  const double before = t_max - hit_error(ray, t_max, 0);
  const double limit = t_max < kInfinity ? before : t_max;
  for (const std::uint32_t object : state_->list) {
    ShapeHit hit;
    if (intersect(state_->primitives[object], ray, departure_of(departures, object), hit) && hit.t < limit) return true;
  }
  return state_->tree != nullptr && state_->tree->occluded(ray, departures, limit);
}

MediumSet Intersector::media_at(Vec3 point) const {
  MediumSet media;
  for (const std::uint32_t object : state_->listed_solids)
    if (contains(state_->primitives[object], point)) media.enter(object);
  if (state_->tree == nullptr) return media;

  thread_local std::vector<TreeItem> items;
  items.clear();
  state_->tree->around(point, items);
  for (const TreeItem& item : items)
    if (item.triangle == TreeItem::kWhole && state_->scene.material_of(item.object).transmits() &&
        contains(state_->primitives[item.object], point))
      media.enter(item.object);
  return media;
}

Bounds Intersector::bounds() const { return state_->bounds; }
Bounds Intersector::object_bounds(std::uint32_t object) const { return vitrail::bounds(state_->primitives[object]); }
std::uint64_t Intersector::primitive_count() const { return state_->primitive_count; }

}  // namespace vitrail
