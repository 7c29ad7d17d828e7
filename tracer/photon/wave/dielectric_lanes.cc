#include "photon/wave/dielectric_lanes.h"

#include <cmath>

namespace vitrail {

void reflect(DielectricLanes& lanes) {
  for (std::size_t i = 0; i < lanes.count; ++i) {
    const double dx = lanes.direction[0][i], dy = lanes.direction[1][i], dz = lanes.direction[2][i];
    const double nx = lanes.normal[0][i], ny = lanes.normal[1][i], nz = lanes.normal[2][i];
    const double twice = 2 * (dx * nx + dy * ny + dz * nz);
    const double x = dx - nx * twice, y = dy - ny * twice, z = dz - nz * twice;
    const double per_size = 1 / std::sqrt(x * x + y * y + z * z);
    lanes.mirrored[0][i] = x * per_size;
    lanes.mirrored[1][i] = y * per_size;
    lanes.mirrored[2][i] = z * per_size;
  }
}

void refract(DielectricLanes& lanes) {
  for (std::size_t i = 0; i < lanes.count; ++i) {
    const double dx = lanes.direction[0][i], dy = lanes.direction[1][i], dz = lanes.direction[2][i];
    const double nx = lanes.normal[0][i], ny = lanes.normal[1][i], nz = lanes.normal[2][i];
    const double n1 = lanes.ior_from[i], n2 = lanes.ior_to[i], step = lanes.ior_step[i];
    const double against = -(dx * nx + dy * ny + dz * nz);
    const double above = against > 0 ? against : 0.0;
    const double c1 = above < 1 ? above : 1.0;

    // Form the radicand from the difference of the indices, but from the sine far into the thinner medium, as
    // optics/refract explains.
    const double eta = n1 / n2, one_minus_eta = step / n2;
    const double ax = dx + nx * c1, ay = dy + ny * c1, az = dz + nz * c1;
    const double by_sine = 1 - eta * eta * (ax * ax + ay * ay + az * az);
    const double by_step = one_minus_eta * (1 + eta) + (eta * c1) * (eta * c1);
    const double k = eta > 2 ? by_sine : by_step;
    const double root = std::sqrt(k > 0 ? k : 0.0);
    const bool matched = step == 0;
    const double c2 = matched ? c1 : root;
    const double x = ax * eta - nx * c2, y = ay * eta - ny * c2, z = az * eta - nz * c2;
    const double per_size = 1 / std::sqrt(x * x + y * y + z * z);
    lanes.radicand[i] = k;
    lanes.cos_in[i] = c1;
    lanes.cos_out[i] = c2;
    lanes.refracted[0][i] = matched ? dx : x * per_size;
    lanes.refracted[1][i] = matched ? dy : y * per_size;
    lanes.refracted[2][i] = matched ? dz : z * per_size;
  }
}

// R and T each on its own, as optics/fresnel does.
void find_fresnel_shares(DielectricLanes& lanes) {
  for (std::size_t i = 0; i < lanes.count; ++i) {
    const double n1 = lanes.ior_from[i], n2 = lanes.ior_to[i], step = lanes.ior_step[i];
    const double c1 = lanes.cos_in[i], c2 = lanes.cos_out[i], eta = n1 / n2;
    const double across = n1 * c1 + n2 * c2, along = n2 * c1 + n1 * c2;
    const double difference = step * (n1 + n2), sine_squared = (1 - c1) * (1 + c1);
    const double across_squared = across * across, along_squared = along * along;
    const double r_s = -difference / across_squared;
    const double r_p = difference * (c1 * c1 - eta * eta * sine_squared) / along_squared;
    const double flow = 4 * n1 * n2 * c1 * c2;
    const bool grazes = !(across > 0) | !(along > 0);
    lanes.share_R[i] = grazes ? 1.0 : (r_s * r_s + r_p * r_p) / 2;
    lanes.share_T[i] = grazes ? 0.0 : (flow / across_squared + flow / along_squared) / 2;
  }
}

}  // namespace vitrail
