#include "geometry/mesh_file.h"

#include <cctype>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include "base/diagnostic.h"

namespace vitrail {

namespace {

[[noreturn]] void refuse(const std::string& where, const std::string& what, const std::string& remedy) {
  throw InputError({{where, what, remedy}});
}

std::string read_all(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) refuse(path, "cannot be read", "name an existing PLY or OBJ file");
  return text.str();
}

/// Add a polygon as a fan of triangles.
void add_polygon(MeshData& mesh, const std::vector<std::uint32_t>& corners) {
  for (std::size_t i = 2; i < corners.size(); ++i) mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

// --- OBJ -------------------------------------------------------------------------------------------------------------

/// "7", "7/1", "7//3": the vertex; negative numbers count from the end.
std::uint32_t obj_corner(const std::string& word, std::size_t vertices, const std::string& where) {
  char* end = nullptr;
  const long long given = std::strtoll(word.c_str(), &end, 10);
  const long long index = given < 0 ? static_cast<long long>(vertices) + given : given - 1;
  if (end == word.c_str() || index < 0 || index >= static_cast<long long>(vertices))
    refuse(where, "names the vertex " + word, "name one of the vertices above the face");
  return static_cast<std::uint32_t>(index);
}

MeshData read_obj(const std::string& path) {
  MeshData mesh;
  std::istringstream file(read_all(path));
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
      if (corners.size() < 3) refuse(where, "is no face", "write f and at least three corners");
      add_polygon(mesh, corners);
    }
  }
  return mesh;
}

// --- PLY -------------------------------------------------------------------------------------------------------------

struct PlyProperty {
  std::string name, type, count_type;  // count_type is empty unless a list
};
struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

/// Numbers of the body one after the other, from text or little-endian bytes.
class PlyBody {
 public:
  PlyBody(const std::string& path, const std::string& text, std::size_t start, bool binary)
      : path_(path), text_(text), at_(start), binary_(binary) {}

  double next(const std::string& type) { return binary_ ? next_binary(type) : next_text(); }

 private:
  double next_text() {
    char* end = nullptr;
    const double value = std::strtod(text_.c_str() + at_, &end);
    if (end == text_.c_str() + at_) fail("a number is missing");
    at_ = static_cast<std::size_t>(end - text_.c_str());
    return value;
  }
  template <typename Number>
  double take() {
    if (text_.size() - at_ < sizeof(Number)) fail("the file ends too early");
    Number value;
    std::memcpy(&value, text_.data() + at_, sizeof(Number));
    at_ += sizeof(Number);
    return static_cast<double>(value);
  }
  double next_binary(const std::string& type) {
    if (type == "float" || type == "float32") return take<float>();
    if (type == "double" || type == "float64") return take<double>();
    if (type == "uchar" || type == "uint8") return take<std::uint8_t>();
    if (type == "char" || type == "int8") return take<std::int8_t>();
    if (type == "ushort" || type == "uint16") return take<std::uint16_t>();
    if (type == "short" || type == "int16") return take<std::int16_t>();
    if (type == "uint" || type == "uint32") return take<std::uint32_t>();
    if (type == "int" || type == "int32") return take<std::int32_t>();
    fail("the property type " + type + " is unknown");
  }
  [[noreturn]] void fail(const std::string& what) {
    refuse(path_ + ": byte " + std::to_string(at_), what, "write a complete PLY file");
  }

  std::string path_;
  const std::string& text_;
  std::size_t at_;
  bool binary_;
};

std::vector<PlyElement> read_ply_header(const std::string& path, const std::string& text, std::size_t& body,
                                        bool& binary) {
  std::vector<PlyElement> elements;
  std::istringstream file(text);
  std::string line, word;
  bool format = false;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    const std::string where = path + ":" + std::to_string(number);
    std::istringstream words(line);
    words >> word;
    if (number == 1 && word != "ply") refuse(where, "does not begin with `ply`", "write a PLY file");
    if (word == "end_header") {
      if (!format) refuse(where, "no format was given", "add `format ascii 1.0`");
      body = static_cast<std::size_t>(file.tellg());
      return elements;
    }
    if (word == "format") {
      words >> word;
      if (word != "ascii" && word != "binary_little_endian")
        refuse(where, "has the format " + word, "write it as ascii or binary_little_endian");
      binary = word != "ascii";
      format = true;
    } else if (word == "element") {
      PlyElement element;
      if (!(words >> element.name >> element.count)) refuse(where, "is no element", "write element, name and count");
      if (element.count > text.size()) refuse(where, "announces more than the file can hold", "correct the count");
      elements.push_back(element);
    } else if (word == "property") {
      if (elements.empty()) refuse(where, "has no element above it", "write the element first");
      PlyProperty property;
      words >> property.type;
      if (property.type == "list") words >> property.count_type >> property.type;
      if (!(words >> property.name)) refuse(where, "is no property", "write property, type and name");
      elements.back().properties.push_back(property);
    }
  }
  refuse(path, "has no end_header", "write a complete PLY file");
}

void read_ply_vertex(MeshData& mesh, const PlyElement& element, PlyBody& body) {
  Vec3 position, normal;
  bool has_normal = false;
  for (const PlyProperty& property : element.properties) {
    if (!property.count_type.empty()) {
      for (double left = body.next(property.count_type); left > 0; --left) body.next(property.type);
      continue;
    }
    const double value = body.next(property.type);
    if (property.name == "x") position.x = value;
    if (property.name == "y") position.y = value;
    if (property.name == "z") position.z = value;
    if (property.name == "nx") normal.x = value, has_normal = true;
    if (property.name == "ny") normal.y = value;
    if (property.name == "nz") normal.z = value;
  }
  mesh.vertices.push_back(position);
  if (has_normal) mesh.normals.push_back(normal);
}

void read_ply_face(MeshData& mesh, const PlyElement& element, PlyBody& body, const std::string& path) {
  std::vector<std::uint32_t> corners;
  for (const PlyProperty& property : element.properties) {
    const bool is_list = !property.count_type.empty();
    const double count = is_list ? body.next(property.count_type) : 1;
    const bool wanted = is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
    for (double left = count; left > 0; --left) {
      const double index = body.next(property.type);
      if (!wanted) continue;
      if (!(index >= 0 && index < static_cast<double>(mesh.vertices.size())))
        refuse(path, "has a face that names the vertex " + std::to_string(index), "name one of the vertices");
      corners.push_back(static_cast<std::uint32_t>(index));
    }
  }
  add_polygon(mesh, corners);
}

MeshData read_ply(const std::string& path) {
  const std::string text = read_all(path);
  std::size_t start = 0;
  bool binary = false;
  const std::vector<PlyElement> elements = read_ply_header(path, text, start, binary);
  PlyBody body(path, text, start, binary);
  MeshData mesh;
  for (const PlyElement& element : elements)
    for (std::size_t i = 0; i < element.count; ++i) {
      if (element.name == "vertex")
        read_ply_vertex(mesh, element, body);
      else if (element.name == "face")
        read_ply_face(mesh, element, body, path);
      else
        for (const PlyProperty& property : element.properties)
          for (double left = property.count_type.empty() ? 1 : body.next(property.count_type); left > 0; --left)
            body.next(property.type);
    }
  return mesh;
}

}  // namespace

MeshData read_mesh_file(const std::string& path) {
  const std::size_t dot_at = path.find_last_of('.');
  std::string ending = dot_at == std::string::npos ? "" : path.substr(dot_at + 1);
  for (char& letter : ending) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  if (ending != "ply" && ending != "obj") refuse(path, "is neither PLY nor OBJ", "convert the mesh to one of them");

  MeshData mesh = ending == "ply" ? read_ply(path) : read_obj(path);
  for (const Vec3& vertex : mesh.vertices)
    if (!is_finite(vertex)) refuse(path, "has a vertex that is not finite", "write finite coordinates");
  if (mesh.normals.size() != mesh.vertices.size()) mesh.normals.clear();
  return mesh;
}

}  // namespace vitrail
