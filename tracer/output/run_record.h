#pragma once
/// What a run did, as JSON: settings used, CPU seconds by phase, counters, energy ledger, warnings.

#include <string>

#include "render/render.h"

namespace vitrail {

/// What the record says besides the rendering itself.
struct RunFacts {
  std::string version;
  unsigned threads = 1;
  double cpu_total_s = 0, wall_s = 0;
};

/// The settings actually used for a picture of the scene, as a JSON object on one line; also in the header of its
/// image.
std::string settings_json(const Scene& scene, const Picture& picture);

std::string run_record_json(const Scene& scene, const Rendering& rendering, const RunFacts& facts);

/// Throws OutputError if the file cannot be written.
void write_text(const std::string& path, const std::string& text);

}  // namespace vitrail
