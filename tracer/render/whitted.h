#pragma once
/// The camera side: follow a camera path through mirrors and glass, with the paper's weights [S eqs. 1, 2, 5].

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
  bool both_halves = false;  // one sample per pixel: the same path asks both maps
};

/// What one camera ray is made of besides its direction.
struct CameraPath {
  Ray ray;
  MediumSet media;  // the solids the camera is in
  SampleDraw draw;  // random numbers of this sample: for lights ...
  Stream rough;     // ... for rough faces ...
  Stream gather;    // ... and for the final gather
  int half = 0;     // whose photons are asked for indirect light
  int light_samples = 1;
};

struct PathResult {
  HalfPixel radiance;                   // without what is to be gathered
  std::vector<GatherRequest> requests;  // pixel and half left to the caller
  std::uint64_t rays = 0, shadow_rays = 0;
};

/// A camera path between two surfaces.
struct CameraVertex {
  PathState path;          // the weight is the throughput
  bool scattered = false;  // has met a rough face
  Layer layer = Layer::diffusion;
};

/// Follow every branch of a camera path to its end. Clears and refills `result`, which the caller keeps for its memory.
class CameraTracer {
 public:
  explicit CameraTracer(const LitWorld& world);
  void trace(const CameraPath& path, PathResult& result);

 private:
  // In these the weight of the vertex is the throughput at the arrival.
  void arrive(CameraVertex& vertex, const Arrival& arrival, PathResult& result);
  void shade(const CameraVertex& vertex, const Arrival& arrival, PathResult& result);
  void scatter(const CameraVertex& vertex, const Arrival& arrival, const Interaction& event);
  void divide(const CameraVertex& vertex, const Arrival& arrival, const Interaction& event);
  void send(const CameraVertex& from, const Arrival& arrival, const Branch& branch);
  Rgb indirect(const CameraVertex& vertex, const ShadingPoint& at) const;
  bool is_binned(const CameraVertex& vertex) const;

  const LitWorld& world_;
  const Scene& scene_;
  bool in_bins_;  // photons on what the camera sees directly are counted in its pixels
  CameraPath path_;
  double ior_at_camera_ = 1;
  std::vector<CameraVertex> pending_;
};

}  // namespace vitrail
