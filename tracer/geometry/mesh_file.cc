#include "geometry/mesh_file.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include "base/diagnostic.h"
#include "geometry/obj_file.h"
#include "geometry/polygon_cut.h"

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

struct PlyProperty {
  std::string name, type, count_type;  // count_type is empty unless a list
};
struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyFormat { ascii, little_endian, big_endian };

/// Numbers of the body one after the other, from text or bytes.
class PlyBody {
 public:
  PlyBody(const std::string& path, const std::string& text, std::size_t start, PlyFormat format)
      : path_(path), text_(text), at_(start), format_(format) {}

  double next(const std::string& type) { return format_ == PlyFormat::ascii ? next_text() : next_binary(type); }

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
    char bytes[sizeof(Number)];
    std::copy_n(text_.data() + at_, sizeof(Number), bytes);
    const bool turned = (format_ == PlyFormat::big_endian) != (std::endian::native == std::endian::big);
    if (turned) std::reverse(bytes, bytes + sizeof(Number));
    std::memcpy(&value, bytes, sizeof(Number));
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
  PlyFormat format_;
};

std::vector<PlyElement> read_ply_header(const std::string& path, const std::string& text, std::size_t& body,
                                        PlyFormat& format) {
  std::vector<PlyElement> elements;
  std::istringstream file(text);
  std::string line, word;
  bool has_format = false;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    const std::string where = path + ":" + std::to_string(number);
    std::istringstream words(line);
    words >> word;
    if (number == 1 && word != "ply") refuse(where, "does not begin with `ply`", "write a PLY file");
    if (word == "end_header") {
      if (!has_format) refuse(where, "no format was given", "add `format ascii 1.0`");
      body = static_cast<std::size_t>(file.tellg());
      return elements;
    }
    if (word == "format") {
      words >> word;
      if (word == "ascii")
        format = PlyFormat::ascii;
      else if (word == "binary_little_endian")
        format = PlyFormat::little_endian;
      else if (word == "binary_big_endian")
        format = PlyFormat::big_endian;
      else
        refuse(where, "has the format " + word, "write it as ascii, binary_little_endian or binary_big_endian");
      has_format = true;
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

[[noreturn]] void refuse_vertex(const std::string& path, double index) {
  refuse(path, "has a face that names the vertex " + std::to_string(index), "name one of the vertices");
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

/// Corners of all polygons one after the other; `ends` says where each stops.
struct PlyFaces {
  std::vector<std::uint32_t> corners;
  std::vector<std::size_t> ends;
};

void read_ply_face(PlyFaces& faces, const PlyElement& element, PlyBody& body, const std::string& path) {
  for (const PlyProperty& property : element.properties) {
    const bool is_list = !property.count_type.empty();
    const double count = is_list ? body.next(property.count_type) : 1;
    const bool wanted = is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
    for (double left = count; left > 0; --left) {
      const double index = body.next(property.type);
      if (!wanted) continue;
      if (!(index >= 0 && index <= 4294967295.0)) refuse_vertex(path, index);
      faces.corners.push_back(static_cast<std::uint32_t>(index));
    }
  }
  faces.ends.push_back(faces.corners.size());
}

/// Cut the polygons once all vertices are known: a file may list its faces first.
void add_ply_faces(MeshData& mesh, const PlyFaces& faces, const std::string& path) {
  for (const std::uint32_t index : faces.corners)
    if (index >= mesh.vertices.size()) refuse_vertex(path, index);
  std::size_t start = 0;
  for (const std::size_t end : faces.ends) {
    const auto first = faces.corners.begin() + static_cast<std::ptrdiff_t>(start);
    add_polygon(mesh, {first, faces.corners.begin() + static_cast<std::ptrdiff_t>(end)}, path);
    start = end;
  }
}

MeshData read_ply(const std::string& path) {
  const std::string text = read_all(path);
  std::size_t start = 0;
  PlyFormat format = PlyFormat::ascii;
  const std::vector<PlyElement> elements = read_ply_header(path, text, start, format);
  PlyBody body(path, text, start, format);
  MeshData mesh;
  PlyFaces faces;
  for (const PlyElement& element : elements)
    for (std::size_t i = 0; i < element.count; ++i) {
      if (element.name == "vertex")
        read_ply_vertex(mesh, element, body);
      else if (element.name == "face")
        read_ply_face(faces, element, body, path);
      else
        for (const PlyProperty& property : element.properties)
          for (double left = property.count_type.empty() ? 1 : body.next(property.count_type); left > 0; --left)
            body.next(property.type);
    }
  add_ply_faces(mesh, faces, path);
  return mesh;
}

}  // namespace

MeshData read_mesh_file(const std::string& path) {
  const std::size_t dot_at = path.find_last_of('.');
  std::string ending = dot_at == std::string::npos ? "" : path.substr(dot_at + 1);
  for (char& letter : ending) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  if (ending != "ply" && ending != "obj") refuse(path, "is neither PLY nor OBJ", "convert the mesh to one of them");

  MeshData mesh = ending == "ply" ? read_ply(path) : read_obj(path, read_all(path));
  for (const Vec3& vertex : mesh.vertices)
    if (!is_finite(vertex)) refuse(path, "has a vertex that is not finite", "write finite coordinates");
  if (mesh.normals.size() != mesh.vertices.size()) mesh.normals.clear();
  return mesh;
}

}  // namespace vitrail
