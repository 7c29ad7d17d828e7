/// What is written: the image's channels and header, the run record, progress lines. That the pixels read back right is
/// tested from Python with another EXR library.

#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/diagnostic.h"
#include "output/exr.h"
#include "output/progress.h"
#include "output/run_record.h"

namespace vitrail {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string temporary(const std::string& name) { return ::testing::TempDir() + "vitrail_" + name; }

/// The red of every pixel of a picture two pixels wide.
std::vector<float> reds_of(const std::string& path, std::size_t pixels) {
  std::vector<float> red(pixels);
  Imf::InputFile file(path.c_str());
  const Imath::Box2i window = file.header().dataWindow();
  Imf::FrameBuffer buffer;
  buffer.insert("R", Imf::Slice::Make(Imf::FLOAT, red.data(), window));
  file.setFrameBuffer(buffer);
  file.readPixels(window.min.y, window.max.y);
  return red;
}

TEST(Exr, HoldsPlannedLayersAndMetadata) {
  Film film(3, 2);
  film.add(0, 1, 1, Layer::diffusion, {1, 2, 3});
  film.add(1, 1, 1, Layer::reflection, {1, 1, 1});
  Plan plan;
  plan.reflection = plan.caustic = plan.indirect_light = plan.total_internal_reflection = false;
  const std::string path = temporary("layers.exr");
  write_exr(path, film, plan, {{"vitrail:scene_hash", "abc123"}});
  const std::string bytes = text_of(path);
  for (const char* name : {"half_a.R", "half_b.B", "diffusion.R", "refraction.R", "vitrail:scene_hash", "abc123"}) {
    EXPECT_NE(bytes.find(name), std::string::npos) << name;
  }
  // Not planned, but not black either: without it the layers would not sum to the radiance.
  EXPECT_NE(bytes.find("reflection.R"), std::string::npos);
  EXPECT_EQ(bytes.find("caustic.R"), std::string::npos);
  EXPECT_EQ(bytes.find("variance.R"), std::string::npos);  // a reader has it from the halves
  EXPECT_FALSE(std::filesystem::exists(path + ".unfinished"));
  std::filesystem::remove(path);
}

/// More rows than are written at once, each with a value of its own.
TEST(Exr, HoldsEveryRowForAnyNumberOfThreads) {
  constexpr int kRows = 600;
  Film film(2, kRows);
  for (int y = 0; y < kRows; ++y) {
    for (int x = 0; x < 2; ++x) film.add(y % 2, x, y, Layer::diffusion, {1.0 + y, 2, 0.5 * y});
  }
  const std::string one = temporary("one.exr"), many = temporary("many.exr");
  write_exr(one, film, Plan{}, {});
  write_exr(many, film, Plan{}, {}, 3);
  EXPECT_EQ(text_of(one), text_of(many));
  const std::vector<float> red = reds_of(many, 2 * kRows);
  for (int y = 0; y < kRows; ++y) EXPECT_EQ(red[2 * static_cast<std::size_t>(y)], film.radiance(0, y).r) << y;
  std::filesystem::remove(one);
  std::filesystem::remove(many);
}

TEST(Exr, ThatCannotBeWrittenIsAnOutputError) {
  EXPECT_THROW(write_exr("/nonexistent/folder/x.exr", Film(1, 1), Plan{}, {}), OutputError);
}

TEST(RunRecord, SaysWhatWasUsedAndDone) {
  Scene scene;
  scene.scene_hash = "abc123";
  scene.settings.photons = 42;
  Rendering rendering{.film = Film(1, 1), .warnings = {"a \"quoted\" warning"}, .interrupted = true};
  rendering.ledger.emitted = {1, 1, 1};
  rendering.ledger.stored = {0.5, 0.5, 0.5};
  const std::string record = run_record_json(scene, rendering, {"0.1", 2, 1.5, 0.75});
  for (const char* part : {"\"vitrail_run\": 1", "\"engine\": \"tracer\"", "\"scene_hash\": \"abc123\"",
                           "\"photons\": 42", "\"threads\": 2", "\"closure\": 0.5", "a \\\"quoted\\\" warning",
                           "\"interrupted\": true", "\"wall_s\": 0.75"}) {
    EXPECT_NE(record.find(part), std::string::npos) << part << " in " << record;
  }
}

TEST(Progress, WritesFirstAndLastLineOfAPhase) {
  const std::string path = temporary("progress.txt");
  std::FILE* stream = std::fopen(path.c_str(), "w");
  {
    ProgressLines progress(stream);
    progress.begin("camera", 3);
    progress.advance(1);
    progress.advance(2);
  }
  std::fclose(stream);
  const std::string lines = text_of(path);
  EXPECT_EQ(lines.substr(0, lines.find('\n')), R"({"phase": "camera", "done": 0, "total": 3})");
  EXPECT_NE(lines.find(R"("done": 3, "total": 3})"), std::string::npos);
  std::filesystem::remove(path);
}

TEST(Progress, HearsAnInterrupt) {
  ProgressLines progress(nullptr);
  EXPECT_FALSE(progress.interrupted());
  std::raise(SIGINT);
  EXPECT_TRUE(progress.interrupted());
}

}  // namespace
}  // namespace vitrail
