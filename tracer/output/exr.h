#pragma once
/// The image file: one part, float channels, radiance with its halves, variance and layers. The only door to OpenEXR.

#include <map>
#include <string>

#include "render/film.h"

namespace vitrail {

/// Write R, G, B (radiance); half_a.*, half_b.*; variance.* = (half_a - half_b)^2 / 4, the variance of the mean; and
/// every layer that is planned or not black. The layers sum to the radiance to rounding of float. `metadata` goes into
/// the header as strings. Written beside the path first and then moved, so that no half-written file is ever seen.
/// Throws InputError if the file cannot be written.
void write_exr(const std::string& path, const Film& film, const Plan& plan,
               const std::map<std::string, std::string>& metadata);

}  // namespace vitrail
