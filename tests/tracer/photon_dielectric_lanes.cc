/// Faces of glass for many rays: the vector loops against plain ones, bit for bit, on every instruction set, and
/// against optics.

#include <cmath>
#include <memory>

#include "build_scene.h"
#include "each_instruction_set.h"
#include "optics/fresnel.h"
#include "optics/refract.h"
#include "photon/wave/dielectric_lanes.h"

namespace vitrail {
namespace {

// Rays at faces with their indices. Every eighth pair is matched, every eighth nearly so, the others between 1/3 and 3.
struct RaysAtFaces {
  std::unique_ptr<DielectricLanes> lanes = std::make_unique<DielectricLanes>();
  std::vector<IndexPair> index;
  std::vector<Vec3> direction, normal;

  explicit RaysAtFaces(std::size_t count) {
    TestNumbers numbers;
    lanes->count = count;
    for (std::size_t i = 0; i < count; ++i) {
      normal.push_back(numbers.direction());
      direction.push_back(numbers.direction());
      if (dot(normal[i], direction[i]) > 0) normal[i] = -normal[i];
      const double n1 = numbers.between(1, 3), n2 = i % 8 == 0 ? n1 : i % 8 == 1 ? n1 + 1e-12 : numbers.between(1, 3);
      index.push_back({n1, n2, n1 - 1, n2 - 1});
      for (int a = 0; a < 3; ++a) {
        lanes->direction[a][i] = direction[i][a];
        lanes->normal[a][i] = normal[i][a];
      }
      lanes->ior_from[i] = n1;
      lanes->ior_to[i] = n2;
      lanes->ior_step[i] = index[i].step();
    }
  }
  void run() const {
    reflect(*lanes);
    refract(*lanes);
    find_fresnel_shares(*lanes);
  }
};

Vec3 at(const std::array<DielectricLanes::Column, 3>& columns, std::size_t i) {
  return {columns[0][i], columns[1][i], columns[2][i]};
}

// What the lanes of one ray must hold: the formulas of optics, with one division per vector in place of three.
struct PlainFace {
  Vec3 mirrored, refracted;
  double radicand, share_R, share_T;

  PlainFace(Vec3 ray, Vec3 normal, double n1, double n2, double step) {
    const auto normalised = [](Vec3 v) { return v * (1 / std::sqrt(dot(v, v))); };
    mirrored = normalised(ray - normal * (2 * dot(ray, normal)));

    const double against = -dot(ray, normal), above = against > 0 ? against : 0.0;
    const double cos_in = above < 1 ? above : 1.0, eta = n1 / n2;
    const Vec3 tangential = ray + normal * cos_in;
    radicand =
        eta > 2 ? 1 - eta * eta * dot(tangential, tangential) : step / n2 * (1 + eta) + (eta * cos_in) * (eta * cos_in);
    const double cos_out = step == 0 ? cos_in : std::sqrt(radicand > 0 ? radicand : 0.0);
    refracted = step == 0 ? ray : normalised(tangential * eta - normal * cos_out);

    const double sum_s = n1 * cos_in + n2 * cos_out, sum_p = n2 * cos_in + n1 * cos_out;
    const double difference = step * (n1 + n2), flow = 4 * n1 * n2 * cos_in * cos_out;
    const double r_s = -difference / (sum_s * sum_s);
    const double r_p = difference * (cos_in * cos_in - eta * eta * ((1 - cos_in) * (1 + cos_in))) / (sum_p * sum_p);
    const bool grazes = !(sum_s > 0) || !(sum_p > 0);
    share_R = grazes ? 1 : (r_s * r_s + r_p * r_p) / 2;
    share_T = grazes ? 0 : (flow / (sum_s * sum_s) + flow / (sum_p * sum_p)) / 2;
  }
};

TEST(DielectricLanes, GiveTheBitsOfAPlainLoopOnEveryInstructionSet) {
  for_each_instruction_set([] {
    BitHash hash;
    // A count that is no multiple of any vector leaves the last vector partly filled.
    const RaysAtFaces rays(251);
    // Let one ray graze its face, where both Fresnel denominators vanish.
    for (int a = 0; a < 3; ++a) {
      rays.lanes->direction[a][7] = a == 0;
      rays.lanes->normal[a][7] = a == 1;
    }
    rays.lanes->ior_from[7] = rays.lanes->ior_to[7] = 1.5;
    rays.lanes->ior_step[7] = 0;
    rays.run();
    for (std::size_t i = 0; i < rays.lanes->count; ++i) {
      const DielectricLanes& lanes = *rays.lanes;
      const PlainFace expected(at(lanes.direction, i), at(lanes.normal, i), lanes.ior_from[i], lanes.ior_to[i],
                               lanes.ior_step[i]);
      EXPECT_EQ(at(lanes.mirrored, i), expected.mirrored);
      EXPECT_EQ(at(lanes.refracted, i), expected.refracted);
      EXPECT_EQ(lanes.radicand[i], expected.radicand);
      EXPECT_EQ(lanes.share_R[i], expected.share_R);
      EXPECT_EQ(lanes.share_T[i], expected.share_T);
      for (int a = 0; a < 3; ++a) {
        hash.add(lanes.mirrored[a][i]);
        hash.add(lanes.refracted[a][i]);
      }
      for (const double value : {lanes.radicand[i], lanes.share_R[i], lanes.share_T[i]}) hash.add(value);
    }
    EXPECT_EQ(rays.lanes->share_R[7], 1);
    EXPECT_EQ(hash.value(), 11637472640180129257u);  // on every machine
  });
}

TEST(DielectricLanes, AgreeWithOpticsRayByRay) {
  const RaysAtFaces rays(DielectricLanes::kCapacity);
  const DielectricLanes& lanes = *rays.lanes;
  rays.run();
  int total = 0;
  for (std::size_t i = 0; i < lanes.count; ++i) {
    // The same operations in another order of division: a few units in the last place of a unit vector.
    const Refraction expected = refract(rays.direction[i], rays.normal[i], rays.index[i]);
    EXPECT_LT(length(at(lanes.mirrored, i) - reflect(rays.direction[i], rays.normal[i])), 1e-15);
    EXPECT_EQ(lanes.radicand[i] < 0, expected.total);
    total += expected.total;
    if (expected.total) continue;
    EXPECT_LT(length(at(lanes.refracted, i) - expected.direction), 1e-15);
    const FresnelShares shares = fresnel(rays.index[i], expected);
    EXPECT_NEAR(lanes.share_R[i], shares.R, 4e-16 * shares.R);
    EXPECT_NEAR(lanes.share_T[i], shares.T, 4e-16 * shares.T);
  }
  EXPECT_GT(total, 10);
}

}  // namespace
}  // namespace vitrail
