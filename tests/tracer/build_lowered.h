#pragma once
/// A lowered scene with every part, as text, and the same with one part replaced.

#include <gtest/gtest.h>

#include <string>

#include "base/diagnostic.h"
#include "build_scene.h"
#include "scene/read.h"

namespace vitrail {

inline const std::string kScene = R"({
  "vitrail_lowered": 1, "title": "test", "scene_hash": "abc",
  "image": {"width": 4, "height": 3},
  "camera": {"kind": "perspective", "position": [0, 1, 5], "forward": [0, 0, -1], "right": [1, 0, 0], "up": [0, 1, 0],
             "half_width": 0.5, "half_height": 0.375},
  "bands": [{"name": "all", "weight": [1, 1, 1], "wavelength_nm": null}],
  "materials": [
    {"name": "clear", "diffuse": [0, 0, 0], "reflection": [0.1, 0.1, 0.1], "transmission": [0.9, 0.9, 0.9],
     "ior_by_band": [1.5], "ior_minus_one_by_band": [0.5], "camera_ior": 1.5, "fresnel": true,
     "absorption_per_m": [0, 0, 0], "emission": [0, 0, 0], "roughness": {"kind": "none"}},
    {"name": "squares", "diffuse": {"checker": {"colors": [[1, 0, 0], [0, 1, 0]], "size": 0.5}},
     "reflection": [0, 0, 0], "transmission": [0, 0, 0], "ior_by_band": [1], "ior_minus_one_by_band": [0],
     "camera_ior": 1, "fresnel": false, "absorption_per_m": [0, 0, 0], "emission": [0, 0, 0],
     "roughness": {"kind": "equation_8", "value": 0.25}}],
  "objects": [
    {"name": "ball", "material": 0, "priority": 3, "shape": {"kind": "sphere", "center": [0, 1, 0], "radius": 0.5}},
    {"name": "floor", "material": 1, "priority": 0, "shape": {"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}},
    {"name": "lens", "material": 0, "priority": 0, "shape": {"kind": "lens", "radius_front": 2, "radius_back": -3,
      "thickness": 0.3, "diameter": 1,
      "frame": {"origin": [4, 0, 0], "rotation": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "identity": true}}},
    {"name": "prism", "material": 0, "priority": 0, "shape": {"kind": "prism",
      "corners": [[-1, 0], [1, 0], [0, 1]], "height": 2,
      "frame": {"origin": [8, 0, 0], "rotation": [[0, -1, 0], [1, 0, 0], [0, 0, 1]], "identity": false}}},
    {"name": "ring", "material": 0, "priority": 0, "shape": {"kind": "torus", "center": [12, 0, 0],
      "normal": [0, 1, 0], "radius": 0.75, "radius_tube": 0.125}},
    {"name": "cup", "material": 0, "priority": 0, "shape": {"kind": "lathe",
      "profile": [[0, 0], [0.5, 0], [0.25, 1], [0, 1]],
      "frame": {"origin": [16, 0, 0], "rotation": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "identity": true}}}],
  "lights": [
    {"name": "sun", "kind": "directional", "direction": [0, -1, 0], "irradiance": [3, 3, 3], "angular_diameter_deg": 0},
    {"name": "lamp", "kind": "area", "radiance": [1, 2, 3],
     "shape": {"kind": "disc", "center": [0, 4, 0], "normal": [0, -1, 0], "radius": 0.5}},
    {"name": "sky", "kind": "environment", "radiance": [1, 1, 1]}],
  "transport": {"indirect": {"ambient": [0.1, 0.1, 0.1]}, "max_reflections": 8, "max_transmissions": 64},
  "paper": {"tir": "drop", "refraction": "corrected", "literal_sum": false, "dispersion": "span",
            "dispersion_reference": "middle", "disperse_camera": false, "rough_samples": 2, "count_transmission": true, "shadow": "filter",
            "rough_photons": "literal"},
  "plan": {"diffusion": true, "reflection": true, "refraction": true, "total_internal_reflection": true,
           "coloured_transmission": true, "absorption": false, "caustic": true, "roughness": false,
           "dispersion": false, "shadow": true, "indirect_light": false},
  "settings": {"samples": 4, "photons": 1000, "gather_radius_m": 0.01, "seed": 18446744073709551615,
               "rough_samples": 1, "final_gather_rays": 0, "memory_limit_mb": 4096, "solver": "auto"}
})";

inline std::string with(const std::string& old_part, const std::string& new_part) {
  std::string text = kScene;
  const std::size_t at = text.find(old_part);
  EXPECT_NE(at, std::string::npos) << old_part;
  return text.replace(at, old_part.size(), new_part);
}

inline std::string fault_of(const std::string& text) {
  try {
    parse_scene(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace vitrail
