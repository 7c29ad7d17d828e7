#include "scene/validate.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace vitrail {

namespace {

bool encloses_nothing(const Shape& shape) {
  return std::holds_alternative<RectangleShape>(shape) || std::holds_alternative<DiscShape>(shape);
}

bool is_flat(const Shape& shape) { return encloses_nothing(shape) || std::holds_alternative<PlaneShape>(shape); }

void check_object(const Scene& scene, std::size_t index, std::vector<Diagnostic>& faults) {
  const Object& object = scene.objects[index];
  const std::string path = "scene.objects[" + std::to_string(index) + "].shape";
  if (object.material >= scene.materials.size()) {
    faults.push_back({path, "has no material", "add a material to scene.materials"});
    return;
  }

  const Material& material = scene.materials[object.material];
  if (material.transmits() && encloses_nothing(object.shape))
    faults.push_back({path, "transmits light but encloses nothing", "use a box or another closed shape"});
  const bool pattern =
      std::holds_alternative<Checker>(material.diffuse) || std::holds_alternative<Checker>(material.emission);
  if (pattern && !is_flat(object.shape))
    faults.push_back({path, "has a checker pattern but no surface coordinates", "use a plane, rectangle or disc"});
}

/// Bands together must carry each channel exactly once, within the rounding of a sum of at most 256 decimal fractions
/// that were computed and not typed.
void check_bands(const Scene& scene, std::vector<Diagnostic>& faults) {
  Rgb sum;
  for (const Band& band : scene.bands) sum += band.weight;
  for (int channel = 0; channel < 3; ++channel)
    if (!(std::abs(sum[channel] - 1) <= 1e-9)) {
      faults.push_back({"scene.bands", "have weights that do not add up to 1 in every channel", "scale them"});
      return;
    }
}

// Whether a name can name a file in a folder: a word of at most 200 bytes that neither hides the file nor leaves the
// folder.
bool is_file_name(const std::string& name) {
  constexpr std::size_t kLongest = 200;
  const auto is_wrong = [](unsigned char c) { return c < ' ' || c == 0x7f || c == '/' || c == '\\'; };
  return !name.empty() && name.size() <= kLongest && name.front() != '.' &&
         std::none_of(name.begin(), name.end(), is_wrong);
}

void check_views(const Scene& scene, std::vector<Diagnostic>& faults) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < scene.views.size(); ++i) {
    const std::string path = "scene.views[" + std::to_string(i) + "].name", &name = scene.views[i].view;
    if (!is_file_name(name))
      faults.push_back({path, "cannot name a file",
                        "write 1 to 200 characters without / and \\ that do not begin with a full stop"});
    if (!names.insert(name).second)
      faults.push_back({path, "is also the name of another view", "give every view a name of its own"});
  }
}

}  // namespace

std::vector<Diagnostic> validate(const Scene& scene) {
  std::vector<Diagnostic> faults;
  check_bands(scene, faults);
  check_views(scene, faults);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) check_object(scene, i, faults);
  return faults;
}

}  // namespace vitrail
