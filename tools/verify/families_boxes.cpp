#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include "verify/families.h"
#include "verify/json_number.h"

namespace verify {
namespace {

using strata::Mesh;
using strata::Triangle;
using strata::Vertex;
using Cell = std::array<int, 3>;

void add_box(Mesh& mesh, const Vertex& lower, const Vertex& upper) {
  constexpr std::array<Triangle, 12> faces = {{{0, 2, 1},
                                               {0, 3, 2},
                                               {4, 5, 6},
                                               {4, 6, 7},
                                               {0, 1, 5},
                                               {0, 5, 4},
                                               {1, 2, 6},
                                               {1, 6, 5},
                                               {2, 3, 7},
                                               {2, 7, 6},
                                               {3, 0, 4},
                                               {3, 4, 7}}};
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const double z : {lower[2], upper[2]})
    for (const auto& [x, y] : {std::array{lower[0], lower[1]}, std::array{upper[0], lower[1]},
                               std::array{upper[0], upper[1]}, std::array{lower[0], upper[1]}})
      mesh.vertices.push_back({x, y, z});
  for (const Triangle& t : faces) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

Cell counts(const JsonLocation& place) {
  constexpr int most = 400, most_cells = 80'000;
  const std::vector<JsonLocation> items = place.items();
  if (items.size() != 3) place.fail_expected("three integers");
  Cell cell{};
  for (std::size_t i = 0; i < 3; ++i) cell[i] = static_cast<int>(integer(items[i], 1, most));
  const int cells = cell[0] * cell[1] * cell[2];
  if (cells > most_cells) place.fail(fmt::format("at most {} cells, these are {}", most_cells, cells));
  return cell;
}

/// Which cells of a block are filled; false outside of it.
class Pattern {
 public:
  explicit Pattern(const JsonLocation& line) : count_(counts(line.at("count"))) {
    const JsonLocation place = line.at("pattern");
    constexpr std::array makers = {&Pattern::full, &Pattern::checkerboard, &Pattern::menger, &Pattern::holes,
                                   &Pattern::frame};
    filled_ = makers[place.choice("pattern", {"full", "checkerboard", "menger", "holes", "frame"})];
  }

  [[nodiscard]] const Cell& count() const { return count_; }
  [[nodiscard]] bool at(const Cell& c) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (c[i] < 0 || c[i] >= count_[i]) return false;
    return (this->*filled_)(c);
  }

 private:
  [[nodiscard]] bool full(const Cell& /*unused*/) const { return true; }
  [[nodiscard]] bool checkerboard(const Cell& c) const { return (c[0] + c[1] + c[2]) % 2 == 0; }

  /// No two of a cell's digits in base 3, of the same place, are 1.
  [[nodiscard]] bool menger(const Cell& c) const {
    for (Cell d = c; d[0] + d[1] + d[2] > 0; d = {d[0] / 3, d[1] / 3, d[2] / 3})
      if ((d[0] % 3 == 1) + (d[1] % 3 == 1) + (d[2] % 3 == 1) >= 2) return false;
    return true;
  }

  /// Columns along z are left out where x and y are odd.
  [[nodiscard]] bool holes(const Cell& c) const { return c[0] % 2 == 0 || c[1] % 2 == 0; }

  /// Bars along the axes: at least two coordinates are even.
  [[nodiscard]] bool frame(const Cell& c) const { return (c[0] % 2 == 0) + (c[1] % 2 == 0) + (c[2] % 2 == 0) >= 2; }

  Cell count_;
  bool (Pattern::*filled_)(const Cell&) const = nullptr;
};

/// Lattice points as vertices, each once.
class CellMesh {
 public:
  CellMesh(const Vertex& lower, const Vertex& size) : lower_(lower), size_(size) {}

  /// The square of a cell on its side along `axis`, outwards.
  void add_side(Cell p, std::size_t axis, bool upper) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (upper) ++p[axis];
    std::array<Cell, 4> q{p, p, p, p};
    ++q[1][u], ++q[2][u], ++q[2][v], ++q[3][v];
    if (!upper) std::swap(q[1], q[3]);
    const std::array<std::uint32_t, 4> n{number(q[0]), number(q[1]), number(q[2]), number(q[3])};
    mesh_.triangles.push_back({n[0], n[1], n[2]});
    mesh_.triangles.push_back({n[0], n[2], n[3]});
  }

  [[nodiscard]] Mesh take() { return std::move(mesh_); }

 private:
  std::uint32_t number(const Cell& c) {
    const auto [at, is_new] = numbers_.try_emplace(c, static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (is_new)
      mesh_.vertices.push_back({lower_[0] + c[0] * size_[0], lower_[1] + c[1] * size_[1], lower_[2] + c[2] * size_[2]});
    return at->second;
  }

  Vertex lower_, size_;
  std::map<Cell, std::uint32_t> numbers_;
  Mesh mesh_;
};

void for_each_cell(const Cell& count, const std::function<void(const Cell&)>& visit) {
  for (int k = 0; k < count[2]; ++k)
    for (int j = 0; j < count[1]; ++j)
      for (int i = 0; i < count[0]; ++i) visit({i, j, k});
}

}  // namespace

Mesh make_box(const JsonLocation& line) {
  line.expect_keys({"generate", "lower", "upper"});
  Mesh mesh;
  add_box(mesh, point(line.at("lower")), point(line.at("upper")));
  return mesh;
}

Mesh make_boxes(const JsonLocation& line) {
  line.expect_keys({"generate", "boxes"});
  Mesh mesh;
  for (const JsonLocation& place : line.at("boxes").items()) {
    const std::vector<double> b = numbers(place, 6);
    add_box(mesh, {b[0], b[1], b[2]}, {b[3], b[4], b[5]});
  }
  return mesh;
}

Mesh make_grid(const JsonLocation& line) {
  line.expect_keys({"generate", "count", "lower", "pitch", "size"});
  const Vertex lower = point(line.at("lower")), pitch = point(line.at("pitch")), size = point(line.at("size"));
  Mesh mesh;
  for_each_cell(counts(line.at("count")), [&](const Cell& c) {
    Vertex from{}, to{};
    for (std::size_t i = 0; i < 3; ++i) {
      from[i] = lower[i] + c[i] * pitch[i];
      to[i] = from[i] + size[i];
    }
    add_box(mesh, from, to);
  });
  return mesh;
}

Mesh make_cells(const JsonLocation& line) {
  line.expect_keys({"generate", "count", "pattern", "lower", "size"});
  const Pattern pattern(line);
  CellMesh mesh(point(line.at("lower")), point(line.at("size")));
  for_each_cell(pattern.count(), [&](const Cell& c) {
    if (!pattern.at(c)) return;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const bool upper : {false, true}) {
        Cell beside = c;
        beside[axis] += upper ? 1 : -1;
        if (!pattern.at(beside)) mesh.add_side(c, axis, upper);
      }
  });
  return mesh.take();
}

}  // namespace verify
