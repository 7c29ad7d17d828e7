/// Mesh files: what is read, what is refused, and what glass asks of them.

#include <gtest/gtest.h>

#include <cstdint>
#include <sstream>

#include "base/diagnostic.h"
#include "build_mesh.h"
#include "geometry/accel.h"
#include "geometry/mesh.h"
#include "geometry/mesh_file.h"

namespace vitrail {
namespace {

TEST(MeshFile, ReadsTheSameFromTextAndBytes) {
  const std::string header =
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const MeshData text = read_mesh_file(
      write_file("a.ply", "ply\nformat ascii 1.0\ncomment x\n" + header + "0 0 0.5\n1 0 0\n0 1 0\n3 0 1 2\n"));
  std::string bytes = "ply\nformat binary_little_endian 1.0\n" + header;
  for (const float value : {0.f, 0.f, .5f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f})
    bytes.append(reinterpret_cast<const char*>(&value), 4);
  bytes += '\3';
  for (const std::int32_t value : {0, 1, 2}) bytes.append(reinterpret_cast<const char*>(&value), 4);
  const MeshData binary = read_mesh_file(write_file("b.PLY", bytes));
  EXPECT_EQ(text.vertices, binary.vertices);
  EXPECT_EQ(text.triangles, binary.triangles);
  EXPECT_EQ(text.vertices[0], (Vec3{0, 0, 0.5}));
  const MeshData cube = read_mesh_file(write_file("c.obj", kCube));
  EXPECT_EQ(cube.triangles.size(), 12u);
}

TEST(MeshFile, ReadsBytesOfEitherOrderAndFacesBeforeVertices) {
  std::string bytes =
      "ply\nformat binary_big_endian 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
      "element vertex 3\nproperty double x\nproperty double y\nproperty double z\nend_header\n\3";
  const auto append = [&](const auto value) {
    const auto* first = reinterpret_cast<const char*>(&value);
    for (std::size_t i = sizeof value; i-- > 0;) bytes += first[i];  // this machine has the lowest byte first
  };
  for (const std::int32_t index : {0, 1, 2}) append(index);
  for (const double value : {0.1, 0., 0., 1., 0., 0., 0., 1., 0.}) append(value);
  const MeshData mesh = read_mesh_file(write_file("big.ply", bytes));
  EXPECT_EQ(mesh.vertices[0], (Vec3{0.1, 0, 0}));
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}}));
}

TEST(MeshFile, CutsConcavePolygonsIntoEars) {
  // An arrow head that points to +y with its notch at the origin: a fan from its first corner would cover the notch.
  const MeshData mesh = read_mesh_file(write_file("arrow.obj", "v -1 -1 0\nv 0 0 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3 4\n"));
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const double doubled = cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]).z;
    EXPECT_GT(doubled, 0);
    area += doubled / 2;
  }
  EXPECT_EQ(area, 1);
  // The normals of the file are taken where every vertex has one; faces of two corners enclose nothing.
  const MeshData smooth = read_mesh_file(write_file(
      "normals.obj", "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn 0 0 1\nvn 0 1 0\nf 1//1 2//2 3//3\nf 1 2\n"));
  ASSERT_EQ(smooth.normals.size(), 3u);
  EXPECT_EQ(smooth.normals[2], (Vec3{0, 1, 0}));
  EXPECT_EQ(smooth.triangles.size(), 1u);
}

TEST(MeshFile, RefusesWhatItCannotUse) {
  const char* const wrong[][2] = {
      {"missing.stl", "solid"},
      {"a.obj", "v 1 2\n"},
      {"b.obj", "v 0 0 0\nf 1 2 3\n"},
      {"c.obj", "v 0 0 0\nf 1 1\n"},
      {"c2.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3 4\n"},
      {"d.obj", "v 0 0 nan\n"},
      {"e.obj", ""},
      {"f.ply", ""},
      {"g.ply", "ply\nend_header\n"},
      {"h.ply", "ply\nformat ascii 1.0\n"},
      {"i.ply", "ply\nformat binary_middle_endian 1.0\nend_header\n"},
      {"j.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999\nend_header\n"},
      {"k.ply", "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nend_header\n1\n"},
      {"l.ply", "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n3 0 1 2\n"},
      {"m.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n"}};
  for (const auto& [name, content] : wrong) EXPECT_THROW(Mesh(mesh_of(write_file(name, content))), InputError) << name;
  EXPECT_THROW(read_mesh_file("/does/not/exist.ply"), InputError);
}

TEST(MeshFile, GlassMustBeClosedAndOutward) {
  std::string open = kCube, inverted = "";
  open.erase(open.rfind("f "));
  EXPECT_THROW(Intersector{scene_of(mesh_of(write_file("open.obj", open)))}, InputError);
  std::istringstream lines(kCube);
  for (std::string kind, a, b, c, d; lines >> kind;) {
    if (kind == "v") lines >> a >> b >> c, inverted += "v " + a + " " + b + " " + c + "\n";
    if (kind == "f") lines >> a >> b >> c >> d, inverted += "f " + d + " " + c + " " + b + " " + a + "\n";
  }
  EXPECT_THROW(Intersector{scene_of(mesh_of(write_file("inverted.obj", inverted)))}, InputError);
  // A prism over a bow tie, whose smaller half is inside out: closed, and of positive volume.
  const std::string bow_tie =
      "v -2 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 0.5 1 -1\nv -2 -1 1\nv 1 -1 1\nv -1 1 1\nv 0.5 1 1\n"
      "f 1 3 2\nf 1 4 3\nf 5 6 7\nf 5 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  EXPECT_THROW(Intersector{scene_of(mesh_of(write_file("bow_tie.obj", bow_tie)))}, InputError);
  Scene opaque = scene_of(mesh_of(write_file("open.obj", open)));
  opaque.materials[0] = diffuse(0.5);
  EXPECT_NO_THROW(Intersector{opaque});
}

}  // namespace
}  // namespace vitrail
