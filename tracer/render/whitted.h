#pragma once
/// The camera side: follow a look through mirrors and glass, with the paper's weights [S eqs. 1, 2, 5].

#include <vector>

#include "material/roughen.h"
#include "render/film.h"
#include "render/indirect_light.h"

namespace vitrail {

/// A branch below this share of the camera ray is not followed: in a glass ball or slab all that is cut stays below
/// 1e-5 of the light behind it.
inline constexpr double kLeastCameraShare = 1e-6;

/// A surface that a camera path ended on, to be asked for the light that photons brought.
struct GatherRequest {
  GatherQuery query;
  Rgb weight;  // radiance per irradiance found: throughput times d / pi
  std::uint32_t pixel = 0;
  std::uint8_t half = 0;
  bool both_halves = false;  // one sample per pixel: the same look asks both maps
};

/// What one camera ray is made of besides its direction.
struct CameraPath {
  Ray ray;
  MediumSet media;  // the solids the camera is in
  LightDraw draw;   // random numbers of this sample: for lights ...
  Stream rough;     // ... for rough faces ...
  Stream around;    // ... and for looks around
  int half = 0;     // whose photons are asked for indirect light
  int light_samples = 1;
};

struct PathResult {
  HalfPixel radiance;                   // without what is to be gathered
  std::vector<GatherRequest> requests;  // pixel and half left to the caller
  std::uint64_t rays = 0, shadow_rays = 0;
};

/// Follow every branch of a camera path to its end. Clears and refills `result`, which the caller keeps for its memory.
class CameraTracer {
 public:
  CameraTracer(const Scene& scene, const Intersector& intersector, const LightMaps& maps);
  void trace(const CameraPath& path, PathResult& result);

 private:
  /// A ray on its way, with what it will count for.
  struct Look {
    Ray ray;
    Departures departures;
    MediumSet media;
    Rgb throughput;
    std::uint32_t band = 0;
    bool band_chosen = false;
    Depth depth{};
    bool scattered = false;  // has met a rough face
    Layer layer = Layer::diffusion;
  };
  Rgb indirect(const Look& look, const Arrival& arrival, const Interaction& event) const;
  bool is_binned(const Look& look) const;
  void go_on(const Look& look, const Arrival& arrival, const Interaction& event, Rgb throughput);
  void meet(const Look& look, const Arrival& arrival, const Interaction& event, Rgb throughput);
  void scatter(const Look& look, const Arrival& arrival, const Interaction& event, Rgb throughput, PathResult& result);
  void send(const Look& look, const Arrival& arrival, const Branch& branch, Rgb throughput);

  const Scene& scene_;
  const Intersector& intersector_;
  const LightMaps& maps_;
  bool in_bins_;                 // photons on what the camera sees directly are counted in its pixels
  std::vector<bool> disperses_;  // by material: the index differs between bands
  CameraPath path_;
  double ior_at_camera_ = 1;
  std::vector<Look> pending_;
};

}  // namespace vitrail
