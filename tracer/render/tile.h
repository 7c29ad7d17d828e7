#pragma once
/// One tile of the image: follow every sample of every pixel, then gather photons for all of them at once.

#include "render/render.h"
#include "render/whitted.h"

namespace vitrail {

struct Tile {
  int x0, y0, x1, y1;  // pixels [x0, x1) x [y0, y1)
};

/// The tiles of an image in reading order.
std::vector<Tile> tiles_of(const Image& image);

struct TileStatistics {
  Counters counters;
  CameraLedger ledger;
  double camera_cpu_s = 0, gather_cpu_s = 0;
  TileStatistics& operator+=(const TileStatistics& other);
};

/// Render a tile into its part of the film.
TileStatistics render_tile(const LitWorld& world, const Picture& picture, const Tile& tile, Film& film);

}  // namespace vitrail
