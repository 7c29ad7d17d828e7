#pragma once
/// The readers of the larger parts of a lowered scene. Private to scene/read*.

#include <cstddef>

#include "scene/json_value.h"
#include "scene/scene.h"

namespace vitrail {

Material read_material(const JsonValue& value, std::size_t bands);
Light read_light(const JsonValue& value);

}  // namespace vitrail
