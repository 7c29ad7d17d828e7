#pragma once
/// The fast strategy: many photons at once, in small scenes where a photon is in air or in one glass. Photons in any
/// other situation (coincident faces, nested glass) go to PhotonTree one by one.
///
/// For readers of pbrt: this is wavefront path tracing with exact splitting, and Russian roulette for weak branches.
/// `now_` is the ray queue. One `step` intersects up to 256 of its rays with every object, then sorts them into groups
/// by what they met; `arrive` handles one group: it finds points and normals, refracts all its rays, divides the flux
/// by Fresnel, stores what is diffuse, and appends reflected and refracted rays to `next_`. The two queues are swapped
/// until no ray is left. All quantities are columns of doubles, so each of these stages is a loop that becomes vector
/// instructions.

#include <memory>
#include <vector>

#include "photon/photon_tree.h"
#include "photon/wave/dielectric_lanes.h"
#include "photon/wave/rough_lanes.h"
#include "photon/wave/small_scene_intersector.h"

namespace vitrail {

class PhotonWave {
 public:
  static bool suits(const Scene& scene);

  PhotonWave(const PhotonPass& pass, std::uint32_t target, Stream stream, const BandCombs& combs,
             const PhotonBranches& branches, PhotonBlock& block);

  /// Take a photon as it leaves the light, in air or inside `media`; `index` of the photon in its chart.
  void add(const Ray& ray, Rgb flux, std::uint32_t index);
  void add(const Ray& ray, const MediumSet& media, Rgb flux, std::uint32_t index);
  std::size_t size() const { return now_.size(); }
  /// Follow all photons taken, and all their branches, to their ends.
  void finish();

 private:
  // What happens at the faces of an object.
  struct Face {
    const Material* material = nullptr;
    Rgb pool;  // r + t
    bool transmits = false, mirrors = false, is_sheet = false, stores = false, disperses = false, absorbs = false,
         rough = false;
    int priority = 0;
  };
  // Photons at the same side of the same object, side by side: all of them have a band, or none.
  struct Group {
    HitId met;
    std::size_t count = 0;
    std::array<std::uint32_t, RayChunk::kCapacity> lane;  // in `now_`
    std::array<std::int32_t, RayChunk::kCapacity> face;
    std::array<std::int16_t, RayChunk::kCapacity> band;                       // or kNoBand
    alignas(64) std::array<std::array<double, RayChunk::kCapacity>, 3> flux;  // what arrives
    SurfaceLanes at;                                                          // with the normal against the photon

    Rgb flux_of(std::size_t i) const { return {flux[0][i], flux[1][i], flux[2][i]}; }
    Vec3 point_of(std::size_t i) const { return {at.point[0][i], at.point[1][i], at.point[2][i]}; }
    Vec3 normal_of(std::size_t i) const { return {at.normal[0][i], at.normal[1][i], at.normal[2][i]}; }
  };

  // What a group's face mirrors, or what it lets through. Behind a rough face either may end on either side.
  struct Part {
    std::array<DielectricLanes::Column, 3>* direction = nullptr;
    std::array<DielectricLanes::Column, 3> flux;
    std::array<Lobe, RayChunk::kCapacity> lobe;
    DielectricLanes::Column share;  // of the photon that left the light
    bool goes_on = false;

    Rgb flux_of(std::size_t i) const { return {flux[0][i], flux[1][i], flux[2][i]}; }
    void set_flux(std::size_t i, Rgb now) {
      for (int c = 0; c < 3; ++c) flux[c][i] = now[c];
    }
  };

  // Those of a part that go on.
  struct Survivors {
    std::array<std::uint16_t, RayChunk::kCapacity> lane;  // in the group
    std::size_t count = 0;
  };

  const Face& face_of(const Group& group) const { return faces_[static_cast<std::size_t>(group.met.object)]; }
  void step(std::size_t first, std::size_t count);
  bool is_plain(std::int32_t medium, HitId met) const;
  void escape(std::size_t lane);
  void follow_generally(std::size_t lane);
  void arrive(HitId met, const std::vector<std::uint16_t>& rays, std::size_t first);
  void stop(const Group& group);
  void divide_by_band(Group& group);
  void divide(const Group& group);
  void divide_at_plane(const Group& group);
  void find_lobes(const Group& group);
  void draw(const Group& group);
  void deflect_part(const Group& group, Part& part, double side);
  void divide_at_facets(const Group& group);
  void share_at_facets(const Group& group);
  void let_leave(const Group& group, Part& part, bool bent);
  bool is_total(const Group& group, std::size_t i) const;
  bool follow_facets(const Group& group, Part& part, bool bent, std::size_t i);
  void store(const Group& group, std::size_t i);
  void end(const Group& group);
  void choose_ways(const Group& group);
  void choose_survivors(const Group& group, const Part& part, Survivors& survivors);
  void send(const Group& group, const Part& part);

  const PhotonPass& pass_;
  const Scene& scene_;
  std::int32_t target_;
  PhotonBlock& block_;
  SmallSceneIntersector objects_;
  PhotonStore store_;
  PhotonTree tree_;
  std::vector<Face> faces_;
  bool anything_absorbs_ = false;
  PathStates now_, next_;
  // Rays of the chunk: by HitId::lane, each first those without a band and then those with one.
  std::vector<std::vector<std::uint16_t>> met_;
  std::unique_ptr<RayChunk> rays_;
  std::unique_ptr<Group> group_;
  std::unique_ptr<DielectricLanes> lanes_;
  Part mirrored_, refracted_;
  Stream lots_;  // for rough faces
  BandCombs combs_;
  PhotonBranches branches_;
  std::unique_ptr<RoughSamples> samples_;
  std::unique_ptr<FacetLanes> facets_;
  bool any_total_ = false;                                         // among the facets that were met last
  std::array<Stream, RayChunk::kCapacity> behind_, behind_facet_;  // more random numbers for each ray
};

}  // namespace vitrail
