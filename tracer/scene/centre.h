#pragma once
/// Move a scene to the origin, so that a scene a thousand kilometres away keeps every digit its input has [O 2.10].

#include "scene/scene.h"

namespace vitrail {

/// Subtract a centre from every position and note it in scene.shift. The centre is a multiple of a power of two well
/// above the size of the things in the scene: the subtraction is exact, scenes near the origin do not move at all, and
/// scaling the scene by 2^k scales everything by exactly 2^k.
void centre_scene(Scene& scene);

}  // namespace vitrail
