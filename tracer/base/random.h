#pragma once
/// Random numbers without state: each one is a pure function of (seed, purpose, stream, index, dimension).
///
/// No generator is carried from one photon or pixel to the next, so any thread may compute any sample at any time and
/// the picture keeps its bits. Two families:
///   * Owen-scrambled Sobol points by index, in two and four dimensions, for what is integrated: emission, pixels,
///   lights;
///   * a hash for everything else: roulette, band choice, roughness deep in a path.
#include <array>
#include <cstdint>

namespace vitrail {

/// What a number is used for. Two purposes never share a stream, so adding a draw here changes no draw there.
enum class Purpose : std::uint32_t {
  kEmissionPosition = 1,
  kEmissionDirection,
  kPixel,
  kLightSample,
  kCameraRoughness,
  kPhotonRoughness,
  kBandChoice,
  kFinalGather,
  kDiffuseBounce,
  kRoulette,
  kPilot,
  kBeamLattice,
  kCameraBranch,
  kGatherDisc,
};

/// A scrambling: 64 well-mixed bits that stand for (seed, purpose, and up to two identities such as a light and a
/// half).
struct Stream {
  std::uint64_t key;
};

Stream stream_of(std::uint64_t seed, Purpose purpose, std::uint64_t first = 0, std::uint64_t second = 0);

/// The first two and four Sobol dimensions, unscrambled, as 32-bit fractions. Exposed for the tests.
std::array<std::uint32_t, 4> sobol_bits(std::uint32_t index);

/// Owen-scrambled Sobol points in (0, 1). Any aligned block of 2^m indices is a (t, m, s)-net, so a prefix of blocks is
/// well stratified. Streams are independent scramblings; subsequences of one stream are NOT stratified, do not stride.
std::array<double, 2> sobol_2d(Stream stream, std::uint32_t index);
std::array<double, 4> sobol_4d(Stream stream, std::uint32_t index);

/// Another stream that depends on this one and a number: the next bounce of a path, the next light.
Stream within(Stream stream, std::uint64_t which);

/// Owen-scrambled Sobol points in an order of their own: the indices are shuffled within every aligned block. Points of
/// the same index from several streams may be joined to a point of more dimensions; without shuffling they would not be
/// independent. Every aligned block of 2^m indices is still a net.
std::array<double, 2> padded_2d(Stream stream, std::uint32_t index);
std::array<double, 4> padded_4d(Stream stream, std::uint32_t index);

/// A uniform number in (0, 1), independent over streams, indices and dimensions.
double uniform(Stream stream, std::uint64_t index, std::uint32_t dimension);

}  // namespace vitrail
