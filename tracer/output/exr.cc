#include "output/exr.h"

#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <cstdio>
#include <functional>
#include <vector>

#include "base/diagnostic.h"
#include "base/ray.h"

namespace vitrail {
namespace {

using PixelValue = std::function<Rgb(int x, int y)>;

// Three float planes under one name.
struct Planes {
  std::string prefix;  // "" or "name."
  std::vector<float> values[3];
};

Planes planes_of(const Film& film, const std::string& prefix, const PixelValue& value) {
  Planes planes{prefix, {}};
  for (auto& plane : planes.values) plane.reserve(static_cast<std::size_t>(film.width()) * film.height());
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      const Rgb v = value(x, y);
      for (int c = 0; c < 3; ++c) planes.values[c].push_back(static_cast<float>(v[c]));
    }
  }
  return planes;
}

bool is_black(const Planes& planes) {
  for (const auto& plane : planes.values) {
    for (float v : plane) {
      if (v != 0) return false;
    }
  }
  return true;
}

std::vector<Planes> all_planes(const Film& film, const Plan& plan) {
  const auto half = [&](int h) { return [&film, h](int x, int y) { return film.at(h, x, y).radiance(); }; };
  std::vector<Planes> all;
  all.push_back(planes_of(film, "", [&](int x, int y) { return film.radiance(x, y); }));
  all.push_back(planes_of(film, "half_a.", half(0)));
  all.push_back(planes_of(film, "half_b.", half(1)));
  all.push_back(planes_of(film, "variance.", [&](int x, int y) {
    const Rgb difference = film.at(0, x, y).radiance() - film.at(1, x, y).radiance();
    return difference * difference * 0.25;
  }));
  for (int l = 0; l < kLayerCount; ++l) {
    const auto layer = static_cast<Layer>(l);
    Planes planes =
        planes_of(film, std::string(name_of(layer)) + ".", [&](int x, int y) { return film.layer(layer, x, y); });
    if (is_planned(layer, plan) || !is_black(planes)) all.push_back(std::move(planes));
  }
  return all;
}

void write_planes(const std::string& path, const Film& film, std::vector<Planes>& all,
                  const std::map<std::string, std::string>& metadata) {
  Imf::Header header(film.width(), film.height());
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const auto& [key, value] : metadata) header.insert(key, Imf::StringAttribute(value));
  Imf::FrameBuffer buffer;
  for (Planes& planes : all) {
    for (int c = 0; c < 3; ++c) {
      const std::string name = planes.prefix + "RGB"[c];
      header.channels().insert(name, Imf::Channel(Imf::FLOAT));
      buffer.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(planes.values[c].data()), sizeof(float),
                                     sizeof(float) * static_cast<std::size_t>(film.width())));
    }
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(buffer);
  file.writePixels(film.height());
}

}  // namespace

void write_exr(const std::string& path, const Film& film, const Plan& plan,
               const std::map<std::string, std::string>& metadata) {
  std::vector<Planes> all = all_planes(film, plan);
  const std::string unfinished = path + ".unfinished";
  try {
    write_planes(unfinished, film, all, metadata);
  } catch (const std::exception& error) {
    std::remove(unfinished.c_str());
    throw OutputError({path, std::string("cannot be written: ") + error.what(), "choose a folder that can be written"});
  }
  if (std::rename(unfinished.c_str(), path.c_str()) != 0) {
    std::remove(unfinished.c_str());
    throw OutputError({path, "cannot be replaced", "choose a file that can be written"});
  }
}

std::shared_ptr<const SkyImage> read_sky(const std::string& path) {
  const auto refuse = [&](const std::string& what) {
    return InputError({{path, what, "give a lat-long EXR image with channels R, G and B"}});
  };
  std::vector<float> planes[3];
  int width = 0, height = 0;
  try {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i window = file.header().dataWindow();
    width = window.max.x - window.min.x + 1;
    height = window.max.y - window.min.y + 1;
    Imf::FrameBuffer buffer;
    for (int c = 0; c < 3; ++c) {
      const std::string name(1, "RGB"[c]);
      if (file.header().channels().findChannel(name) == nullptr) throw refuse("has no channel " + name);
      planes[c].resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
      buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, planes[c].data(), window));
    }
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw refuse(std::string("cannot be read: ") + error.what());
  }
  std::vector<Rgb> radiance;
  radiance.reserve(planes[0].size());
  for (std::size_t i = 0; i < planes[0].size(); ++i) {
    const Rgb v{planes[0][i], planes[1][i], planes[2][i]};
    if (!(v.r >= 0 && v.g >= 0 && v.b >= 0 && largest_channel(v) < kInfinity)) {
      throw refuse("has a pixel that is negative or not finite");
    }
    radiance.push_back(v);
  }
  return std::make_shared<const SkyImage>(width, height, std::move(radiance));
}

}  // namespace vitrail
