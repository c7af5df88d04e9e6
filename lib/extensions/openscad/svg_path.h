#pragma once
#include <string_view>
#include <vector>

#include "strata/planar.h"

namespace strata::openscad {

/// Into how many parts curves are divided.
struct CurveParts {
  double of_turn = 40;
  double of_bezier = 20;
};

/// The subpaths of path data (SVG 1.1, 8.3), closed as filling closes them. Throws IoError for what is no path data;
/// its position counts bytes of the data.
[[nodiscard]] std::vector<std::vector<planar::PlanePoint>> svg_subpaths(std::string_view data, const CurveParts& parts);

/// Numbers that commas and white space separate, up to the first text that is none.
[[nodiscard]] std::vector<double> svg_numbers(std::string_view list);

}  // namespace strata::openscad
