#include "material/path.h"

#include <stdexcept>

namespace vitrail {

const char* event_name(PathEvent event) {
  switch (event) {
    case PathEvent::enter:
      return "enter";
    case PathEvent::exit:
      return "exit";
    case PathEvent::reflect:
      return "reflect";
    case PathEvent::total_internal_reflection:
      return "total_internal_reflection";
    case PathEvent::diffuse:
      return "diffuse";
    case PathEvent::absorb:
      return "absorb";
    case PathEvent::escape:
      return "escape";
  }
  throw std::logic_error("no such event");
}

namespace {

/// The branch to follow, or nothing where light ends.
const Branch* choose(const Interaction& event, FollowedBranch wanted) {
  const Branch *first = &event.transmit, *second = &event.reflect;
  if (wanted == FollowedBranch::reflect) std::swap(first, second);
  if (first->exists) return first;
  return second->exists ? second : nullptr;
}

PathEvent classify(const Interaction& event, const Branch* branch) {
  if (branch == nullptr) return is_black(event.diffuse) ? PathEvent::absorb : PathEvent::diffuse;
  if (branch == &event.transmit) return event.entering ? PathEvent::enter : PathEvent::exit;
  return event.total_internal_reflection ? PathEvent::total_internal_reflection : PathEvent::reflect;
}

}  // namespace

std::vector<PathVertex> follow(const World& world, const Ray& ray, std::uint32_t band, FollowedBranch wanted,
                               int max_vertices) {
  std::vector<PathVertex> path;
  PathState state{.ray = ray, .media = world.intersector.media_at(ray.origin), .band = band};
  while (static_cast<int>(path.size()) < max_vertices) {
    const Arrival arrival = advance(world, state);
    state.weight *= arrival.transmittance;
    PathVertex vertex;
    vertex.direction_in = vertex.direction_out = state.ray.direction;
    vertex.distance = arrival.distance;
    vertex.throughput = state.weight;
    vertex.medium = arrival.media.dominant(world.scene);
    if (arrival.escaped) {
      path.push_back(vertex);
      return path;
    }

    // Describe the surface, and go on along the branch if there is one.
    const Interaction& event = arrival.event;
    const Branch* branch = choose(event, wanted);
    vertex.event = classify(event, branch);
    vertex.point = arrival.hit.point;
    vertex.normal = event.facing_normal;
    vertex.object = event.object;
    vertex.R = event.R;
    vertex.T = event.T;
    if (branch != nullptr) {
      state.weight *= branch->weight;
      vertex.throughput = state.weight;
      vertex.direction_out = branch->direction;
      vertex.medium = branch->media.dominant(world.scene);
    }
    path.push_back(vertex);
    if (branch == nullptr) return path;
    state.ray = {arrival.hit.point, branch->direction};
    state.departures = branch->departures;
    state.media = branch->media;
  }
  return path;
}

}  // namespace vitrail
