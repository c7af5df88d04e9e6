#include "extensions/openscad/glyph_pen.h"

#include <utility>

namespace strata::openscad {

using planar::PlanePoint;

void GlyphPen::draw(const PlanePoint& p) {
  polygons_.back().push_back({size_ * (p[0] + origin_[0]), size_ * (p[1] + origin_[1])});
}

void GlyphPen::move_to(const PlanePoint& p) {
  polygons_.emplace_back();
  line_to(p);
}

void GlyphPen::line_to(const PlanePoint& p) {
  draw(p);
  at_ = p;
}

void GlyphPen::curve_to(const PlanePoint& control, const PlanePoint& p) {
  for (std::uint32_t i = 1; i < lines_; ++i) {
    const double t = static_cast<double>(i) / lines_, s = 1 - t;
    PlanePoint on_curve{};
    for (std::size_t k = 0; k < 2; ++k) on_curve[k] = s * s * at_[k] + 2 * s * t * control[k] + t * t * p[k];
    draw(on_curve);
  }
  line_to(p);
}

void GlyphPen::curve_to(const PlanePoint& first, const PlanePoint& second, const PlanePoint& p) {
  for (std::uint32_t i = 1; i < lines_; ++i) {
    const double t = static_cast<double>(i) / lines_, s = 1 - t;
    PlanePoint on_curve{};
    for (std::size_t k = 0; k < 2; ++k)
      on_curve[k] = s * s * s * at_[k] + 3 * s * s * t * first[k] + 3 * s * t * t * second[k] + t * t * t * p[k];
    draw(on_curve);
  }
  line_to(p);
}

std::vector<std::vector<PlanePoint>> GlyphPen::take() {
  for (auto& polygon : polygons_)
    if (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
  std::erase_if(polygons_, [](const auto& polygon) { return polygon.size() < 3; });
  return std::exchange(polygons_, {});
}

}  // namespace strata::openscad
