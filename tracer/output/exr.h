#pragma once
/// The image file: one part, float channels, radiance with its halves and layers. The only door to OpenEXR.

#include <map>
#include <string>

#include "render/film.h"

namespace vitrail {

/// Write R, G, B (radiance, the mean of the halves); half_a.*, half_b.*; and every layer that is planned or not black.
/// The variance of the mean is (half_a - half_b)^2 / 4, and not written. The layers sum to the radiance to rounding of
/// float. `metadata` goes into the header as strings. Written beside the path first and then moved, so that no
/// half-written file is ever seen. The same bytes for any number of threads. Throws OutputError if the file cannot be
/// written.
void write_exr(const std::string& path, const Film& film, const Plan& plan,
               const std::map<std::string, std::string>& metadata, unsigned threads = 1);

}  // namespace vitrail
