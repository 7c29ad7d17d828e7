#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "base/diagnostic.h"
#include "material/path.h"
#include "scene/read.h"

namespace vitrail {

namespace {

struct TraceOptions {
  std::string path;
  std::vector<double> origin, direction;
  std::uint32_t band = 0;
  std::string branch = "transmit";
  int max_vertices = 64;
};

nlohmann::json triplet(Vec3 v) { return {v.x, v.y, v.z}; }
nlohmann::json triplet(Rgb c) { return {c.r, c.g, c.b}; }

nlohmann::json name_of(const Scene& scene, std::uint32_t object) {
  return object == kAir ? nlohmann::json() : nlohmann::json(scene.objects[object].name);
}

nlohmann::json vertex_json(const Scene& scene, const PathVertex& vertex) {
  const bool escaped = vertex.event == PathEvent::escape;
  return {{"point", escaped ? nlohmann::json() : triplet(vertex.point + scene.shift)},
          {"direction_in", triplet(vertex.direction_in)},
          {"direction_out", triplet(vertex.direction_out)},
          {"normal", escaped ? nlohmann::json() : triplet(vertex.normal)},
          {"object", name_of(scene, vertex.object)},
          {"event", event_name(vertex.event)},
          {"medium", vertex.medium == kAir ? nlohmann::json("air") : name_of(scene, vertex.medium)},
          {"distance_m", escaped ? nlohmann::json() : nlohmann::json(vertex.distance)},
          {"throughput", triplet(vertex.throughput)},
          {"R", vertex.R},
          {"T", vertex.T}};
}

Vec3 vector_option(const std::vector<double>& values, const char* option) {
  const Vec3 vector{values[0], values[1], values[2]};
  if (!is_finite(vector)) throw InputError({{option, "is not finite", "write three finite numbers X,Y,Z"}});
  return vector;
}

void run_trace(const TraceOptions& options) {
  const Scene scene = read_scene(options.path);
  const Intersector intersector(scene);
  const Vec3 direction = vector_option(options.direction, "--direction");
  const double largest = largest_coordinate(direction);
  if (!(largest > 0)) throw InputError({{"--direction", "is the zero vector", "give it a length"}});
  if (options.band >= scene.bands.size())
    throw InputError({{"--band", "is " + std::to_string(options.band),
                       "the scene has the bands 0 to " + std::to_string(scene.bands.size() - 1)}});

  // Scale by the largest coordinate first, so that no square overflows.
  const Ray ray{vector_option(options.origin, "--origin") - scene.shift, normalise(direction / largest)};
  const FollowedBranch branch = options.branch == "reflect" ? FollowedBranch::reflect : FollowedBranch::transmit;
  nlohmann::json vertices = nlohmann::json::array();
  for (const PathVertex& vertex : follow({scene, intersector}, ray, options.band, branch, options.max_vertices))
    vertices.push_back(vertex_json(scene, vertex));
  std::cout << nlohmann::json{{"vertices", vertices}}.dump() << '\n';
}

}  // namespace

void add_trace_command(CLI::App& app, int&) {
  auto options = std::make_shared<TraceOptions>();
  CLI::App* command = app.add_subcommand("trace", "Follow one ray and print its vertices as JSON");
  command->add_option("scene", options->path, "lowered scene, JSON")->required();
  command->add_option("--origin", options->origin, "X,Y,Z in metres")->delimiter(',')->expected(3)->required();
  command->add_option("--direction", options->direction, "X,Y,Z")->delimiter(',')->expected(3)->required();
  command->add_option("--band", options->band, "index of the band, from 0");
  command->add_option("--branch", options->branch, "which way at each surface")
      ->check(CLI::IsMember({"transmit", "reflect"}));
  command->add_option("--max-vertices", options->max_vertices, "stop after so many")->check(CLI::Range(1, 1000000));
  command->callback([options] { run_trace(*options); });
}

}  // namespace vitrail
