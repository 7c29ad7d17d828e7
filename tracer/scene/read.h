#pragma once
/// From lowered JSON to a Scene; the only place that knows JSON.

#include <string>

#include "scene/scene.h"

namespace vitrail {

/// Read, validate and centre a lowered scene. Throws InputError with every fault found.
Scene read_scene(const std::string& path);

/// The same from text. Does not move the scene to its centre.
Scene parse_scene(const std::string& text);

}  // namespace vitrail
