#pragma once
/// Rules between the parts of a scene; the range of each number alone is checked where it is read.

#include <vector>

#include "base/diagnostic.h"
#include "scene/scene.h"

namespace vitrail {

/// Everything that makes a scene of well-formed parts impossible to render. Empty: the scene is sound.
std::vector<Diagnostic> validate(const Scene& scene);

}  // namespace vitrail
