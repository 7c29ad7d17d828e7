#pragma once
/// The camera side: follow a camera path through mirrors and glass, with the paper's weights [S eqs. 1, 2, 5].

#include <vector>

#include "material/branch_choice.h"
#include "material/roughen.h"
#include "render/camera_ledger.h"
#include "render/film.h"
#include "render/indirect_light.h"

namespace vitrail {

/// A surface that a camera path ended on, to be asked for the light that photons brought.
struct GatherRequest {
  GatherQuery query;
  Rgb weight;  // radiance per irradiance found: throughput times d / pi
  std::uint32_t pixel = 0;
  std::uint8_t half = 0;
  bool on_flat = false;      // the surface lies in the plane of its gather disc
  bool both_halves = false;  // one sample per pixel: the same path asks both maps
};

/// What one camera ray is made of besides its direction.
struct CameraPath {
  Ray ray;
  MediumSet media;  // the solids the camera is in
  SampleDraw draw;  // random numbers of this sample: for lights ...
  Stream rough;     // ... for rough faces ...
  Stream gather;    // ... for the final gather ...
  Stream branch;    // ... and for what chance leaves out
  int half = 0;     // whose photons are asked for indirect light
  int light_samples = 1;
};

struct PathResult {
  HalfPixel radiance;                   // without what is to be gathered
  std::vector<GatherRequest> requests;  // pixel and half left to the caller
  std::vector<CutBranch> cut;           // what the limits of the scene ended
  LightByBranch light;                  // the radiance, by what its branches carry
  std::uint64_t rays = 0, shadow_rays = 0;
  bool left_to_chance = false;  // some branch was: another path through the same place may see something else
};

/// A camera path between two surfaces.
struct CameraVertex {
  PathState path;          // the weight is the throughput
  bool scattered = false;  // has met a rough face
  Layer layer = Layer::diffusion;
  Stream branch;     // names this place of the tree
  double share = 1;  // of the look, by how light divides at the faces: absorption and tints leave it alone
  double whole = 1;  // that share, if nothing had been left to chance
  double part = 1;   // of one look, after it was divided into bands or rough rays
};

/// Follow the branches of a camera path to their ends: those that matter, and by chance some that do not
/// (`branch_choice.h`). Clears and refills `result`, which the caller keeps for its memory.
class CameraTracer {
 public:
  explicit CameraTracer(const LitWorld& world);
  void trace(const CameraPath& path, PathResult& result);

 private:
  // In these the weight of the vertex is the throughput at the arrival.
  void arrive(CameraVertex& vertex, const Arrival& arrival, PathResult& result);
  void shade(const CameraVertex& vertex, const Arrival& arrival, PathResult& result);
  void follow_band(const CameraVertex& vertex, const Arrival& arrival, std::uint32_t band, double factor,
                   PathResult& result);
  void follow_one_band(const CameraVertex& vertex, const Arrival& arrival, PathResult& result);
  void scatter(const CameraVertex& vertex, const Arrival& arrival, const Interaction& event, PathResult& result);
  void divide(const CameraVertex& vertex, const Arrival& arrival, const Interaction& event, PathResult& result);
  CarriedShares shares_of(const CameraVertex& vertex, const Interaction& event) const;
  double chance_at(const CameraVertex& vertex, PathResult& result, int draw) const;
  bool survives(CameraVertex& vertex, PathResult& result) const;
  void cut(const CameraVertex& vertex, const Interaction& event, Lobe lobe, double share, PathResult& result) const;
  void send(const CameraVertex& from, const Arrival& arrival, const Branch& branch, double share, double factor);
  Rgb indirect(const CameraVertex& vertex, const ShadingPoint& at) const;
  int light_samples(const CameraVertex& vertex) const;
  bool is_binned(const CameraVertex& vertex) const;

  const LitWorld& world_;
  const Scene& scene_;
  bool in_bins_;  // photons on what the camera sees directly are counted in its pixels
  CameraPath path_;
  double ior_at_camera_ = 1;
  double rays_ = 0;  // of this look so far; those of a part count in part
  std::vector<CameraVertex> pending_;
};

}  // namespace vitrail
