#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "common/view.h"
#include "face_colors.h"
#include "strata/mesh.h"

/// A triangle that lies in a face with an image: corners in space, and their places in the face.
struct TexturedTriangle {
  std::array<strata::Vertex, 3> corners;
  std::array<FaceColors::Weights, 3> places;
};

/// A part of such a triangle that is drawn in one color.
struct ColoredTriangle {
  std::array<strata::Vertex, 3> corners;
  ScreenColor color;
};

/// Where a point of the plane of a face is in it. For a face without area: in the first corner.
[[nodiscard]] FaceColors::Weights place_in(const std::array<strata::Vertex, 3>& face, const strata::Vertex& p);

/// Divides a triangle until its parts are small on paper, and gives each the average of the image there, in steps of a
/// 31st. Neighbours of one color are joined again. Parts of one color follow one another.
[[nodiscard]] std::vector<ColoredTriangle> divided(const TexturedTriangle& triangle, const FaceColors& colors,
                                                   std::uint32_t face, const View& view, double longest_side);
