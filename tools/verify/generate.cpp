#include "verify/generate.h"

#include <array>

#include "verify/families.h"

namespace verify {

strata::Mesh generate(const JsonLocation& line) {
  constexpr std::array makers = {make_box,         make_boxes,      make_grid,   make_cells,
                                 make_tetrahedron, make_octahedron, make_sphere, make_prism};
  const std::size_t family =
      line.at("generate")
          .choice("family", {"box", "boxes", "grid", "cells", "tetrahedron", "octahedron", "sphere", "prism"});
  return makers[family](line);
}

}  // namespace verify
