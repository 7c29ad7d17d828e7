/// For libFuzzer: any text is a lowered scene or is refused; nothing else may happen. The tracer reads no other file.
///
///   tools/build.sh fuzz fuzz_lowered_scene
///   build/fuzz/tests/tracer/fuzz_lowered_scene -max_total_time=3600 build/corpus tests/golden tests/tracer/fuzz/corpus

#include <cstddef>
#include <cstdint>
#include <string>

#include "base/diagnostic.h"
#include "geometry/accel.h"
#include "scene/centre.h"
#include "scene/read.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    vitrail::Scene scene = vitrail::parse_scene(std::string(reinterpret_cast<const char*>(data), size));
    vitrail::centre_scene(scene);
    const vitrail::Intersector intersector(scene);
  } catch (const vitrail::InputError&) {
  }
  return 0;
}
