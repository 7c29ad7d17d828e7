/// Where photons start: before every infinite plane that light from infinity crosses, and on the bright side of a wall.

#include <gtest/gtest.h>

#include "build_scene.h"
#include "photon/caustic_pass.h"

namespace vitrail {
namespace {

constexpr double kRadius = 1;

/// A clear ball over a floor, under light from the kinds that come from infinity.
SceneBuilder ball_on_floor(const Emitter& light) {
  SceneBuilder builder;
  builder.add("floor", PlaneShape{{0, 0, 0}, {0, 1, 0}}, builder.add(diffuse(0.8)));
  builder.add("ball", SphereShape{{0, 2, 0}, kRadius}, builder.add(glass(1.5)));
  builder.scene.lights.push_back({"light", light});
  builder.scene.settings.photons = 20000;
  builder.scene.settings.gather_radius_m = 0.05;
  return builder;
}

PhotonMaps maps_of(const Scene& scene) {
  SilentMonitor monitor;
  const Intersector intersector(scene);
  return make_caustic_maps({scene, intersector}, {1, monitor});
}

const DirectionalLight kSlantedSun{normalise({0.3, -1, 0.2}), {2, 2, 2}, 0};
const DirectionalLight kWideSun{normalise({0.3, -1, 0.2}), {2, 2, 2}, 30};
const EnvironmentLight kSky{{1, 1, 1}, nullptr};

/// What stops a shadow ray stops a photon: a ceiling without an end lets no light from infinity into the room.
TEST(LightFromInfinity, IsStoppedByAnInfiniteCeiling) {
  for (const Emitter& light : {Emitter{kSlantedSun}, Emitter{kWideSun}, Emitter{kSky}}) {
    SceneBuilder open = ball_on_floor(light);
    EXPECT_GT(maps_of(open.scene).statistics.ledger.stored.r, 0);
    // Just over the ball, and so far away that everything else seems a point: nothing depends on the distance.
    for (double height : {3.01, 1e6}) {
      SceneBuilder builder = ball_on_floor(light);
      builder.add("ceiling", PlaneShape{{0, height, 0}, {0, -1, 0}}, 0);
      const PhotonMaps maps = maps_of(builder.scene);
      EXPECT_EQ(maps.statistics.ledger.emitted, (Rgb{})) << height;
      EXPECT_EQ(maps.statistics.stored, 0u) << height;
      // A shadow ray from the floor, outside the shadow of the ball, ends there too.
      const Intersector intersector(builder.scene);
      EXPECT_TRUE(intersector.occluded({{5, 0.1, 0}, {0, 1, 0}}, {}, kInfinity));
    }
  }
}

/// A plane of glass over the ball is met first, and once: the ball's own photons would count the light twice.
TEST(LightFromInfinity, MeetsAnInfinitePaneBeforeWhatIsUnderIt) {
  SceneBuilder builder = ball_on_floor(DirectionalLight{{0, -1, 0}, {2, 2, 2}, 0});
  builder.add("sea", PlaneShape{{0, 5, 0}, {0, 1, 0}}, builder.add(glass(1)));
  const Ledger ledger = maps_of(builder.scene).statistics.ledger;
  // The chart of the plane is a disc about the foot: 3 m above the ball's centre, and a sphere around the ball's box.
  EXPECT_NEAR(ledger.emitted.r, 2 * kPi * std::pow(3 + std::sqrt(3) * kRadius, 2), 1e-9);
  EXPECT_LT(ledger.closure(), 1e-9);
}

/// In slanted light half of the window lies under the mirror; all of it is lit.
TEST(LightFromInfinity, FallsOnAllOfAnInfiniteMirror) {
  SceneBuilder builder = ball_on_floor(DirectionalLight{normalise({1, -0.2, 0}), {2, 2, 2}, 0});
  Material mirror = diffuse(0);
  mirror.reflection = {1, 1, 1};
  builder.scene.objects[0].material = builder.add(mirror);
  builder.scene.objects.erase(builder.scene.objects.begin() + 1);
  builder.add("ball", SphereShape{{0, 2, 0}, kRadius}, 0);
  // The disc about the foot, 2 m under the ball and a sphere around its box, less the shadow of the ball itself, whose
  // edge 1e4 stratified photons find to a thousandth.
  const double lit = kPi * std::pow(2 + std::sqrt(3) * kRadius, 2) - kPi * kRadius * kRadius;
  EXPECT_NEAR(maps_of(builder.scene).statistics.ledger.emitted.r, 2 * lit, 1e-3 * 2 * lit);
}

/// Rounding puts half of a slanted lamp's places behind the wall it is flush with; their photons fly all the same.
TEST(Lamp, FlushWithAWallShinesIntoTheRoom) {
  for (const bool collimated : {false, true}) {
    const Frame frame = turned({3, 2, 1});
    const Vec3 x = frame.direction_to_world({1, 0, 0}), y = frame.direction_to_world({0, 1, 0}),
               z = frame.direction_to_world({0, 0, 1}), at = frame.point_to_world({0.1, 0.2, 5});
    SceneBuilder builder;
    builder.add("wall", PlaneShape{frame.point_to_world({7, -9, 5}), -z}, builder.add(diffuse(0.8)));
    builder.add("pane", RectangleShape{frame.point_to_world({0, 0, 1}), x * 3, y * 3}, builder.add(diffuse(0)));
    builder.scene.materials.back().reflection = {1, 1, 1};
    builder.scene.lights.push_back(
        {"lamp", AreaLight{RectangleShape{at, x * 0.5, y * -0.5}, collimated, {1, 1, 1}, {1, 1, 1}}});
    builder.scene.settings.photons = 20000;
    builder.scene.settings.gather_radius_m = 0.05;
    const double with_wall = maps_of(builder.scene).statistics.ledger.emitted.r;
    builder.scene.objects.erase(builder.scene.objects.begin());
    const double without = maps_of(builder.scene).statistics.ledger.emitted.r;
    EXPECT_GT(without, 0.9 * (collimated ? 1 : 0));
    EXPECT_NEAR(with_wall, without, 1e-12 * without);
  }
}

}  // namespace
}  // namespace vitrail
