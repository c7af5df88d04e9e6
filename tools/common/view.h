#pragma once
#include <array>
#include <optional>
#include <vector>

#include "strata/mesh.h"
#include "strata/query.h"

/// Places on the paper: x to the right, y down.
using PaperPoint = std::array<double, 2>;
using PaperPath = std::vector<PaperPoint>;

/// The projection of a drawing: perspective from a point towards another, or parallel along a direction.
class View {
 public:
  /// `towards` is where a perspective looks; `up` is upwards on the paper, as far as it can be.
  View(const strata::Origin& origin, const strata::Vertex& towards, const strata::Vertex& up);

  /// Where a point is drawn; nothing behind the eye.
  [[nodiscard]] std::optional<PaperPoint> place(const strata::Vertex& p) const;

  /// Clips a segment or polygon to what lies in front of the eye, and draws it.
  [[nodiscard]] PaperPath segment(strata::Vertex a, strata::Vertex b) const;
  [[nodiscard]] PaperPath polygon(const std::vector<strata::Vertex>& corners) const;

  /// How a face with this unit normal is lit, 0 to 1; the light comes over the viewer's left shoulder.
  [[nodiscard]] double brightness(const strata::Vertex& unit_normal) const;

 private:
  /// Coordinates to the right, up and forwards from the eye.
  [[nodiscard]] strata::Vertex from_eye(const strata::Vertex& p) const;
  [[nodiscard]] PaperPoint project(const strata::Vertex& eye_coordinates) const;

  bool perspective_;
  strata::Vertex eye_, right_, up_, forward_;
  double near_ = 0;  ///< nothing nearer than this is drawn
};
