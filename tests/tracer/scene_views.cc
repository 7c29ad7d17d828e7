/// Reading the views of a lowered scene: pictures more, each with a name that a file can have.

#include <gtest/gtest.h>

#include "base/diagnostic.h"
#include "scene/read.h"

namespace vitrail {
namespace {

const std::string kCamera =
    R"({"kind": "perspective", "position": [0, 1, 5], "forward": [0, 0, -1], "right": [1, 0, 0], "up": [0, 1, 0],
        "half_width": 0.5, "half_height": 0.375})";
const std::string kSmall = R"({"width": 7, "height": 5})";

/// A scene of nothing but views with these names.
std::string with_views(const std::vector<std::string>& names, const std::string& image = kSmall,
                       const std::string& more = R"("samples": 9)") {
  std::string views;
  for (const std::string& name : names) {
    views += (views.empty() ? "" : ", ") + (R"({"name": ")" + name + R"(", "image": )" + image) + R"(, "camera": )" +
             kCamera + ", " + more + "}";
  }
  return R"({
  "vitrail_lowered": 1, "title": "views", "scene_hash": "abc", "image": {"width": 4, "height": 3}, "camera": )" +
         kCamera + R"(, "views": [)" + views + R"(],
  "bands": [{"name": "all", "weight": [1, 1, 1], "wavelength_nm": null}],
  "materials": [], "objects": [], "lights": [],
  "transport": {"indirect": "none", "max_reflections": 8, "max_transmissions": 64},
  "paper": {"tir": "reflect", "refraction": "corrected", "literal_sum": false, "dispersion": "step",
            "dispersion_reference": "red", "disperse_camera": true, "rough_samples": 1},
  "plan": {"diffusion": true, "reflection": true, "refraction": true, "total_internal_reflection": true,
           "coloured_transmission": true, "absorption": true, "caustic": true, "roughness": true,
           "dispersion": true, "shadow": true, "indirect_light": true},
  "settings": {"samples": 4, "photons": 0, "gather_radius_m": 0, "seed": 1, "rough_samples": 1,
               "final_gather_rays": 0, "memory_limit_mb": null, "solver": "auto"}})";
}

std::string fault_of(const std::string& text) {
  try {
    parse_scene(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ReadViews, BringsViewsThrough) {
  const Scene scene = parse_scene(with_views({"spot", "a b-1.c"}));
  ASSERT_EQ(scene.views.size(), 2u);
  EXPECT_EQ(scene.views[1].view, "a b-1.c");
  EXPECT_EQ(scene.views[1].image.width, 7);
  EXPECT_EQ(scene.views[1].image.height, 5);
  EXPECT_EQ(scene.views[1].samples, 9);
  EXPECT_EQ(scene.views[1].camera.position, scene.camera.position);
  EXPECT_EQ(scene.picture().view, "");
  EXPECT_EQ(scene.picture().samples, 4);
}

TEST(ReadViews, RefusesViewsThatCannotBeWritten) {
  for (const std::string name : {"", ".", "..", "../up", "a/b", "a\\\\b", "a\\u0000b", "a\\n", ".hidden"})
    EXPECT_NE(fault_of(with_views({name})).find("scene.views[0].name: cannot name a file"), std::string::npos) << name;
  EXPECT_NE(fault_of(with_views({std::string(201, 'x')})), "accepted");
  EXPECT_EQ(fault_of(with_views({"a", "b", "a"})),
            "scene.views[2].name: is also the name of another view; give every view a name of its own");
  EXPECT_EQ(fault_of(with_views({"a"}, "{\"width\": 7, \"height\": 0}", "\"samples\": 9")),
            "scene.views[0].image.height: is 0; write a whole number from 1 to 16384");
  EXPECT_EQ(fault_of(with_views({"a"}, kSmall, "\"samples\": 0")),
            "scene.views[0].samples: is 0; write a whole number from 1 to 1048576");
  EXPECT_EQ(fault_of(with_views({"a"}, kSmall, "\"samples\": 1, \"bands\": []")),
            "scene.views[0].bands: is unknown; the keys here are name, image, camera, samples");
}

}  // namespace
}  // namespace vitrail
