#include "core/winding/ray_windings.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/containers/collect.h"
#include "core/containers/huge_pages.h"
#include "core/containers/point_bounds.h"
#include "core/kernel/face_box.h"
#include "core/kernel/predicates.h"
#include "core/kernel/ray_crossing.h"

namespace strata {
namespace {

constexpr int many_cells = 16;

/// Rectangles of columns, by squares of them: a bit each.
class CoarseGrid {
 public:
  using Corner = std::array<std::uint16_t, 2>;

  /// Of so many columns in a row.
  explicit CoarseGrid(std::uint32_t width) {
    while (((width - 1) >> shift_) >= squares) ++shift_;
  }
  void mark(const Corner& lower, const Corner& upper) {
    for (unsigned z = row(lower); z <= row(upper); ++z) rows_[z] |= bits(lower, upper);
  }
  /// False only where no marked rectangle has a column of this one.
  [[nodiscard]] bool meets(const Corner& lower, const Corner& upper) const {
    std::uint64_t marked = 0;
    for (unsigned z = row(lower); z <= row(upper); ++z) marked |= rows_[z];
    return (marked & bits(lower, upper)) != 0;
  }

 private:
  static constexpr unsigned squares = 64;  // in a row
  [[nodiscard]] unsigned row(const Corner& at) const { return static_cast<unsigned>(at[1]) >> shift_; }
  [[nodiscard]] std::uint64_t bits(const Corner& lower, const Corner& upper) const {
    const unsigned first = static_cast<unsigned>(lower[0]) >> shift_, last = static_cast<unsigned>(upper[0]) >> shift_;
    return (~std::uint64_t{0} >> (squares - 1 - (last - first))) << first;
  }

  unsigned shift_ = 0;
  std::array<std::uint64_t, squares> rows_{};
};

/// The side of a face's plane to which the ray's start counts as moved, or along which the ray runs.
Sign side_of_ray(const InputComplex& input, std::uint32_t face) {
  for (int axis = 0; axis < 3; ++axis)
    if (const Sign s = normal_component(input, face, axis); s != Sign::zero) return s;
  return Sign::zero;
}

/// True for some of the faces that are parallel to the rays: none of these meets them.
bool is_seen_from_edge(const InputComplex& input, std::uint32_t face) {
  const InputComplex::Indices& v = input.faces(0)[face];
  const auto points = input.points(0);
  const auto are_equal = [&](std::size_t i) {
    return points[v[0]][i] == points[v[1]][i] && points[v[1]][i] == points[v[2]][i];
  };
  return (are_equal(1) || are_equal(2)) && input.has_doubles(v);
}

/// True only where the box of a triangle with these corners does not meet another one.
bool is_beside_box(const std::array<const InputComplex::Coordinates*, 3>& corners, const Box& box) {
  const auto& [a, b, c] = corners;
  for (const std::size_t i : {1, 2, 0}) {  // rays run along x
    const double x = (*a)[i], y = (*b)[i], z = (*c)[i];
    if ((x > box.upper[i] && y > box.upper[i] && z > box.upper[i]) ||
        (x < box.lower[i] && y < box.lower[i] && z < box.lower[i]))
      return true;
  }
  return false;
}

}  // namespace

/// The columns of the faces' boxes.
class RayWindings::FaceCells {
 public:
  explicit FaceCells(const RayWindings& rays) : faces_(rays.input_.faces(0)) {
    resize_fresh(of_vertex_, rays.input_.vertex_count());
    tbb::parallel_for(std::size_t{0}, of_vertex_.size(),
                      [&](std::size_t v) { of_vertex_[v] = rays.cells_of(static_cast<std::uint32_t>(v)); });
  }
  [[nodiscard]] Cells operator()(std::uint32_t face) const {
    const InputComplex::Indices& t = faces_[face];
    Cells cells = of_vertex_[t[0]];
    for (const std::uint32_t v : {t[1], t[2]})
      for (std::size_t i = 0; i < 2; ++i) {
        cells.lower[i] = std::min(cells.lower[i], of_vertex_[v].lower[i]);
        cells.upper[i] = std::max(cells.upper[i], of_vertex_[v].upper[i]);
      }
    return cells;
  }

 private:
  std::span<const InputComplex::Indices> faces_;
  std::vector<Cells> of_vertex_;
};

RayWindings::RayWindings(const InputComplex& input, std::span<const std::uint32_t> asked) : input_(input) {
  const std::uint32_t count = input.face_count();
  const Box bounds = bounds_of_finite(input.points(0));
  width_ = std::clamp<std::uint32_t>(static_cast<std::uint32_t>(std::sqrt(count) / 2), 1, most_columns);
  for (std::size_t i = 0; i < 2; ++i) {
    origin_[i] = bounds.lower[i + 1];
    const double cells = width_ / 2.0 / (bounds.upper[i + 1] / 2 - bounds.lower[i + 1] / 2);
    per_cell_[i] = cells > 0 && cells < Box::infinity ? cells : 0;
  }
  const FaceCells cells_of_face(*this);
  list(choose_columns(asked, cells_of_face), cells_of_face);
  comparisons_ = estimate(asked, cells_of_face);
}

/// Chooses the columns that are made, and returns the faces that may be in them.
std::vector<std::uint32_t> RayWindings::choose_columns(std::span<const std::uint32_t> asked,
                                                       const FaceCells& cells_of_face) {
  is_made_.resize(std::size_t{width_} * width_);
  CoarseGrid near_made(width_);
  for (const std::uint32_t f : asked) {
    const Cells cells = cells_of_face(f);
    near_made.mark(cells.lower, cells.upper);
    for (std::uint32_t z = cells.lower[1]; z <= cells.upper[1]; ++z)
      std::fill_n(is_made_.begin() + z * width_ + cells.lower[0], cells.upper[0] - cells.lower[0] + 1, char{1});
  }
  return collect(input_.face_count(), [&](std::uint32_t f) {
    const Cells cells = cells_of_face(f);
    if (!near_made.meets(cells.lower, cells.upper) || is_seen_from_edge(input_, f)) return false;
    bool is_near = false;
    const bool is_narrow =
        for_each_column(cells, [&](std::uint32_t column) { is_near = is_near || is_made_[column] != 0; });
    return !is_narrow || is_near;
  });
}

void RayWindings::list(std::span<const std::uint32_t> faces, const FaceCells& cells_of_face) {
  first_.assign(is_made_.size() + 1, 0);
  std::vector<std::uint32_t> wide;
  for (const std::uint32_t f : faces)
    if (const Cells cells = cells_of_face(f);
        !for_each_column(cells, [&](std::uint32_t column) { ++first_[column + 1]; })) {
      wide.push_back(f);
      wide_near_ray_ += column_count(cells) / static_cast<double>(is_made_.size());
    }
  wide_ = BoxTree::by_order(std::move(wide), [&](std::span<const std::uint32_t> some) {
    Box box;
    for (const std::uint32_t f : some) box.include(face_box(input_, f));
    return box;
  });
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  resize_fresh(faces_, first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (const std::uint32_t f : faces)
    for_each_column(cells_of_face(f), [&](std::uint32_t column) { faces_[next[column]++] = f; });
}

std::size_t RayWindings::estimate(std::span<const std::uint32_t> asked, const FaceCells& cells_of_face) const {
  const double on_average = static_cast<double>(faces_.size()) / static_cast<double>(is_made_.size());
  double comparisons = 0;
  for (const std::uint32_t f : asked) {
    const Cells cells = cells_of_face(f);
    double listed_there = 0;
    const bool is_narrow =
        for_each_column(cells, [&](std::uint32_t column) { listed_there += first_[column + 1] - first_[column]; });
    comparisons += wide_near_ray_ + (is_narrow ? listed_there / column_count(cells) : on_average);
  }
  return static_cast<std::size_t>(comparisons);
}

RayWindings::Cells RayWindings::cells_of(std::uint32_t vertex) const {
  const double y = input_.points(0)[vertex][1], z = input_.points(0)[vertex][2];
  if (input_.has_doubles(vertex)) return cells_of(y, y, z, z);
  constexpr double far = Box::infinity;
  return cells_of(std::nextafter(y, -far), std::nextafter(y, far), std::nextafter(z, -far), std::nextafter(z, far));
}

int RayWindings::column_count(const Cells& cells) {
  return (cells.upper[0] - cells.lower[0] + 1) * (cells.upper[1] - cells.lower[1] + 1);
}

template <class Visit>
bool RayWindings::for_each_column(const Cells& cells, const Visit& visit) const {
  if (column_count(cells) > many_cells) return false;
  for_each_column_of(cells, visit);
  return true;
}

template <class Visit>
void RayWindings::for_each_column_of(const Cells& cells, const Visit& visit) const {
  for (std::uint32_t z = cells.lower[1]; z <= cells.upper[1]; ++z)
    for (std::uint32_t y = cells.lower[0]; y <= cells.upper[0]; ++y) visit(z * width_ + y);
}

/// Monotone, so boxes that meet have a column in common.
RayWindings::Cells RayWindings::cells_of(double low_y, double high_y, double low_z, double high_z) const {
  const auto cell = [&](double x, std::size_t i) {
    const double at = (x - origin_[i]) * per_cell_[i];
    return static_cast<std::uint16_t>(at > 0 ? std::min(at, width_ - 1.0) : 0);
  };
  return {{cell(low_y, 0), cell(low_z, 1)}, {cell(high_y, 0), cell(high_z, 1)}};
}

std::int32_t RayWindings::crossings(const Point& q) const {
  Box at;
  for (std::size_t i = 0; i < 3; ++i) {
    at.lower[i] = q.at[i].lower();
    at.upper[i] = q.at[i].upper();
  }
  at.upper[0] = Box::infinity;
  std::int32_t sum = 0;
  const auto points = input_.points(0);
  const auto count = [&](std::uint32_t face) {
    const auto vertices = input_.face(face);
    if (input_.has_doubles(vertices)) {
      const auto& [a, b, c] = vertices;
      const std::array corners{&points[a], &points[b], &points[c]};
      if (is_beside_box(corners, at)) return;
      if (const std::optional<int> winding = winding_along_x(corners, q.at)) {
        sum += crossing_along_x(input_, face, *winding, q);
        return;
      }
    } else if (!face_box(input_, face).overlaps(at)) {
      return;
    }
    std::array<Point, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = make_point(input_, SymbolicPoint::input(vertices[i]));
    sum += crossing_along_x(input_, face, corners, q);
  };
  std::vector<std::uint32_t> columns;
  for_each_column_of(cells_of(at.lower[1], at.upper[1], at.lower[2], at.upper[2]),
                     [&](std::uint32_t column) { columns.push_back(column); });
  if (!std::all_of(columns.begin(), columns.end(), [&](std::uint32_t column) { return is_made_[column] != 0; })) {
    for (std::uint32_t f = 0; f < input_.face_count(); ++f) count(f);
    return sum;
  }
  wide_.for_each_near(at, [&](std::uint32_t face) {
    count(face);
    return true;
  });
  std::vector<std::uint32_t> near;
  for (const std::uint32_t column : columns)
    near.insert(near.end(), faces_.begin() + first_[column], faces_.begin() + first_[column + 1]);
  if (columns.size() > 1) std::sort(near.begin(), near.end());  // a face may be in several columns
  near.erase(std::unique(near.begin(), near.end()), near.end());
  for (const std::uint32_t f : near) count(f);
  return sum;
}

Windings RayWindings::around(const Point& q, std::uint32_t own) const {
  Windings w;
  if (own != 0) w.add(0, crossings(q));
  return w;
}

/// The ray starts at q, moved by an infinitesimal distance across x. If its plane is parallel to the ray, that is
/// beside the face, on the side which y or else z tells; if not, the ray starts above or below the face at will, and
/// from above is what is asked for. From below it would go through the covering faces, which `crossings` leaves out.
Windings RayWindings::above(std::uint32_t face, const Point& q, std::span<const std::uint32_t> covering) const {
  Windings w;
  w.add(0, crossings(q));
  if (side_of_ray(input_, face) == Sign::positive) return w;
  for (const std::uint32_t g : covering) w.add(0, -to_int(same_orientation(input_, face, g)));
  return w;
}

}  // namespace strata
