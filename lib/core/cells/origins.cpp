#include "core/cells/origins.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/cells/walk.h"

namespace strata {
namespace {

/// A face that a line crosses, seen from where the line begins.
struct CrossedFace {
  std::uint32_t face = 0, operand = 0;
  Sign side{};
};

}  // namespace

std::vector<Windings> walk_to_origins(const InputComplex& input, const Space& space, const BrickGrid& bricks,
                                      std::span<const LineFace> line_faces, std::span<const Target> targets,
                                      const Monitor& monitor) {
  std::vector<std::uint32_t> order(targets.size());  // by lines
  std::iota(order.begin(), order.end(), 0u);
  const auto line_of = [&](std::uint32_t n) { return targets[n].line; };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return std::pair(line_of(a), a) < std::pair(line_of(b), b); });
  std::vector<std::size_t> first;  // of each line, in `order`
  for (std::size_t i = 0; i < order.size(); ++i)
    if (i == 0 || line_of(order[i]) != line_of(order[i - 1])) first.push_back(i);
  first.push_back(order.size());

  std::vector<Windings> windings(targets.size());
  tbb::parallel_for(std::size_t{0}, first.size() - 1, [&](std::size_t n) {
    monitor.check();
    const auto origin_of = [&](std::size_t i) { return bricks.centre(bricks.code_of(targets[order[i]].brick)); };
    InputComplex::Coordinates outside = origin_of(first[n]);
    outside[0] = space.beyond;
    const LineFace line{line_of(order[first[n]]), 0};
    const auto faces = std::equal_range(line_faces.begin(), line_faces.end(), line,
                                        [](const LineFace& a, const LineFace& b) { return a.line < b.line; });
    std::vector<CrossedFace> crossed;
    for (auto f = faces.first; f != faces.second; ++f)
      if (is_crossed_along_axis(input, f->face, outside, 0))
        crossed.push_back({f->face, input.operand_of_face(f->face), side_of_origin(input, f->face, outside)});
    for (std::size_t i = first[n]; i < first[n + 1]; ++i) {
      const InputComplex::Coordinates origin = origin_of(i);
      for (const CrossedFace& f : crossed)
        if (side_of_origin(input, f.face, origin) != f.side) windings[order[i]].add(f.operand, to_int(f.side));
    }
  });
  return windings;
}

}  // namespace strata
