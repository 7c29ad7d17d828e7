#pragma once
/// What the limits of a scene take from looks: no branch of a camera path ends unbooked.

#include <array>
#include <map>
#include <string>

#include "render/film.h"

namespace vitrail {

/// The limits of a scene that end a branch.
enum class Limit { max_reflections, max_transmissions };
const char* name_of(Limit limit);

/// A branch that a limit ended, as a share of its look by how light divided at the faces. It may have shown that much
/// of the pixel, or more or less: what it would have met is not known.
struct CutBranch {
  double share = 0;
  Limit limit = Limit::max_transmissions;
  std::uint32_t object = 0;  // whose face it would have left
  Layer layer = Layer::diffusion;
};

/// Shares of a look below which other renderers drop a branch. The ledger books what each would lose.
inline constexpr std::array<double, 4> kWeakShares{1e-3, 1e-4, 1e-5, 1e-6};

/// The light of a look without that of photons: sums of the channels, W sr^-1 m^-2. `weak[i]` came by branches that
/// carry less than `kWeakShares[i]` of the look.
struct LightByBranch {
  double all = 0;
  std::array<double, kWeakShares.size()> weak{};

  void add(double share, Rgb light);
  LightByBranch& operator+=(const LightByBranch& other);
};

/// Pixels [x0, x1) x [y0, y1) of a picture.
struct PixelBlock {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// The sum over the looks of a block of pixels, or of several.
class CameraLedger {
 public:
  void add_look() { ++looks_; }
  void add(const CutBranch& branch);
  void add(const LightByBranch& light) { light_ += light; }

  /// Name the pixels that have been added so far.
  void close(const PixelBlock& block);
  /// Join other pixels. The sums depend on the order.
  CameraLedger& operator+=(const CameraLedger& other);

  /// Means over the looks.
  double cut() const;
  double cut(Limit limit) const;
  double cut(Layer layer) const;

  /// The share of the light that comes by branches below `kWeakShares[place]`. Nothing is dropped here.
  double weak(std::size_t place) const;

  /// The block that lost most.
  struct Worst {
    PixelBlock block;
    double cut = 0;  // mean over its looks
    Limit limit = Limit::max_transmissions;
    std::uint32_t object = 0;  // at which most was cut
  };
  const Worst& worst() const { return worst_; }

 private:
  double mean(double sum) const { return looks_ > 0 ? sum / looks_ : 0; }

  double looks_ = 0;
  std::array<double, 2> by_limit_{};
  std::array<double, kLayerCount> by_layer_{};
  LightByBranch light_;
  std::map<std::uint32_t, double> by_object_;  // of the block that is not yet closed
  Worst worst_;
};

/// What to tell the user where a block lost more than `tolerated`, with its place and its remedy; else nothing.
std::string warning_of(const CameraLedger& ledger, const Scene& scene, double tolerated);

}  // namespace vitrail
