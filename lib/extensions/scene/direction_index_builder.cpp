#include "extensions/scene/direction_index_builder.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/cells/face_blocks.h"
#include "core/exact/pace.h"
#include "core/kernel/approximation.h"
#include "extensions/scene/closed_face.h"
#include "extensions/scene/scene_data.h"

namespace strata {
namespace {

/// Rectangles are wider than the faces by this many steps of the grid, which is far more than the rounding errors of
/// the grid and of a direction in a query.
constexpr std::int32_t margin = 2;

bool certainly_positive(const Bounded& x) { return x.lower() > 0; }

/// All three corners are certainly beyond one side of the square |u|, |v| <= w, or behind.
bool is_outside(const std::array<ChartVector, 3>& p) {
  const auto all = [&](const auto& value) {
    return std::all_of(p.begin(), p.end(), [&](const ChartVector& c) { return certainly_positive(value(c)); });
  };
  return all([](const ChartVector& c) { return -c[2]; }) || all([](const ChartVector& c) { return c[0] - c[2]; }) ||
         all([](const ChartVector& c) { return -c[0] - c[2]; }) ||
         all([](const ChartVector& c) { return c[1] - c[2]; }) ||
         all([](const ChartVector& c) { return -c[1] - c[2]; });
}

}  // namespace

void DirectionIndexBuilder::build() {
  find_faces_at_origin();
  const auto spans = find_spans();
  index_.charts_.resize(spans.size());
  for (std::size_t c = 0; c < spans.size(); ++c) {
    if (spans[c].empty()) continue;
    lay_grid(index_.charts_[c], spans[c]);
    put_footprints(index_.charts_[c], spans[c]);
    sort_into_squares(c);
  }
}

void DirectionIndexBuilder::find_faces_at_origin() {
  const InputComplex& input = input_complex_of(scene_);
  at_origin_.assign(input.face_count(), false);
  if (!origin_.is_point()) return;
  const Point o = Point::free(origin_.at);
  Pace pace(monitor_);
  for (std::uint32_t f = 0; f < input.face_count(); ++f) {
    pace.step();
    if (is_on_closed_face(input, f, o)) {
      at_origin_[f] = true;
      index_.at_origin_.push_back(f);
    }
  }
}

/// The spans per chart, by increasing face.
std::vector<std::vector<DirectionIndexBuilder::Span>> DirectionIndexBuilder::find_spans() const {
  const std::size_t charts = index_.charts_of_.count();
  const InputComplex& input = input_complex_of(scene_);
  const auto blocks = face_blocks(input);
  std::vector<std::vector<std::vector<Span>>> parts(blocks.size(), std::vector<std::vector<Span>>(charts));
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
    const std::uint32_t first = input.first_face(blocks[b].operand);
    Pace pace(monitor_);
    for (std::uint32_t f = first + blocks[b].first; f < first + blocks[b].last; ++f) {
      pace.step();
      for (std::size_t c = 0; c < charts && !at_origin_[f]; ++c)
        if (const auto span = span_in(c, f)) parts[b][c].push_back(*span);
    }
  });
  std::vector<std::vector<Span>> all(charts);
  for (std::size_t c = 0; c < charts; ++c)
    for (const auto& part : parts) all[c].insert(all[c].end(), part[c].begin(), part[c].end());
  return all;
}

std::array<ChartVector, 3> DirectionIndexBuilder::corners(std::size_t chart, std::uint32_t face) const {
  const auto v = input_complex_of(scene_).face(face);
  std::array<ChartVector, 3> p;
  for (std::size_t i = 0; i < 3; ++i)
    p[i] = index_.charts_of_.at(chart, approximate_vertex<Bounded>(input_complex_of(scene_), v[i]));
  return p;
}

/// The least depth of the corners, rounded down.
float DirectionIndexBuilder::nearest(std::size_t chart, std::uint32_t face) const {
  double least = HUGE_VAL;
  for (const std::uint32_t v : input_complex_of(scene_).face(face)) {
    const double depth =
        index_.charts_of_.depth(chart, approximate_vertex<Bounded>(input_complex_of(scene_), v)).lower();
    least = std::isfinite(depth) ? std::min(least, depth) : -HUGE_VAL;
  }
  constexpr float low = -std::numeric_limits<float>::infinity();
  constexpr double most = 1e38;  // of a float
  return least < -most ? low : std::nextafter(static_cast<float>(std::min(least, most)), low);
}

std::optional<DirectionIndexBuilder::Span> DirectionIndexBuilder::span_in(std::size_t chart, std::uint32_t face) const {
  const auto p = corners(chart, face);
  const bool bounded = index_.charts_of_.is_bounded();
  if (bounded && is_outside(p)) return std::nullopt;
  constexpr double most = std::numeric_limits<double>::max();
  const double rim = bounded ? 1 : most;
  Span s{face, {-rim, -rim}, {rim, rim}, true, nearest(chart, face)};
  if (!std::all_of(p.begin(), p.end(), [](const ChartVector& c) { return certainly_positive(c[2]); })) return s;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    std::array<double, 3> low, high;
    for (std::size_t i = 0; i < 3; ++i) {
      const Bounded u = p[i][axis] / p[i][2];
      low[i] = u.lower();
      high[i] = u.upper();
      if (!std::isfinite(low[i]) || !std::isfinite(high[i])) return s;
    }
    s.lower[axis] = *std::min_element(low.begin(), low.end());
    s.upper[axis] = *std::max_element(high.begin(), high.end());
    if (bounded) {
      s.lower[axis] = std::max(s.lower[axis], -1.0);
      s.upper[axis] = std::min(s.upper[axis], 1.0);
    }
  }
  s.is_whole = false;
  return s;
}

/// About one square per face.
std::int32_t DirectionIndexBuilder::bits_for(std::size_t faces) {
  std::int32_t bits = 0;
  while (bits < 11 && (std::size_t{1} << (2 * bits + 2)) <= faces) ++bits;
  return bits;
}

/// Lays the grid over the rectangle that contains all faces, which is the whole domain where the extent of one is not
/// known. Directions beyond it, which meet no face, are rounded to it.
void DirectionIndexBuilder::lay_grid(Chart& chart, const std::vector<Span>& spans) const {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Span& s : spans) {
      low = std::min(low, s.lower[axis]);
      high = std::max(high, s.upper[axis]);
    }
    chart.lower[axis] = low;
    const double extent = high - low;
    const double scale = static_cast<double>(1 << DirectionIndex::grid_bits) / extent;
    chart.scale[axis] = std::isfinite(scale) && std::isfinite(extent) && scale > 0 ? scale : 0;
  }
  chart.bits = bits_for(spans.size());
}

void DirectionIndexBuilder::put_footprints(Chart& chart, const std::vector<Span>& spans) {
  constexpr std::int32_t end = (1 << DirectionIndex::grid_bits) - 1;
  const std::int32_t square = 1 << (DirectionIndex::grid_bits - chart.bits);
  chart.footprints.resize(spans.size());
  tbb::parallel_for(std::size_t{0}, spans.size(), [&](std::size_t i) {
    const Span& s = spans[i];
    Footprint f{s.face, {0, 0}, {end, end}, s.is_whole, s.near};
    if (!s.is_whole)
      for (std::size_t axis = 0; axis < 2; ++axis) {
        f.lower[axis] = std::max(chart.grid(axis, s.lower[axis]) - margin, 0);
        f.upper[axis] = std::min(chart.grid(axis, s.upper[axis]) + margin, end);
        f.is_large = f.is_large || (f.upper[axis] - f.lower[axis]) / 4 > square;
      }
    chart.footprints[i] = f;
  });
}

namespace {

/// Calls `visit(square number)` for the squares of the grid that the rectangle of a footprint meets.
template <class Visit>
void for_each_square(const Footprint& f, std::int32_t bits, std::int32_t shift, const Visit& visit) {
  for (std::int32_t j = f.lower[1] >> shift; j <= f.upper[1] >> shift; ++j)
    for (std::int32_t i = f.lower[0] >> shift; i <= f.upper[0] >> shift; ++i)
      visit((static_cast<std::size_t>(j) << bits) + static_cast<std::size_t>(i));
}

}  // namespace

/// A counting sort distributes the footprints to the squares of the grid. Then squares are subdivided in runs, in
/// parallel, and the runs are concatenated in order.
void DirectionIndexBuilder::sort_into_squares(std::size_t c) const {
  Chart& chart = index_.charts_[c];
  const std::int32_t bits = chart.bits, shift = DirectionIndex::grid_bits - bits;
  const std::size_t row = std::size_t{1} << bits, squares = row * row;
  const auto square_of = [&](std::size_t n) {
    return ChartSquare{{static_cast<std::int32_t>(n % row) << shift, static_cast<std::int32_t>(n / row) << shift},
                       1 << shift};
  };
  Pace pace(monitor_);
  const auto for_each_entry = [&](const auto& visit) {
    for (std::uint32_t i = 0; i < chart.footprints.size(); ++i) {
      pace.step();
      const Footprint& f = chart.footprints[i];
      for_each_square(f, bits, shift, [&](std::size_t n) {
        if (!f.is_large || reaches(c, f, square_of(n))) visit(n, i);
      });
    }
  };
  std::vector<std::uint32_t> first(squares + 1, 0);
  for_each_entry([&](std::size_t n, std::uint32_t) { ++first[n + 1]; });
  for (std::size_t n = 0; n < squares; ++n) first[n + 1] += first[n];
  std::vector<std::uint32_t> sorted(first[squares]), next(first.begin(), first.end() - 1);
  for_each_entry([&](std::size_t n, std::uint32_t i) { sorted[next[n]++] = i; });

  const std::size_t parts_count = std::min<std::size_t>(row, 64);
  std::vector<Part> parts(parts_count);
  tbb::parallel_for(std::size_t{0}, parts_count, [&](std::size_t p) {
    const std::size_t begin = squares * p / parts_count, end = squares * (p + 1) / parts_count;
    parts[p].nodes.resize(end - begin);
    std::deque<Square> roots;
    for (std::size_t n = begin; n < end; ++n)
      roots.push_back({square_of(n), n - begin, {sorted.begin() + first[n], sorted.begin() + first[n + 1]}});
    refine(c, std::move(roots), parts[p]);
  });
  // Roots first, then each part's inner nodes.
  chart.nodes.resize(squares);
  for (std::size_t p = 0; p < parts_count; ++p) {
    const std::size_t begin = squares * p / parts_count, roots = squares * (p + 1) / parts_count - begin;
    const auto inner = static_cast<std::uint32_t>(chart.nodes.size() - roots);
    const auto entries = static_cast<std::uint32_t>(chart.entry_footprints.size());
    for (std::size_t n = 0; n < parts[p].nodes.size(); ++n) {
      Node node = parts[p].nodes[n];
      node.first += node.count == DirectionIndex::is_inner ? inner : entries;
      if (n < roots) {
        chart.nodes[begin + n] = node;
      } else {
        chart.nodes.push_back(node);
      }
    }
    chart.entry_footprints.insert(chart.entry_footprints.end(), parts[p].entries.begin(), parts[p].entries.end());
    parts[p] = {};
  }
  chart.entries.reserve(chart.entry_footprints.size());
  for (const std::uint32_t e : chart.entry_footprints) {
    const Footprint& f = chart.footprints[e];
    chart.entries.push_back({f.face, f.near, f.lower, f.upper});
  }
}

/// Subdivides squares, the large ones first, while this shortens their lists and all lists together remain in
/// proportion to the initial ones. Faces that are stacked along a line or in a point could be subdivided without end.
void DirectionIndexBuilder::refine(std::size_t c, std::deque<Square> squares, Part& part) const {
  constexpr std::size_t few = 14, growth = 12;
  std::size_t total = 0;
  for (const Square& s : squares) total += s.entries.size();
  const std::size_t most = growth * total;
  for (; !squares.empty(); squares.pop_front()) {
    monitor_.check();
    Square& s = squares.front();
    if (s.entries.size() > few && s.place.side > 8 * margin && total < most) {
      auto quarters = quarter(c, s.place, s.entries);
      std::size_t sum = 0;
      for (const auto& q : quarters) sum += q.size();
      if (sum * 10 <= s.entries.size() * 28) {  // 70 percent in each
        total += sum - s.entries.size();
        const std::size_t first = part.nodes.size();
        part.nodes[s.node] = {static_cast<std::uint32_t>(first), DirectionIndex::is_inner};
        part.nodes.resize(first + 4);
        for (std::size_t i = 0; i < 4; ++i)
          squares.push_back({quarter_of(s.place, i), first + i, std::move(quarters[i])});
        continue;
      }
    }
    part.nodes[s.node] = {static_cast<std::uint32_t>(part.entries.size()),
                          static_cast<std::uint32_t>(s.entries.size())};
    part.entries.insert(part.entries.end(), s.entries.begin(), s.entries.end());
  }
}

std::array<std::vector<std::uint32_t>, 4> DirectionIndexBuilder::quarter(std::size_t c, const ChartSquare& square,
                                                                         std::span<const std::uint32_t> entries) const {
  std::array<std::vector<std::uint32_t>, 4> quarters;
  for (std::size_t i = 0; i < 4; ++i)
    for (const std::uint32_t e : entries)
      if (reaches(c, index_.charts_[c].footprints[e], quarter_of(square, i))) quarters[i].push_back(e);
  return quarters;
}

bool DirectionIndexBuilder::reaches(std::size_t c, const Footprint& f, const ChartSquare& square) const {
  for (std::size_t axis = 0; axis < 2; ++axis)
    if (f.upper[axis] < square.lower[axis] || f.lower[axis] - square.lower[axis] >= square.side) return false;
  return !f.is_large || sees(c, f.face, square);
}

/// False only if the square certainly lies beyond an edge of the face, or the face beyond a side of the square, as seen
/// in the chart.
bool DirectionIndexBuilder::sees(std::size_t c, std::uint32_t face, const ChartSquare& square) const {
  const Chart& chart = index_.charts_[c];
  std::array<double, 2> low, high;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (chart.scale[axis] == 0) return true;
    low[axis] = chart.lower[axis] + (square.lower[axis] - margin) / chart.scale[axis];
    high[axis] = chart.lower[axis] + (square.lower[axis] + square.side + margin) / chart.scale[axis];
  }
  const auto p = corners(c, face);
  const auto all_corners = [&](const auto& value) {
    return std::all_of(p.begin(), p.end(), [&](const ChartVector& v) { return certainly_positive(value(v)); });
  };
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (all_corners([&](const ChartVector& v) { return Bounded(low[axis]) * v[2] - v[axis]; })) return false;
    if (all_corners([&](const ChartVector& v) { return v[axis] - Bounded(high[axis]) * v[2]; })) return false;
  }
  const Bounded area = dot<Bounded>(cross<Bounded>(p[0], p[1]), p[2]);
  const auto orientation = area.sign();
  if (!orientation || *orientation == Sign::zero) return true;
  for (std::size_t i = 0; i < 3; ++i) {
    const ChartVector line = cross<Bounded>(p[i], p[(i + 1) % 3]);
    bool beyond = true;
    for (const double u : {low[0], high[0]})
      for (const double v : {low[1], high[1]}) {
        const Bounded value = line[0] * Bounded(u) + line[1] * Bounded(v) + line[2];
        beyond = beyond && certainly_positive(*orientation == Sign::positive ? -value : value);
      }
    if (beyond) return false;
  }
  return true;
}

}  // namespace strata
