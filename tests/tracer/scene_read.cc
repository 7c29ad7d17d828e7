/// Reading a lowered scene: what is right comes through unchanged, every fault is named by its path.

#include <gtest/gtest.h>

#include <fstream>

#include "base/diagnostic.h"
#include "build_lowered.h"
#include "scene/centre.h"
#include "scene/read.h"

namespace vitrail {
namespace {

TEST(ReadScene, BringsEveryPartThrough) {
  const Scene scene = parse_scene(kScene);
  EXPECT_EQ(scene.title, "test");
  EXPECT_EQ(scene.scene_hash, "abc");
  EXPECT_EQ(scene.image.width, 4);
  EXPECT_EQ(scene.camera.position, (Vec3{0, 1, 5}));
  EXPECT_EQ(scene.camera.half_height, 0.375);
  ASSERT_EQ(scene.materials.size(), 2u);
  EXPECT_TRUE(scene.materials[0].fresnel);
  EXPECT_EQ(scene.materials[0].ior_minus_one_by_band, std::vector<double>{0.5});
  EXPECT_EQ(std::get<Checker>(scene.materials[1].diffuse).size, 0.5);
  EXPECT_EQ(std::get<Equation8>(scene.materials[1].roughness).value, 0.25);
  ASSERT_EQ(scene.objects.size(), 6u);
  EXPECT_EQ(scene.objects[0].priority, 3);
  EXPECT_EQ(std::get<SphereShape>(scene.objects[0].shape).radius, 0.5);
  EXPECT_EQ(std::get<LensShape>(scene.objects[2].shape).radius_back, -3);
  EXPECT_TRUE(std::get<LensShape>(scene.objects[2].shape).frame.identity);
  EXPECT_EQ(std::get<PrismShape>(scene.objects[3].shape).frame.direction_to_world({1, 0, 0}), (Vec3{0, 1, 0}));
  EXPECT_EQ(std::get<TorusShape>(scene.objects[4].shape).radius_tube, 0.125);
  EXPECT_EQ(std::get<LatheShape>(scene.objects[5].shape).profile[2], (std::array<double, 2>{0.25, 1}));
  EXPECT_EQ(std::get<DirectionalLight>(scene.lights[0].emitter).irradiance, (Rgb{3, 3, 3}));
  EXPECT_EQ(std::get<DiscShape>(std::get<AreaLight>(scene.lights[1].emitter).shape).radius, 0.5);
  EXPECT_EQ(scene.transport.indirect, Indirect::ambient);
  EXPECT_TRUE(scene.paper.tir_drop);
  EXPECT_TRUE(scene.paper.count_transmission);
  EXPECT_TRUE(scene.paper.rough_photons_literal);
  EXPECT_TRUE(scene.paper.shadow_filter);
  EXPECT_TRUE(scene.paper.dispersion_span);
  EXPECT_EQ(scene.paper.dispersion_reference, Paper::DispersionReference::middle);
  EXPECT_FALSE(scene.plan.absorption);
  EXPECT_TRUE(scene.plan.caustic);
  EXPECT_EQ(scene.settings.seed, 18446744073709551615ull);
  EXPECT_EQ(scene.settings.gather_radius_m, 0.01);
  EXPECT_FALSE(scene.settings.gather_disc);
  EXPECT_TRUE(parse_scene(with("\"seed\"", "\"gather_disc\": true, \"seed\"")).settings.gather_disc);
}

struct Fault {
  const char *old_part, *new_part, *message;
};

class WrongScene : public testing::TestWithParam<Fault> {};

TEST_P(WrongScene, IsRefusedByPath) {
  const Fault& fault = GetParam();
  const std::string message = fault_of(with(fault.old_part, fault.new_part));
  EXPECT_EQ(message.substr(0, message.find('\n')), fault.message);
}

const Fault kFaults[] = {
    {"\"vitrail_lowered\": 1", "\"vitrail_lowered\": 2",
     "scene.vitrail_lowered: is 2; write a whole number from 1 to 1"},
    {"\"width\": 4", "\"width\": 0", "scene.image.width: is 0; write a whole number from 1 to 16384"},
    {"\"width\": 4", "\"width\": 4.5", "scene.image.width: is 4.5; write a whole number from 1 to 16384"},
    {"\"width\": 4, ", "", "scene.image.width: is missing; add it"},
    {"\"width\": 4", "\"width\": 4, \"depth\": 1", "scene.image.depth: is unknown; the keys here are width, height"},
    {"\"right\": [1, 0, 0]", "\"right\": [-1, 0, 0]",
     "scene.camera: has axes that are not right = forward x up; write an orthonormal, right-handed triple"},
    {"\"forward\": [0, 0, -1]", "\"forward\": [0, 0, -2]",
     "scene.camera.forward: has length 2.0; divide it by its length"},
    {"\"half_width\": 0.5", "\"half_width\": 0", "scene.camera.half_width: is 0; write a finite number above 0.0"},
    {"\"radius\": 0.5}},", "\"radius\": -0.5}},",
     "scene.objects[0].shape.radius: is -0.5; write a finite number above 0.0"},
    {"\"radius\": 0.5}},", "\"radius\": null}},",
     "scene.objects[0].shape.radius: is null; write a finite number above 0.0"},
    {"\"center\": [0, 1, 0]", "\"center\": [0, 1]",
     "scene.objects[0].shape.center: is [0,1]; write a list of 3 values"},
    {"\"material\": 0", "\"material\": 7", "scene.objects[0].material: is 7; write a whole number from 0 to 1"},
    {"\"kind\": \"sphere\"", "\"kind\": \"ball\"",
     "scene.objects[0].shape.kind: is \"ball\"; write one of sphere, plane, rectangle, disc, box, cylinder, cone, "
     "prism, lens, torus, lathe, mesh"},
    {"\"transmission\": [0.9, 0.9, 0.9]", "\"transmission\": [0.9, 0.95, 0.9]",
     "scene.materials[0]: makes light: diffuse + reflection + transmission is above 1; lower one of them"},
    {"\"ior_by_band\": [1.5]", "\"ior_by_band\": [1.5, 1.6]",
     "scene.materials[0].ior_by_band: is [1.5,1.6]; write a list of 1 values"},
    {"\"ior_minus_one_by_band\": [0.5]", "\"ior_minus_one_by_band\": [0.6]",
     "scene.materials[0].ior_minus_one_by_band: differs from ior_by_band - 1; write the same index in both"},
    {"\"weight\": [1, 1, 1]", "\"weight\": [1, 0.5, 1]",
     "scene.bands: have weights that do not add up to 1 in every channel; scale them"},
    {"\"radius_front\": 2", "\"radius_front\": 0.4",
     "scene.objects[2].shape: has a face whose radius is below half the diameter; enlarge the radius or reduce the "
     "diameter"},
    {"\"thickness\": 0.3", "\"thickness\": 0.001",
     "scene.objects[2].shape: has faces that cross inside the rim; enlarge the thickness or reduce the diameter"},
    {"\"radius_tube\": 0.125", "\"radius_tube\": 0.75",
     "scene.objects[4].shape: has a tube that fills its ring; write a radius_tube below the radius"},
    {"[0.25, 1]", "[-0.25, 1]", "scene.objects[5].shape.profile[2][0]: is -0.25; write a finite number not below 0.0"},
    {"[0.25, 1]", "[0.5, 0]",
     "scene.objects[5].shape.profile: has the same corner twice in a row; list at least three corners around an area, "
     "in order"},
    {"[0.5, 0], [0.25, 1], ", "",
     "scene.objects[5].shape.profile: is no polygon with an area; list at least three corners around an area, in "
     "order"},
    {"[[0, -1, 0], [1, 0, 0], [0, 0, 1]]", "[[0, 1, 0], [1, 0, 0], [0, 0, 1]]",
     "scene.objects[3].shape.frame.rotation: is not a rotation; write three rows of unit length, perpendicular, the "
     "third the cross product"},
    {"[[-1, 0], [1, 0], [0, 1]]", "[[1, 0], [-1, 0], [0, 1]]",
     "scene.objects[3].shape.corners: is no polygon with a positive area; list at least three corners "
     "counter-clockwise"},
    {"{\"kind\": \"plane\", \"point\": [0, 0, 0], \"normal\": [0, 1, 0]}",
     "{\"kind\": \"sphere\", \"center\": [0, 0, 0], \"radius\": 1}",
     "scene.objects[1].shape: has a checker pattern but no surface coordinates; use a plane, rectangle or disc"},
    {"{\"kind\": \"sphere\", \"center\": [0, 1, 0], \"radius\": 0.5}",
     "{\"kind\": \"rectangle\", \"center\": [0, 1, 0], \"u\": [1, 0, 0], \"v\": [0, 1, 0]}",
     "scene.objects[0].shape: transmits light but encloses nothing; use a box or another closed shape"},
    {"\"indirect\": {\"ambient\": [0.1, 0.1, 0.1]}", "\"indirect\": \"some\"",
     "scene.transport.indirect: is \"some\"; write one of none, photons"},
    {"\"samples\": 4", "\"samples\": -1", "scene.settings.samples: is -1; write a whole number from 1 to 1048576"},
    {"\"seed\": 18446744073709551615", "\"seed\": -1",
     "scene.settings.seed: is -1; write a whole number from 0 to 18446744073709551615"},
    {"\"solver\": \"auto\"", "\"solver\": \"radiosity\"",
     "scene.settings.solver: is \"radiosity\"; write one of auto, photon_map, light_bins, beams"},
    {"\"shadow\": true", "\"shadow\": 1", "scene.plan.shadow: is 1; write true or false"},
    {"\"title\": \"test\"", "\"title\": 5", "scene.title: is 5; write a text in quotes"},
};

INSTANTIATE_TEST_SUITE_P(Faults, WrongScene, testing::ValuesIn(kFaults));

TEST(ReadScene, CollectsAllFaults) {
  std::string text = with("\"width\": 4", "\"width\": 0");
  text.replace(text.find("\"radius\": 0.5}},"), 16, "\"radius\": -1}},");
  const std::string message = fault_of(text);
  EXPECT_NE(message.find("scene.image.width"), std::string::npos);
  EXPECT_NE(message.find("scene.objects[0].shape.radius"), std::string::npos);
}

TEST(ReadScene, RefusesWhatIsNoScene) {
  for (const char* text : {"", "nonsense", "[1, 2]", "{}", "null", "{\"vitrail_lowered\": NaN}", "\x00\xff\xfe"})
    EXPECT_NE(fault_of(text), "accepted") << text;
  EXPECT_NE(fault_of(with("\"radius\": 0.5", "\"radius\": 1e999")), "accepted");
  EXPECT_NE(fault_of(std::string(100000, '[')), "accepted");
  EXPECT_THROW(read_scene("/does/not/exist.json"), InputError);
}

TEST(Texture, AlternatesInSquaresAlsoBelowZeroAndFarAway) {
  const Texture squares = Checker{{Rgb{1, 0, 0}, Rgb{0, 1, 0}}, 0.5};
  EXPECT_EQ(texture_at(squares, 0.1, 0.1), (Rgb{1, 0, 0}));
  EXPECT_EQ(texture_at(squares, 0.6, 0.1), (Rgb{0, 1, 0}));
  EXPECT_EQ(texture_at(squares, -0.1, 0.1), (Rgb{0, 1, 0}));
  EXPECT_EQ(texture_at(squares, -0.1, -0.1), (Rgb{1, 0, 0}));
  EXPECT_EQ(texture_at(squares, 1e18 + 0.1, 0.1), (Rgb{1, 0, 0}));
  EXPECT_EQ(texture_peak(squares), (Rgb{1, 1, 0}));
}

// --- centring
// ----------------------------------------------------------------------------------------------------------

Scene ball_at(Vec3 place, double k = 1) {
  SceneBuilder builder;
  builder.add("ball", SphereShape{place * k, 0.5 * k}, builder.add(glass(1.5)));
  builder.add("floor", PlaneShape{(place - Vec3{0, 1, 0}) * k, {0, 1, 0}}, 0);
  builder.scene.camera.position = (place + Vec3{0, 2, 5}) * k;
  builder.scene.views = {builder.scene.picture()};
  builder.scene.lights.push_back({"lamp", PointLight{(place + Vec3{0, 4, 0}) * k, {1, 1, 1}}});
  return builder.scene;
}

TEST(CentreScene, LeavesScenesNearTheOriginAlone) {
  Scene scene = ball_at({0.3, 1.1, -0.7});
  centre_scene(scene);
  EXPECT_EQ(scene.shift, (Vec3{0, 0, 0}));
  EXPECT_EQ(std::get<SphereShape>(scene.objects[0].shape).center, (Vec3{0.3, 1.1, -0.7}));
}

TEST(CentreScene, BringsFarScenesBackWithoutRounding) {
  Scene scene = ball_at({1e6 + 0.25, 0.5, -1e9});
  centre_scene(scene);
  const Vec3 center = std::get<SphereShape>(scene.objects[0].shape).center;
  EXPECT_EQ(center + scene.shift, (Vec3{1e6 + 0.25, 0.5, -1e9}));
  EXPECT_EQ(scene.camera.position - center, (Vec3{0, 2, 5}));
  EXPECT_EQ(scene.views[0].camera.position, scene.camera.position);
  EXPECT_EQ(std::get<PointLight>(scene.lights[0].emitter).position - center, (Vec3{0, 4, 0}));
  EXPECT_EQ(std::get<PlaneShape>(scene.objects[1].shape).point - center, (Vec3{0, -1, 0}));
  EXPECT_LT(largest_coordinate(center), 16);
}

TEST(CentreScene, IsNotDrawnIntoThePlanet) {
  Scene scene = ball_at({0, 1, 0});
  scene.objects.push_back({"planet", 0, 0, SphereShape{{0, -1e9, 0}, 1e9}});
  centre_scene(scene);
  EXPECT_EQ(scene.shift, (Vec3{0, 0, 0}));

  // Nor does the planet keep a small scene on its far side where no digits are left.
  Scene far = ball_at({0, -2e9, 0});
  far.objects.push_back({"planet", 0, 0, SphereShape{{0, -1e9, 0}, 1e9}});
  centre_scene(far);
  EXPECT_LT(largest_coordinate(std::get<SphereShape>(far.objects[0].shape).center), 16);
}

TEST(CentreScene, ScalesByPowersOfTwo) {
  Scene scene = ball_at({1e6, 0.5, -1e9}), large = ball_at({1e6, 0.5, -1e9}, 0x1p20);
  centre_scene(scene);
  centre_scene(large);
  EXPECT_EQ(scene.shift * 0x1p20, large.shift);
  EXPECT_NE(scene.shift, (Vec3{0, 0, 0}));
}

}  // namespace
}  // namespace vitrail
