/// What glass asks of the triangles of a mesh.

#include <gtest/gtest.h>

#include <sstream>

#include "base/diagnostic.h"
#include "build_mesh.h"
#include "geometry/accel.h"
#include "geometry/mesh.h"

namespace vitrail {
namespace {

TEST(Mesh, MustHaveATriangleWithAnArea) {
  EXPECT_THROW(Mesh(mesh_of("")), InputError);
  EXPECT_THROW(Mesh(mesh_of("v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n")), InputError);
}

TEST(Mesh, OfGlassMustBeClosedAndOutward) {
  std::string open = kCube, inverted = "";
  open.erase(open.rfind("f "));
  EXPECT_THROW(Intersector{scene_of(mesh_of(open))}, InputError);
  std::istringstream lines(kCube);
  for (std::string kind, a, b, c, d; lines >> kind;) {
    if (kind == "v") lines >> a >> b >> c, inverted += "v " + a + " " + b + " " + c + "\n";
    if (kind == "f") lines >> a >> b >> c >> d, inverted += "f " + d + " " + c + " " + b + " " + a + "\n";
  }
  EXPECT_THROW(Intersector{scene_of(mesh_of(inverted))}, InputError);
  // A prism over a bow tie, whose smaller half is inside out: closed, and of positive volume.
  const std::string bow_tie =
      "v -2 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 0.5 1 -1\nv -2 -1 1\nv 1 -1 1\nv -1 1 1\nv 0.5 1 1\n"
      "f 1 3 2\nf 1 4 3\nf 5 6 7\nf 5 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  EXPECT_THROW(Intersector{scene_of(mesh_of(bow_tie))}, InputError);
  Scene opaque = scene_of(mesh_of(open));
  opaque.materials[0] = diffuse(0.5);
  EXPECT_NO_THROW(Intersector{opaque});
}

}  // namespace
}  // namespace vitrail
