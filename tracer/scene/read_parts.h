#pragma once
/// The readers of the larger parts of a lowered scene. Private to scene/read*.

#include <cstddef>

#include "scene/json_value.h"
#include "scene/scene.h"

namespace vitrail {

Material read_material(const JsonValue& value, std::size_t bands);
Shape read_shape(const JsonValue& value, const std::string& folder);
RectangleShape read_rectangle(const JsonValue& value);
DiscShape read_disc(const JsonValue& value);
Light read_light(const JsonValue& value, const std::string& folder);

/// A file name as given if absolute, else beside the JSON.
std::string beside(const std::string& folder, const std::string& file);

}  // namespace vitrail
