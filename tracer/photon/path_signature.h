#pragma once
/// Signatures of light paths: two paths have the same signature if they met the same faces in the same order and took
/// the same lobe at each. Where the signature changes from one ray to the next, the light between them has a
/// discontinuity.

#include "material/surface.h"

namespace vitrail {

/// A hash of the faces and lobes from the light on.
enum class PathSignature : std::uint64_t { at_light = 0 };

/// What light does at a face: it ends there, or goes on.
enum class PathStep : std::uint64_t { end, reflect, transmit };

/// The signature of a path that comes to the face of an arrival and takes this step there. A smooth mesh is one face; a
/// flat one has as many as its triangles have normals.
PathSignature extended(const Scene& scene, PathSignature signature, const Arrival& arrival, PathStep step);

/// The signature of a path on which light has become that of one band.
PathSignature in_band(PathSignature signature, std::uint32_t band);

}  // namespace vitrail
