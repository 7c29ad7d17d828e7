#pragma once
/// The lowered scene as types: what the tracer reads, in metres, right-handed, all names resolved to indices.
/// Field names are those of the JSON; tracer/README.md documents each with its unit.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/vec3.h"
#include "scene/shape.h"
#include "scene/sky_image.h"
#include "scene/solver.h"

namespace vitrail {

struct Image {
  int width = 1, height = 1;
};

enum class CameraKind { perspective, orthographic };

/// Perspective: direction = forward + sx half_width right + sy half_height up. Orthographic: the same offsets on the
/// origin.
struct Camera {
  CameraKind kind = CameraKind::perspective;
  Vec3 position, forward, right, up;  // orthonormal, right = forward x up
  double half_width = 1, half_height = 1;
};

/// What is to be rendered of a scene: the scene's own picture, or a view, a picture more from the same photons.
struct Picture {
  std::string view;  // its name; empty for the scene's own picture
  Image image;
  Camera camera;
  int samples = 1;  // per pixel
};

/// One part of the spectrum with one refraction index per material; the weights of all bands sum to (1, 1, 1).
struct Band {
  std::string name;
  Rgb weight;
  std::optional<double> wavelength_nm;
};

// --- material --------------------------------------------------------------------------------------------------------

/// Two colours in squares of `size` metres along the surface coordinates of a flat shape.
struct Checker {
  std::array<Rgb, 2> colors;
  double size = 1;
};
using Texture = std::variant<Rgb, Checker>;

/// The colour of a texture at surface coordinates (s, t) in metres.
Rgb texture_at(const Texture& texture, double s, double t);
/// The largest value per channel anywhere on the surface.
Rgb texture_peak(const Texture& texture);

struct NoRoughness {};
/// The paper's equation 8; `value` is its lambda.
struct Equation8 {
  double value = 0;
};
/// Microfacets [W07 eq. 33].
struct Ggx {
  double alpha = 0;
};
using Roughness = std::variant<NoRoughness, Equation8, Ggx>;

struct Material {
  std::string name;
  Texture diffuse;
  Rgb reflection, transmission;
  std::vector<double> ior_by_band, ior_minus_one_by_band;
  double camera_ior = 1;
  bool fresnel = false;
  Rgb absorption_per_m;
  Texture emission;  // radiance, W / (sr m2)
  Roughness roughness;

  bool transmits() const { return !is_black(transmission); }
};

// --- objects ---------------------------------------------------------------------------------------------------------

struct Object {
  std::string name;
  std::uint32_t material = 0;
  int priority = 0;  // the highest priority among the solids containing a point rules there
  Shape shape;
};

// --- lights ----------------------------------------------------------------------------------------------------------

/// Light from infinity; `direction` is the way the light goes, `irradiance` that of a facing surface, W/m2.
struct DirectionalLight {
  Vec3 direction;
  Rgb irradiance;
  double angular_diameter_deg = 0;
};
struct PointLight {
  Vec3 position;
  Rgb intensity;  // W/sr
};
/// A point light limited to a cone of full angle cone_deg with a sharp edge.
struct SpotLight {
  Vec3 position, direction;
  Rgb intensity;
  double cone_deg = 90;
};
/// One-sided, on the side of the normal. Lambertian with `radiance`, or collimated with `irradiance` along the normal.
struct AreaLight {
  std::variant<RectangleShape, DiscShape> shape;
  bool collimated = false;
  Rgb radiance;    // W / (sr m2), 0 if collimated
  Rgb irradiance;  // W / m2, 0 unless collimated
};
/// Radiance from everywhere: constant, or a lat-long image.
struct EnvironmentLight {
  Rgb radiance;
  std::shared_ptr<const SkyImage> image;  // none for the constant one
};
using Emitter = std::variant<DirectionalLight, PointLight, SpotLight, AreaLight, EnvironmentLight>;

struct Light {
  std::string name;
  Emitter emitter;
};

// --- transport, paper, plan, settings
// ----------------------------------------------------------------------------------

enum class Indirect { none, photons, ambient };

struct Transport {
  Indirect indirect = Indirect::none;
  Rgb ambient;  // irradiance on every diffuse surface, W/m2, 0 unless indirect is ambient
  int max_reflections = 8, max_transmissions = 64;
};

/// The delta lobes of a mirror or a dielectric interface.
enum class Lobe {
  reflection,  // the mirror's share
  transmission,
  total_internal_reflection,  // what would have been transmitted
};

/// The faces on a path so far. What total reflection sends back never branches, so it counts with what is let through.
struct Depth {
  int reflections = 0, transmissions = 0;

  int faces() const { return reflections + transmissions; }
  Depth after(Lobe lobe) const {
    return lobe == Lobe::reflection ? Depth{reflections + 1, transmissions} : Depth{reflections, transmissions + 1};
  }
};

/// Literal readings of the paper, each switched on by name.
struct Paper {
  bool tir_drop = false;            // "tir": "drop" instead of "reflect"
  bool refraction_literal = false;  // "refraction": "literal" instead of "corrected"
  bool literal_sum = false;
  bool dispersion_span = false;  // "dispersion": "span" instead of "step"
  enum class DispersionReference { red, d_line, middle } dispersion_reference = DispersionReference::red;
  bool disperse_camera = true;
  int rough_samples = 1;
  bool count_transmission = false;     // crossings and mirrorings count together, up to max_reflections
  bool shadow_filter = false;          // "shadow": "filter" instead of "opaque"
  bool rough_photons_literal = false;  // "rough_photons": "literal" instead of "reciprocal"
};

/// Which phenomena are rendered.
struct Plan {
  bool diffusion = true, reflection = true, refraction = true, total_internal_reflection = true;
  bool coloured_transmission = true, absorption = true, caustic = true, roughness = true, dispersion = true;
  bool shadow = true, indirect_light = true;
};

struct Settings {
  int samples = 1;  // per pixel
  std::uint64_t photons = 0;
  double gather_radius_m = 0;
  std::uint64_t seed = 0;
  int rough_samples = 1, final_gather_rays = 0;
  double memory_limit_mb = 0;  // 0: no limit
  Solver solver = Solver::automatic;
  double branch_share = 1e-2;  // both ways on are followed from this share of a look on; below it, one by chance
  bool gather_disc = false;    // caustics as means over the gather disc, by any solver
};

struct Scene {
  std::string title, scene_hash;
  Image image;
  Camera camera;
  std::vector<Picture> views;
  std::vector<Band> bands;
  std::vector<Material> materials;
  std::vector<Object> objects;
  std::vector<Light> lights;
  Transport transport;
  Paper paper;
  Plan plan;
  Settings settings;

  /// What was subtracted from every position to bring the scene to the origin; add it to print a world position.
  Vec3 shift;

  /// The scene's own picture.
  Picture picture() const { return {"", image, camera, settings.samples}; }

  const Material& material_of(std::uint32_t object) const { return materials[objects[object].material]; }

  /// The solver that a rendering of this scene takes.
  Solver solver() const;
  /// The same if it turns out that no light goes as beams.
  Solver solver_without_beams() const;

  /// Whether light may go on after so many faces.
  bool within_depth(const Depth& depth) const {
    if (paper.count_transmission) return depth.faces() <= transport.max_reflections;
    return depth.reflections <= transport.max_reflections && depth.transmissions <= transport.max_transmissions;
  }
};

}  // namespace vitrail
