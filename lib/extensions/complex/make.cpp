#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/kernel/input_complex.h"
#include "core/kernel/predicates.h"
#include "extensions/complex/input_of_cells.h"
#include "extensions/complex/overlay.h"
#include "strata/complex.h"
#include "strata/errors.h"

namespace strata::complex {
namespace {

using Index = std::uint32_t;

/// Cells of the operands that are constructed here.
enum Label : Index { outside, inside, border };

[[noreturn]] void refuse(DefectKind kind, const Vertex& where, std::vector<Index> faces, std::string message) {
  Defect defect;
  defect.kind = kind;
  defect.where = where;
  defect.faces = std::move(faces);
  defect.message = std::move(message);
  throw InputError({defect});
}

void require_finite(std::span<const Vertex> points) {
  for (const Vertex& p : points)
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      refuse(DefectKind::non_finite_coordinate, p, {}, "a corner is not finite");
}

template <class Operand>
SelectiveComplex from(const Operand& operand, bool marks_border) {
  Overlay result = overlay(std::span(&operand, 1));
  for (std::size_t d = 0; d < 4; ++d)
    for (std::size_t i = 0; i < result.labels[d].size(); ++i)
      result.cells.marks[d][i] = result.labels[d][i] == inside || (marks_border && result.labels[d][i] == border);
  return SelectiveComplex::of(result.cells);
}

void add_triangle(Soup& soup, const Triangle& t, Index face, Index sides, Index behind) {
  soup.mesh.mesh.triangles.push_back(t);
  soup.face_cell.push_back(face);
  soup.volume_cell.push_back({outside, behind});
  soup.edge_cell.push_back({sides, sides, sides});
}

SelectiveComplex simplex_in_space(std::span<const Vertex> corners, bool closed) {
  const Index rim = corners.size() == 1 ? inside : border;
  Soup soup;
  soup.mesh.mesh.vertices.assign(corners.begin(), corners.end());
  soup.vertex_cell.assign(corners.size(), rim);
  soup.everywhere = outside;
  if (corners.size() == 1) add_triangle_at_vertex(soup, 0);
  if (corners.size() == 2) add_triangle_at_edge(soup, 0, 1, inside);
  if (corners.size() == 3) add_triangle(soup, {0, 1, 2}, inside, border, outside);
  if (corners.size() == 4) {
    const bool reversed = orient3d(corners[0], corners[1], corners[2], corners[3]) == Sign::positive;
    for (const Triangle& t : {Triangle{0, 1, 2}, Triangle{1, 0, 3}, Triangle{2, 1, 3}, Triangle{0, 2, 3}})
      add_triangle(soup, reversed ? Triangle{t[1], t[0], t[2]} : t, border, border, inside);
  }
  return from(soup, closed);
}

SelectiveComplex simplex_in_plane(std::span<const Vertex> corners, bool closed) {
  Drawing drawing;
  drawing.points.mesh.vertices.assign(corners.begin(), corners.end());
  drawing.vertex_cell.assign(corners.size(), corners.size() == 1 ? inside : border);
  drawing.outside = outside;
  drawing.by_parity = corners.size() == 3;
  if (corners.size() == 2) drawing.segments = {{0, 1}};
  if (corners.size() == 3) drawing.segments = {{0, 1}, {1, 2}, {2, 0}};
  drawing.edge_cell.assign(drawing.segments.size(), corners.size() == 2 ? inside : border);
  drawing.face_cell.assign(drawing.segments.size(), {outside, outside});
  return from(drawing, closed);
}

bool are_independent(std::span<const Vertex> corners) {
  InputComplex input;
  const std::array<Triangle, 1> face{{{0, 1, 2}}};
  if (corners.size() == 2) return corners[0] != corners[1];
  if (corners.size() == 3) {
    input.add(corners, face);
    return !is_degenerate(input, 0);
  }
  return corners.size() == 1 || orient3d(corners[0], corners[1], corners[2], corners[3]) != Sign::zero;
}

}  // namespace

SelectiveComplex of_solid(const Solid& solid, Border rim) {
  Soup soup;
  soup.mesh = solid.exact_mesh();
  soup.vertex_cell.assign(soup.mesh.mesh.vertices.size(), none);
  const std::size_t n = soup.mesh.mesh.triangles.size();
  soup.face_cell.assign(n, border);
  soup.volume_cell.assign(n, {outside, inside});
  soup.edge_cell.assign(n, {none, none, none});
  soup.everywhere = outside;
  return from(soup, rim == Border::closed);
}

SelectiveComplex simplex(int dimension, std::span<const Vertex> corners, Border rim) {
  if (dimension != 2 && dimension != 3) throw std::invalid_argument("complexes have dimension 2 or 3");
  if (corners.empty() || corners.size() > static_cast<std::size_t>(dimension) + 1)
    throw std::invalid_argument("a simplex has 1 to " + std::to_string(dimension + 1) + " corners");
  require_finite(corners);
  for (const Vertex& p : corners)
    if (dimension == 2 && p[2] != 0) throw std::invalid_argument("a corner in the plane has z other than 0");
  if (!are_independent(corners))
    refuse(DefectKind::degenerate_triangle, corners[0], {}, "the corners of a simplex are not independent");
  return dimension == 3 ? simplex_in_space(corners, rim == Border::closed)
                        : simplex_in_plane(corners, rim == Border::closed);
}

SelectiveComplex unite_closed(const Simplices& simplices) {
  require_finite(simplices.vertices);
  const auto n = static_cast<Index>(simplices.vertices.size());
  const auto require = [&](std::span<const Index> corners, Index number, const char* what) {
    std::vector<Vertex> places;
    for (const Index v : corners) {
      if (v >= n)
        refuse(DefectKind::index_out_of_range, {}, {number}, std::string(what) + " has a corner that there is not");
      places.push_back(simplices.vertices[v]);
    }
    if (!are_independent(places))
      refuse(DefectKind::degenerate_triangle, places[0], {number}, std::string(what) + " has no extent");
  };
  Soup soup;
  soup.mesh.mesh.vertices = simplices.vertices;
  soup.vertex_cell.assign(n, none);
  soup.everywhere = outside;
  for (Index t = 0; t < simplices.triangles.size(); ++t) {
    require(simplices.triangles[t], t, "a triangle");
    for (const Index v : simplices.triangles[t]) soup.vertex_cell[v] = inside;
    add_triangle(soup, simplices.triangles[t], inside, inside, outside);
  }
  for (Index s = 0; s < simplices.segments.size(); ++s) {
    const auto [a, b] = simplices.segments[s];
    require(simplices.segments[s], s, "a segment");
    soup.vertex_cell[a] = soup.vertex_cell[b] = inside;
    add_triangle_at_edge(soup, a, b, inside);
  }
  for (Index p = 0; p < simplices.points.size(); ++p) {
    require(std::span(&simplices.points[p], 1), p, "a point");
    soup.vertex_cell[simplices.points[p]] = inside;
    add_triangle_at_vertex(soup, simplices.points[p]);
  }
  return from(soup, true);
}

SelectiveComplex polygon(std::span<const std::vector<Point2>> loops, Border rim) {
  Drawing drawing;
  drawing.by_parity = true;
  drawing.outside = outside;
  for (const std::vector<Point2>& loop : loops) {
    const auto first = static_cast<Index>(drawing.points.mesh.vertices.size());
    const auto n = static_cast<Index>(loop.size());
    for (Index i = 0; i < n; ++i) {
      drawing.points.mesh.vertices.push_back({loop[i][0], loop[i][1], 0});
      if (loop[i] != loop[(i + 1) % n]) drawing.segments.push_back({first + i, first + (i + 1) % n});
    }
  }
  require_finite(drawing.points.mesh.vertices);
  drawing.vertex_cell.assign(drawing.points.mesh.vertices.size(), none);
  drawing.edge_cell.assign(drawing.segments.size(), border);
  drawing.face_cell.assign(drawing.segments.size(), {outside, outside});
  const SelectiveComplex within = from(drawing, false);
  return rim == Border::closed ? regularized(within) : open_regularized(within);
}

}  // namespace strata::complex
