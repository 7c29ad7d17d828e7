#pragma once
/// Small meshes for the tests, as text.

#include <cstdio>
#include <sstream>
#include <string>

#include "build_scene.h"

namespace vitrail {

/// A cube of half edge 1 with two triangles a side.
inline const char* const kCube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// A ball of latitude and longitude, `steps` from pole to pole, as OBJ text.
inline std::string ball_text(int steps) {
  std::string text = "v 0 1 0\n";
  char line[200];
  for (int i = 1; i < steps; ++i)
    for (int j = 0; j < 2 * steps; ++j) {
      const double polar = kPi * i / steps, turn = kPi * j / steps;
      std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", std::sin(polar) * std::cos(turn), std::cos(polar),
                    -std::sin(polar) * std::sin(turn));
      text += line;
    }
  text += "v 0 -1 0\n";
  const auto at = [&](int i, int j) {
    if (i == 0) return 1;
    if (i == steps) return 2 + (steps - 1) * 2 * steps;
    return 2 + (i - 1) * 2 * steps + j % (2 * steps);
  };
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < 2 * steps; ++j) {
      const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (i > 0) text += "f " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(d) + "\n";
      if (i + 1 < steps) text += "f " + std::to_string(d) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
    }
  return text;
}

/// The triangles of an OBJ text that has vertices and convex faces alone.
inline MeshData data_of(const std::string& text) {
  MeshData data;
  std::istringstream lines(text);
  for (std::string line, kind; std::getline(lines, line);) {
    std::istringstream words(line);
    words >> kind;
    Vec3 v;
    if (kind == "v" && words >> v.x >> v.y >> v.z) data.vertices.push_back(v);
    std::vector<std::uint32_t> corners;
    for (std::uint32_t corner = 0; kind == "f" && words >> corner;) corners.push_back(corner - 1);
    for (std::size_t i = 2; i < corners.size(); ++i) data.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
  return data;
}

inline MeshShape mesh_of(const std::string& text, bool smooth = false, const Frame& frame = {}) {
  return {std::make_shared<const MeshData>(data_of(text)), smooth, frame};
}

inline Scene scene_of(const MeshShape& shape) {
  SceneBuilder builder;
  builder.add("mesh", shape, builder.add(glass(1.5)));
  return builder.scene;
}

}  // namespace vitrail
