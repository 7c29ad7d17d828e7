#include "geometry/obj_file.h"

#include <cstdlib>
#include <sstream>

#include "base/diagnostic.h"
#include "geometry/polygon_cut.h"

namespace vitrail {

namespace {

[[noreturn]] void refuse(const std::string& where, const std::string& what, const std::string& remedy) {
  throw InputError({{where, what, remedy}});
}

/// "7", "7/1", "7//3": the vertex; negative numbers count from the end.
std::uint32_t obj_corner(const std::string& word, std::size_t vertices, const std::string& where) {
  char* end = nullptr;
  const long long given = std::strtoll(word.c_str(), &end, 10);
  const long long index = given < 0 ? static_cast<long long>(vertices) + given : given - 1;
  if (end == word.c_str() || index < 0 || index >= static_cast<long long>(vertices))
    refuse(where, "names the vertex " + word, "name one of the vertices above the face");
  return static_cast<std::uint32_t>(index);
}

}  // namespace

MeshData read_obj(const std::string& path, std::string text) {
  MeshData mesh;
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);  // a byte order mark
  std::istringstream file(text);
  std::string line;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    const std::string where = path + ":" + std::to_string(number);
    std::istringstream words(line);
    std::string kind, word;
    words >> kind;
    if (kind == "v") {
      Vec3 v;
      if (!(words >> v.x >> v.y >> v.z)) refuse(where, "is no vertex", "write v and three numbers");
      mesh.vertices.push_back(v);
    } else if (kind == "f") {
      std::vector<std::uint32_t> corners;
      while (words >> word) corners.push_back(obj_corner(word, mesh.vertices.size(), where));
      add_polygon(mesh, corners, where);
    } else if (kind == "vn") {
      Vec3 n;
      if (!(words >> n.x >> n.y >> n.z)) refuse(where, "is no normal", "write vn and three numbers");
      mesh.normals.push_back(n);
    }
  }
  return mesh;
}

}  // namespace vitrail
