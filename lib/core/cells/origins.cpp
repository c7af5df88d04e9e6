#include "core/cells/origins.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/cells/walk.h"

namespace strata {

std::vector<Windings> walk_to_origins(const InputComplex& input, const Space& space, const BrickGrid& bricks,
                                      std::span<const LineFace> line_faces, std::span<const Target> targets,
                                      const Monitor& monitor) {
  std::vector<Windings> windings(targets.size());
  tbb::parallel_for(std::size_t{0}, targets.size(), [&](std::size_t n) {
    monitor.check();
    const InputComplex::Coordinates origin = bricks.centre(bricks.code_of(targets[n].brick));
    const InputComplex::Coordinates outside{space.beyond, origin[1], origin[2]};
    const auto on_line = std::equal_range(line_faces.begin(), line_faces.end(), LineFace{targets[n].line, 0},
                                          [](const LineFace& a, const LineFace& b) { return a.line < b.line; });
    for (auto f = on_line.first; f != on_line.second; ++f)
      windings[n].add(input.operand_of_face(f->face), crossing_along_axis(input, f->face, outside, origin, 0));
  });
  return windings;
}

}  // namespace strata
