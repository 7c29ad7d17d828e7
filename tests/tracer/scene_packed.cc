/// Numbers that a lowered scene holds packed: the triangles of a mesh, the pixels of a sky.

#include <gtest/gtest.h>

#include "build_lowered.h"

namespace vitrail {
namespace {

/// A mesh of one triangle in place of the cup: its vertices (0, 0, 0), (1, 0, 0), (0, 1, 0) and what is given.
std::string with_mesh(const std::string& triangles, const std::string& more = "") {
  const std::string vertices =
      "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA8D8AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAADwPwAAAAAAAAAA";
  return with("{\"kind\": \"lathe\",\n      \"profile\": [[0, 0], [0.5, 0], [0.25, 1], [0, 1]],",
              "{\"kind\": \"mesh\", \"smooth\": true, \"vertices\": \"" + vertices + "\", \"triangles\": \"" +
                  triangles + "\", " + more);
}

TEST(ReadScene, UnpacksAMesh) {
  const Scene scene = parse_scene(with_mesh("AAAAAAEAAAACAAAA"));
  const MeshData& mesh = *std::get<MeshShape>(scene.objects[5].shape).data;
  EXPECT_EQ(mesh.vertices, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}}));
  EXPECT_TRUE(mesh.normals.empty());

  const std::string shape = "scene.objects[5].shape.";
  EXPECT_EQ(fault_of(with_mesh("AAAAAAEAAAADAAAA")).find(shape + "triangles: names a vertex that is not there"), 0u);
  EXPECT_EQ(fault_of(with_mesh("AAAAAAEAAAA=")).find(shape + "triangles: holds 2 corners"), 0u);
  for (const char* text : {"AAAAAAEAAAACAAA", "AAAAAAEAAAACAAA*", "AAAAAAEAAAACAA=A", "AAAAAAEAAAACAA==", "===="})
    EXPECT_EQ(fault_of(with_mesh(text)).find(shape + "triangles: is no text of packed numbers"), 0u) << text;
  EXPECT_EQ(fault_of(with_mesh("AAAAAAEAAAACAAAA", "\"normals\": \"AAAAAAAAAAAAAAAAAAAAAAAAAAAAAPA/\","))
                .find(shape + "normals: has not one normal a vertex"),
            0u);
  EXPECT_EQ(fault_of(with_mesh("AAAAAAEAAAACAAAA", "\"normals\": \"AAAAAAAAAAAAAAAAAAAAAAAAAAAAAPB/\","))
                .find(shape + "normals: holds what is not finite"),
            0u);
}

std::string with_sky(const std::string& image) {
  return with("\"kind\": \"environment\", \"radiance\": [1, 1, 1]", "\"kind\": \"environment\", \"image\": " + image);
}

/// Two pixels in one row: (1, 0, 0) on the left, over +x, and (0, 0, 1) on the right.
TEST(ReadScene, UnpacksASky) {
  const Scene scene =
      parse_scene(with_sky("{\"width\": 2, \"height\": 1, \"radiance\": \"AACAPwAAAAAAAAAAAAAAAAAAAAAAAIA/\"}"));
  const auto& sky = std::get<EnvironmentLight>(scene.lights[2].emitter);
  EXPECT_EQ(sky.image->towards({1, 0, 0}), (Rgb{1, 0, 0}));
  EXPECT_EQ(sky.image->towards({-1, 0, 0}), (Rgb{0, 0, 1}));

  const std::string path = "scene.lights[2].image.";
  EXPECT_EQ(fault_of(with_sky("{\"width\": 2, \"height\": 1, \"radiance\": \"AACAPw==\"}"))
                .find(path + "radiance: holds 1 numbers"),
            0u);
  EXPECT_EQ(fault_of(with_sky("{\"width\": 1, \"height\": 1, \"radiance\": \"AACAvwAAAAAAAAAA\"}"))
                .find(path + "radiance: holds a pixel that is negative"),
            0u);
  EXPECT_EQ(
      fault_of(with_sky("{\"width\": 65536, \"height\": 65536, \"radiance\": \"\"}")).find(path + "height: is 65536"),
      0u);
}

}  // namespace
}  // namespace vitrail
