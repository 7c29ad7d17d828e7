/// The lowered scenes that libFuzzer begins with (tests/tracer/fuzz), damaged in a few hundred places.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/diagnostic.h"
#include "scene/read.h"

namespace vitrail {
namespace {

/// Whether a text is a scene; anything but a refusal by name ends the test.
bool is_scene(const std::string& text) {
  try {
    parse_scene(text);
  } catch (const InputError&) {
    return false;
  }
  return true;
}

TEST(ReadScene, RefusesDamageByNameOrReadsOn) {
  int files = 0, read = 0, refused = 0;
  for (const auto& entry : std::filesystem::directory_iterator(VITRAIL_CORPUS)) {
    std::ifstream file(entry.path(), std::ios::binary);
    std::ostringstream whole;
    whole << file.rdbuf();
    const std::string text = whole.str();
    EXPECT_TRUE(is_scene(text)) << entry.path();
    ++files;
    for (std::size_t at = 0; at < text.size(); at += 23) {
      EXPECT_FALSE(is_scene(text.substr(0, at))) << entry.path() << " cut at " << at;
      for (const char byte : {'\0', '9', '-', '}', '"', '\x80'}) {
        std::string damaged = text;
        damaged[at] = byte;
        ++(is_scene(damaged) ? read : refused);
      }
    }
  }
  EXPECT_GT(files, 0);
  EXPECT_GT(read, 0);
  EXPECT_GT(refused, read);
}

}  // namespace
}  // namespace vitrail
