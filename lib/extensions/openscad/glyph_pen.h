#pragma once
#include <cstdint>
#include <vector>

#include "strata/planar.h"

namespace strata::openscad {

/// Draws outlines of glyphs one after the other, and divides their curves into as many lines each, at equal steps of
/// the parameter. A point p of a glyph is drawn at size * (p + origin); all in doubles.
class GlyphPen {
 public:
  GlyphPen(double size, std::uint32_t lines) : size_(size), lines_(lines) {}

  void set_origin(const planar::PlanePoint& origin) { origin_ = origin; }
  void move_to(const planar::PlanePoint& p);
  void line_to(const planar::PlanePoint& p);
  void curve_to(const planar::PlanePoint& control, const planar::PlanePoint& p);  ///< a quadratic Bezier curve
  void curve_to(const planar::PlanePoint& first, const planar::PlanePoint& second, const planar::PlanePoint& p);

  /// One closed polygon for each `move_to`; those of less than three points are left out.
  [[nodiscard]] std::vector<std::vector<planar::PlanePoint>> take();

 private:
  void draw(const planar::PlanePoint& p);

  double size_;
  std::uint32_t lines_;
  planar::PlanePoint origin_{}, at_{};
  std::vector<std::vector<planar::PlanePoint>> polygons_;
};

}  // namespace strata::openscad
