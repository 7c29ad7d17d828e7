/// Beams against the ray map of a ball, on flat and on curved surfaces, and all of the light between them.

#include <gtest/gtest.h>

#include "build_mesh.h"
#include "photon/caustic_pass.h"

namespace vitrail {
namespace {

PhotonMaps beams_of(const Scene& scene) {
  SilentMonitor monitor;
  const Intersector intersector(scene);
  return make_caustic_maps({scene, intersector}, {2, monitor});
}

Scene ball_over_floor(std::uint64_t rays, bool fresnel = false) {
  SceneBuilder builder;
  builder.add("floor", PlaneShape{{0, 0, 0}, {0, 1, 0}}, builder.add(diffuse(0.8)));
  builder.add("ball", SphereShape{{0, 2, 0}, 1}, builder.add(glass(1.5, {1, 1, 1}, fresnel)));
  builder.scene.lights.push_back({"sun", DirectionalLight{{0, -1, 0}, {1, 2, 3}, 0}});
  builder.scene.settings.photons = rays;
  builder.scene.settings.gather_radius_m = 0.01;
  builder.scene.settings.solver = Solver::beams;
  return builder.scene;
}

/// Where light that enters at distance b from the axis lands: the turn is 2 (i - r), the way out at the angle 2 r - i.
double landing(double b) {
  const double i = std::asin(b), r = std::asin(b / 1.5), turn = 2 * (i - r), out = 2 * r - i;
  return std::abs(std::sin(out) - (2 - std::cos(out)) * std::tan(turn));
}

/// b / rho / |d rho / d b| at a distance from the axis [O 1.6]; the ball turns light from b to rho one to one.
double gain(double rho) {
  double low = 1e-9, high = 0.9;
  for (int step = 0; step < 60; ++step) {
    const double middle = (low + high) / 2;
    (landing(middle) < rho ? low : high) = middle;
  }
  const double step = 1e-6, slope = (landing(low + step) - landing(low - step)) / (2 * step);
  return low / rho / std::abs(slope);
}

/// Of the irradiance at places within 0.8 of the axis, over what it should be: mean, and mean distance from 1.
struct Ratio {
  double mean = 0, off = 0;
};
Ratio ratio_of(const PhotonMaps& maps) {
  TestNumbers numbers;
  Ratio ratio;
  constexpr int kPlaces = 2000;
  for (int k = 0; k < kPlaces; ++k) {
    const double rho = 0.8 * std::sqrt(numbers.unit()), angle = 2 * kPi * numbers.unit();
    const Rgb found = maps.irradiance(k % 2, {{rho * std::cos(angle), 0, rho * std::sin(angle)}, {0, 1, 0}});
    EXPECT_NEAR(found.b / found.r, 3, 1e-5);
    ratio.mean += found.r / gain(rho) / kPlaces;
    ratio.off += std::abs(found.r / gain(rho) - 1) / kPlaces;
  }
  return ratio;
}

/// Within a beam the area does not vary, so at a place the error is that of a cell; means over an area have its square.
TEST(Beams, HaveTheIrradianceOfTheRayMapAndConverge) {
  const Ratio coarse = ratio_of(beams_of(ball_over_floor(5000))), fine = ratio_of(beams_of(ball_over_floor(80000)));
  EXPECT_LT(fine.off, 0.04);
  EXPECT_NEAR(fine.mean, 1, 3 * fine.off / std::sqrt(2000.0) + 0.001);

  // Sixteen times the rays are a quarter of the cell; the lattices are drawn to within an eighth.
  EXPECT_NEAR(coarse.off / fine.off, 4, 1);
}

/// The middle of the light's disc lies on the creases of its map, where beams share edges: each place is in one beam.
TEST(Beams, ShareTheirEdges) {
  SceneBuilder builder;
  builder.add("floor", PlaneShape{{0, 0, 0}, {0, 1, 0}}, builder.add(diffuse(0.8)));
  builder.add("plate", BoxShape{{-5, 1, -5}, {5, 1.7, 5}, {}}, builder.add(glass(1)));
  builder.scene.lights.push_back({"sun", DirectionalLight{{0, -1, 0}, {1, 1, 1}, 0}});
  builder.scene.settings.photons = 10000;
  builder.scene.settings.gather_radius_m = 0.01;
  builder.scene.settings.solver = Solver::beams;
  const PhotonMaps maps = beams_of(builder.scene);
  double mean = 0;
  for (int k = 0; k < 64; ++k) {
    const double x = (k % 8 - 3.5) / 2, z = (k / 8 - 3.5) / 2;
    const double found = maps.irradiance(k % 2, {{x, 0, z}, {0, 1, 0}}).r;
    EXPECT_LT(found, 1.6) << x << " " << z;
    mean += found / 64;
  }
  // At the very middle the disc's rings are squares: a beam there has up to pi / 2 of the light.
  EXPECT_NEAR(mean, 1, 0.02);
}

TEST(Beams, OfTheOtherSideOfASurfaceDoNotCount) {
  const PhotonMaps maps = beams_of(ball_over_floor(10000));
  EXPECT_EQ(maps.irradiance(0, {{0.3, 0, 0}, {0, -1, 0}}), Rgb{});
  EXPECT_EQ(maps.irradiance(0, {{0.3, 0.01, 0}, {0, 1, 0}}), Rgb{}) << "a centimetre above the floor";
}

/// With Fresnel shares light leaves in ever weaker sheets, each with a discontinuity of its own; nothing is lost from
/// the ledger, and what no beam holds lessens with the rays.
TEST(Beams, CloseTheLedger) {
  const PhotonStatistics few = beams_of(ball_over_floor(2000, true)).statistics;
  const PhotonStatistics many = beams_of(ball_over_floor(32000, true)).statistics;
  for (const PhotonStatistics* each : {&few, &many}) {
    EXPECT_LT(each->ledger.closure(), 1e-12);
    EXPECT_NEAR(each->ledger.emitted.r, kPi, (each == &few ? 0.005 : 0.0005) * kPi);
  }
  EXPECT_LT(many.remainder.as_photons.r, few.remainder.as_photons.r / 2);
}

/// Two photon maps' worth of light, mean of the halves: through beams and as photons, W.
struct Landed {
  double by_beams = 0, as_photons = 0;
};
Landed landed(const PhotonMaps& maps) {
  Landed sum;
  for (int half = 0; half < 2; ++half) {
    const BeamMap& beams = *maps.beams[half];
    for (std::size_t i = 0; i < beams.size(); ++i) {
      const Beam& beam = beams.beam(i);
      for (const std::uint32_t corner : beam.corner) sum.by_beams += beam.share * beams.corner(corner).power[0] / 6;
    }
    for (std::size_t i = 0; i < maps.half[half]->size(); ++i) sum.as_photons += maps.half[half]->photon(i).flux.r / 2;
  }
  return sum;
}

/// Under even light of 1 W/m2 from above, in a hollow ball that takes all light in.
Scene under_a_lamp(SceneBuilder builder, double half_width = 1.02) {
  builder.add("sky", SphereShape{{0, 0, 0}, 20}, builder.add(diffuse(0.5)));
  const RectangleShape above{{0, 5, 0}, {half_width, 0, 0}, {0, 0, half_width}};
  builder.scene.lights.push_back({"lamp", AreaLight{above, true, {}, {1, 1, 1}}});
  builder.scene.settings.photons = 100000;
  builder.scene.settings.gather_radius_m = 0.1;
  builder.scene.settings.solver = Solver::beams;
  return builder.scene;
}

/// The light that lands, with what is cut after many faces, is what falls on the glass: its area across the light.
void expect_all_to_land(const Scene& scene, double area) {
  const PhotonMaps maps = beams_of(scene);
  const PhotonStatistics& statistics = maps.statistics;
  const Landed found = landed(maps);
  EXPECT_LT(statistics.ledger.closure(), 1e-12);
  EXPECT_NEAR((found.by_beams + found.as_photons + statistics.ledger.truncated.r) / area, 1, 1e-4)
      << found.by_beams / area << " by beams, " << found.as_photons / area << " as photons, unseen "
      << statistics.remainder.unseen.r / area;
  EXPECT_NEAR(statistics.remainder.as_photons.r, found.as_photons, 1e-5 * area);
}

TEST(Beams, LandAllTheLightOfABall) {
  SceneBuilder builder;
  builder.add("ball", SphereShape{{0, 0, 0}, 1}, builder.add(glass(1.5, {1, 1, 1}, true)));
  expect_all_to_land(under_a_lamp(builder), kPi);
}

TEST(Beams, LandAllTheLightOfAHollowBall) {
  SceneBuilder builder;
  builder.add("ball", SphereShape{{0, 0, 0}, 1}, builder.add(glass(1.5, {1, 1, 1}, true)));
  builder.add("hollow", SphereShape{{0, 0, 0}, 0.8}, builder.add(glass(1, {1, 1, 1}, true)), 1);
  expect_all_to_land(under_a_lamp(builder), kPi);
}

/// The lower ball stands half in the shade of the upper one: the area of both discs less that of their overlap.
TEST(Beams, LandAllTheLightOfTwoBalls) {
  constexpr double kApart = 1.2, kSmall = 0.7;
  SceneBuilder builder;
  const std::uint32_t material = builder.add(glass(1.5, {1, 1, 1}, true));
  builder.add("upper", SphereShape{{0, 2, 0}, 1}, material);
  builder.add("lower", SphereShape{{kApart, 0, 0}, kSmall}, material);
  const double d = kApart, r = kSmall, x = (d * d + 1 - r * r) / (2 * d);
  const double overlap = std::acos(x) + r * r * std::acos((d - x) / r) - d * std::sqrt(1 - x * x);
  expect_all_to_land(under_a_lamp(builder, 2), kPi * (1 + r * r) - overlap);
}

/// A ball of flat faces, of which most rays meet another than their neighbours do: its light is left to photons.
TEST(Beams, LeaveAFacetedMeshToPhotons) {
  constexpr int kSteps = 12;
  SceneBuilder builder;
  const MeshShape mesh = mesh_of(ball_text(kSteps));
  builder.add("ball", mesh, builder.add(glass(1.5, {1, 1, 1}, true)));
  const PhotonMaps maps = beams_of(under_a_lamp(builder));
  ASSERT_EQ(maps.beams[0], nullptr);
  ASSERT_EQ(maps.statistics.routes.size(), 1u);
  EXPECT_GT(maps.statistics.routes[0].pilot.torn, 0.25);

  // From above it is a polygon. Its edges cross some 900 of the cells that 5e4 photons of a half are stratified in, and
  // chance decides about half a photon in each: 15 photons or 4e-4 of the area. Allow three of these.
  const double area = kSteps * std::sin(kPi / kSteps);
  const Ledger& ledger = maps.statistics.ledger;
  EXPECT_NEAR((ledger.stored.r + ledger.truncated.r) / area, 1, 1.2e-3);
}

/// Few enough facets for the rays: one prism, all of whose light lands, through beams as well.
TEST(Beams, LandAllTheLightOfAFlatMesh) {
  SceneBuilder builder;
  const MeshShape mesh = mesh_of(kCube, false, turned_about_z(20));
  builder.add("cube", mesh, builder.add(glass(1.5, {1, 1, 1}, true)));
  const double across = 2 * (std::cos(radians(20)) + std::sin(radians(20)));
  expect_all_to_land(under_a_lamp(builder, 1.4), 2 * across);
}

/// Light from above through a plate of index 1 onto a ball: E cos, by chords that lie off the surface.
TEST(Beams, LandOnCurvedSurfaces) {
  SceneBuilder builder;
  builder.add("ball", SphereShape{{0, 0, 0}, 1}, builder.add(diffuse(0.5)));
  builder.add("plate", BoxShape{{-1.2, 2, -1.2}, {1.2, 2.1, 1.2}, {}}, builder.add(glass(1)));
  builder.scene.lights.push_back({"sun", DirectionalLight{{0, -1, 0}, {1, 1, 1}, 0}});
  builder.scene.settings.photons = 40000;
  builder.scene.settings.gather_radius_m = 0.01;
  builder.scene.settings.solver = Solver::beams;
  const PhotonMaps maps = beams_of(builder.scene);
  TestNumbers numbers;
  double mean = 0;
  int places = 0;
  for (int k = 0; k < 400; ++k) {
    Vec3 normal = numbers.direction();
    normal.y = std::abs(normal.y);
    if (normal.y < 0.3) continue;  // near the outline a beam spans it

    // Over a cell of 2.4 / 87 the cosine changes by the tangent times its width.
    const double found = maps.irradiance(k % 2, {normal, normal}).r, tangent = std::sqrt(1 / (normal.y * normal.y) - 1);
    EXPECT_NEAR(found, normal.y, 2.4 / 87 * (tangent + 0.1)) << normal.y;
    mean += found / normal.y;
    ++places;
  }
  EXPECT_NEAR(mean / places, 1, 0.005);
}

/// A pilot tries block after block of a clear ball until it is told that it knows enough.
TEST(BeamPilot, EndsWhereItKnowsEnough) {
  SceneBuilder builder;
  builder.add("floor", PlaneShape{{0, 0, 0}, {0, 1, 0}}, builder.add(diffuse(0.8)));
  builder.add("ball", SphereShape{{0, 2, 0}, 1}, builder.add(glass(1.5)));
  builder.scene.lights.push_back({"sun", DirectionalLight{{0, -1, 0}, {1, 1, 1}, 0}});
  const Intersector intersector(builder.scene);
  const Targets targets = find_targets(builder.scene, intersector);
  const PhotonPass pass{{builder.scene, intersector}, {targets.surroundings.center}, targets.surroundings.radius};
  const Chart chart = make_charts(builder.scene, targets, 20000).front();
  const BeamLattice lattice(pass, chart, Stream{1});
  int all = 0, few = 0;
  EXPECT_GT(lattice.pilot([&](const BeamPilot&) { return ++all > 100; }).landings, 0.9);
  EXPECT_GT(lattice.pilot([&](const BeamPilot& found) { return ++few > 100 || found.landings > 0; }).landings, 0.9);
  EXPECT_GE(all, 4);
  EXPECT_EQ(few, 2);
}

}  // namespace
}  // namespace vitrail
