#pragma once
/// A polygon turned about an axis. Faces: one a piece of the polygon, numbered by its first corner.

#include <vector>

#include "geometry/axis_line.h"
#include "geometry/bounds.h"
#include "geometry/span.h"
#include "scene/scene.h"

namespace vitrail {

/// Pieces of cones, cylinders and flat rings. Two pieces that share a corner agree on which side of it a line passes,
/// so that every line crosses the surface an even number of times, whatever rounding does.
class Lathe {
 public:
  explicit Lathe(const LatheShape& shape);

  bool intersect(const Ray& ray, const Departure* left, ShapeHit& hit) const;
  SurfacePoint surface(Vec3 point, std::uint32_t face) const;
  bool contains(Vec3 point) const;
  Bounds bounds() const;
  double coordinate_scale() const;

 private:
  struct Corner {
    double radius = 0, height = 0;
  };
  /// A piece from one corner to the next: the unit direction with rise >= 0, and the outward normal.
  struct Piece {
    double spread = 0, rise = 0;  // change of radius and of height per length
    double out_radius = 0, out_height = 0;
    bool on_axis = false;  // no surface: both corners have radius 0
  };
  struct Cut {
    double t = 0;
    std::uint32_t face = 0;
  };

  /// A run of pieces, and how far the circles of its corners reach. Runs lie in the order of their pieces, each before
  /// the two halves that it is made of.
  struct Run {
    std::uint32_t first = 0, end = 0;            // pieces
    std::uint32_t next = 0;                      // the run after this one and all its parts
    bool whole = false;                          // its pieces are looked at, not its parts
    double low = 0, high = 0;                    // heights
    double least_squared = 0, most_squared = 0;  // of the radii
  };

  void add_run(std::uint32_t first, std::uint32_t end);
  bool passes_by(const AxisLine& line, const Run& run) const;
  Piece make_piece(const Corner& a, const Corner& b, double turn) const;
  const Corner& after(std::size_t corner) const { return corners_[corner + 1 < corners_.size() ? corner + 1 : 0]; }
  void find_cuts(const AxisLine& line, const Departure* left, std::vector<Cut>& cuts) const;
  void cut_piece(const AxisLine& line, std::uint32_t face, bool starts_outside, bool ends_outside, bool on_piece,
                 std::vector<Cut>& cuts) const;

  std::vector<Corner> corners_;
  std::vector<Piece> pieces_;  // piece i begins at corner i
  std::vector<Run> runs_;
  Vec3 middle_;  // on the axis, halfway up
  Vec3 axis_;
  double reach_ = 0;  // no corner is farther from the middle
};

}  // namespace vitrail
