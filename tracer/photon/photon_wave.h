#pragma once
/// The quick way to follow photons: many at once, in scenes of few objects where a photon is in air or in one glass.
/// What is not that plain - faces that coincide, nested glass, rough glass - goes to the general way, photon by photon.

#include <vector>

#include "photon/few_objects.h"
#include "photon/photon_tree.h"

namespace vitrail {

class PhotonWave {
 public:
  static bool suits(const Scene& scene);

  PhotonWave(const PhotonPass& pass, std::uint32_t target, PhotonBlock& block);

  /// Take a photon as it leaves the light.
  void add(const Ray& ray, const MediumSet& media, Rgb flux);
  /// Follow all photons taken, and all their branches, to their ends.
  void finish();

 private:
  // A photon between two events, as far as the quick way goes.
  struct Traveller {
    Ray ray;
    Rgb flux;
    double least = 0;
    std::int64_t departed = RayLanes::kNone;
    std::uint32_t departed_face = 0;
    std::uint32_t medium = kAir;  // the one solid it is in
    std::int32_t band = 0;
    bool band_chosen = false;
    std::int16_t reflections = 0, transmissions = 0;

    bool has_bounced() const { return reflections + transmissions > 0; }
  };
  // What its next event is.
  struct Meeting {
    std::uint32_t object = 0, face = 0;
    bool entering = false;
    SurfacePoint at;
    std::uint32_t medium_after = kAir;
  };
  // What the shares of light at a face depend on, once for each object.
  struct Face {
    bool transmits = false, is_sheet = false, stores = false;
    bool disperses = false, absorbs = false;
    int priority = 0;
    const Material* material = nullptr;
  };

  void step();
  void arrive(const Traveller& photon, int lane);
  bool is_plain(const Traveller& photon, std::uint32_t object, bool entering) const;
  void meet(const Traveller& photon, const Meeting& meeting, Rgb flux);
  void send(const Traveller& from, const Meeting& meeting, Vec3 direction, Rgb flux, bool passes);
  void follow_generally(const Traveller& photon);

  const PhotonPass& pass_;
  const Scene& scene_;
  std::uint32_t target_;
  PhotonBlock& block_;
  FewObjects objects_;
  PhotonTree tree_;
  std::vector<Face> faces_;
  std::vector<Traveller> pending_, at_hand_;
  RayLanes lanes_;
};

}  // namespace vitrail
