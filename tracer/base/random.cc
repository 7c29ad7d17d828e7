#include "base/random.h"

namespace vitrail {
namespace {

constexpr int kDimensions = 4;

// Mix 64 bits so that every input bit reaches every output bit (the finaliser of splitmix64).
constexpr std::uint64_t mixed(std::uint64_t x) {
  x ^= x >> 30;
  x *= 0xbf58476d1ce4e5b9u;
  x ^= x >> 27;
  x *= 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

constexpr std::uint32_t reversed(std::uint32_t x) {
  x = __builtin_bswap32(x);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
  x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
  return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
}

// Column j of each generator matrix as a 32-bit fraction, from the primitive polynomials and initial numbers of Joe and
// Kuo (2008): dimension 1 is the radical inverse, dimensions 2 to 4 have degrees 1, 2, 3.
constexpr std::array<std::array<std::uint32_t, 32>, kDimensions> directions() {
  constexpr int degree[kDimensions] = {0, 1, 2, 3};
  constexpr std::uint32_t inner[kDimensions] = {0, 0, 1, 1};
  constexpr std::uint32_t initial[kDimensions][3] = {{1, 0, 0}, {1, 0, 0}, {1, 3, 0}, {1, 3, 1}};
  std::array<std::array<std::uint32_t, 32>, kDimensions> v{};
  for (int j = 0; j < 32; ++j) v[0][j] = 1u << (31 - j);
  for (int d = 1; d < kDimensions; ++d) {
    const int s = degree[d];
    for (int j = 0; j < 32; ++j) {
      if (j < s) {
        v[d][j] = initial[d][j] << (31 - j);
        continue;
      }
      std::uint32_t x = v[d][j - s] ^ (v[d][j - s] >> s);
      for (int k = 1; k < s; ++k) {
        if ((inner[d] >> (s - 1 - k)) & 1u) x ^= v[d][j - k];
      }
      v[d][j] = x;
    }
  }
  return v;
}

// One table lookup per index byte. The entries are bit-reversed, because the scrambling works on reversed bits.
using ByteTable = std::array<std::array<std::uint32_t, 256>, 4>;

constexpr std::array<ByteTable, kDimensions> byte_tables() {
  constexpr auto v = directions();
  std::array<ByteTable, kDimensions> tables{};
  for (int d = 0; d < kDimensions; ++d) {
    for (int byte = 0; byte < 4; ++byte) {
      for (int value = 1; value < 256; ++value) {
        // Reuse the entry without the lowest set bit: one exclusive-or each.
        const int rest = value & (value - 1);
        const int bit = __builtin_ctz(static_cast<unsigned>(value));
        tables[d][byte][value] = tables[d][byte][rest] ^ reversed(v[d][8 * byte + bit]);
      }
    }
  }
  return tables;
}

constexpr std::array<ByteTable, kDimensions> kTables = byte_tables();

inline std::uint32_t reversed_sobol(int dimension, std::uint32_t index) {
  if (dimension == 0) return index;
  const ByteTable& t = kTables[dimension];
  return t[0][index & 255u] ^ t[1][(index >> 8) & 255u] ^ t[2][(index >> 16) & 255u] ^ t[3][index >> 24];
}

// Owen scrambling of a bit-reversed fraction: each bit is flipped by a hash of the bits above it, which in reversed
// order are the lower bits, and a product carries only upwards (Laine and Karras 2011, constants of Vegdahl 2021).
inline std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

// Take the middle of the 2^-32 wide stratum, so that neither 0 nor 1 occurs.
inline double fraction(std::uint32_t bits) { return (static_cast<double>(bits) + 0.5) * 0x1p-32; }

template <int kCount>
inline std::array<double, kCount> scrambled_point(Stream stream, std::uint32_t index) {
  std::array<double, kCount> point;
  for (int d = 0; d < kCount; ++d) {
    const auto seed = static_cast<std::uint32_t>(mixed(stream.key + static_cast<std::uint64_t>(d)));
    point[d] = fraction(reversed(scrambled(reversed_sobol(d, index), seed)));
  }
  return point;
}

// An Owen scrambling of the index itself permutes indices within every aligned block of a power of two.
inline std::uint32_t shuffled(Stream stream, std::uint32_t index) {
  return reversed(scrambled(reversed(index), static_cast<std::uint32_t>(mixed(stream.key + 0x5851f42d4c957f2du))));
}

}  // namespace

Stream stream_of(std::uint64_t seed, Purpose purpose, std::uint64_t first, std::uint64_t second) {
  constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15u;
  std::uint64_t key = mixed(seed + kGolden);
  key = mixed(key ^ (static_cast<std::uint64_t>(purpose) * kGolden));
  key = mixed(key + kGolden * (first + 1));
  return {mixed(key + kGolden * (second + 1))};
}

std::array<std::uint32_t, 4> sobol_bits(std::uint32_t index) {
  std::array<std::uint32_t, 4> bits{};
  for (int d = 0; d < kDimensions; ++d) bits[d] = reversed(reversed_sobol(d, index));
  return bits;
}

std::array<double, 2> sobol_2d(Stream stream, std::uint32_t index) { return scrambled_point<2>(stream, index); }

std::array<double, 4> sobol_4d(Stream stream, std::uint32_t index) { return scrambled_point<4>(stream, index); }

Stream within(Stream stream, std::uint64_t which) { return {mixed(stream.key + 0x9e3779b97f4a7c15u * (which + 1))}; }

std::array<double, 2> padded_2d(Stream stream, std::uint32_t index) {
  return sobol_2d(stream, shuffled(stream, index));
}

std::array<double, 4> padded_4d(Stream stream, std::uint32_t index) {
  return sobol_4d(stream, shuffled(stream, index));
}

double uniform(Stream stream, std::uint64_t index, std::uint32_t dimension) {
  const std::uint64_t bits = mixed(mixed(stream.key ^ (index * 0xd1342543de82ef95u)) + dimension);
  return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
}

}  // namespace vitrail
