#include "extensions/contact/parts.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/cells/walk.h"
#include "core/kernel/disjoint_sets.h"

namespace strata::contact {

Parts::Parts(std::span<const Solid> solids)
    : solids_(solids.begin(), solids.end()), boxes_(solids.size()), lazy_(std::make_unique<Lazy[]>(solids.size())) {
  for (const Solid& s : solids_) input_.add(s.mesh().vertices, s.mesh().triangles, s.exact_mesh().exact);
  tbb::parallel_for(std::uint32_t{0}, size(), [&](std::uint32_t part) {
    const Mesh& mesh = solids_[part].mesh();
    for (const Vertex& v : mesh.vertices) boxes_[part].include(v);
    for (const ExactVertex& v : solids_[part].exact_mesh().exact)
      boxes_[part].include(box_of_vertex(input_, input_.first_vertex(part) + v.vertex));
  });
}

Box Parts::common_box(std::uint32_t a, std::uint32_t b) const {
  Box common;
  if (boxes_[a].empty() || boxes_[b].empty() || !boxes_[a].overlaps(boxes_[b])) return common;
  for (std::size_t i = 0; i < 3; ++i) {
    common.lower[i] = std::max(boxes_[a].lower[i], boxes_[b].lower[i]);
    common.upper[i] = std::min(boxes_[a].upper[i], boxes_[b].upper[i]);
  }
  return common;
}

bool Parts::are_beside(std::uint32_t a, std::uint32_t b) const {
  const Box common = common_box(a, b);
  for (std::size_t i = 0; i < 3; ++i)
    if (common.lower[i] >= common.upper[i]) return true;
  return false;
}

const BoxTree& Parts::tree(std::uint32_t part) const {
  Lazy& lazy = lazy_[part];
  std::call_once(lazy.tree_once, [&] { lazy.tree = std::make_unique<const BoxTree>(tree_of_part(input_, part)); });
  return *lazy.tree;
}

const std::vector<Parts::Piece>& Parts::pieces(std::uint32_t part) const {
  Lazy& lazy = lazy_[part];
  std::call_once(lazy.pieces_once, [&] {
    const auto points = input_.points(part);
    DisjointSets<std::uint32_t> sets(points.size());
    for (const auto& [a, b, c] : input_.faces(part)) {
      sets.unite(a, b);
      sets.unite(a, c);
    }
    std::vector<std::uint32_t> number(points.size(), ~0u);
    for (const auto& face : input_.faces(part)) {
      std::uint32_t& piece = number[sets.find(face[0])];
      if (piece == ~0u) {
        piece = static_cast<std::uint32_t>(lazy.pieces.size());
        lazy.pieces.push_back({input_.first_vertex(part) + face[0], {}});
      }
      for (const std::uint32_t v : face) lazy.pieces[piece].box.include(points[v]);
    }
  });
  return lazy.pieces;
}

bool Parts::has_piece_inside(std::uint32_t part, std::uint32_t other) const {
  const Box& outer = boxes_[other];
  const auto fits = [&](const Box& inner) {
    for (std::size_t i = 0; i < 3; ++i)
      if (inner.lower[i] < outer.lower[i] || inner.upper[i] > outer.upper[i]) return false;
    return true;
  };
  const auto& all = pieces(part);
  return std::any_of(all.begin(), all.end(), [&](const Piece& piece) {
    return fits(piece.box) && is_inside(make_point(input_, SymbolicPoint::input(piece.vertex)), other);
  });
}

bool Parts::is_inside(const Point& point, std::uint32_t part) const {
  constexpr InputComplex::Coordinates along_x{1, 0, 0};
  Box ray;  // from infinity to the point
  for (std::size_t i = 0; i < 3; ++i) {
    ray.lower[i] = i == 0 ? -Box::infinity : point.at[i].lower();
    ray.upper[i] = point.at[i].upper();
  }
  int winding = 0;
  tree(part).for_each_near(ray, [&](std::uint32_t face) {
    winding += crossing_from_infinity(input_, face, along_x, point);
    return true;
  });
  return winding > 0;
}

}  // namespace strata::contact
