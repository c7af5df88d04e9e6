// Complexes beside CGAL's Nef polyhedra of the plane and of space: the same cells, with the same marks.
#include "strata/complex.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <random>
#include <string>

#include "extensions/complex/operands.h"
#include "oracle/isolated.h"
#include "oracle/nef.h"
#include "oracle/nef_complex.h"
#include "strata/errors.h"

namespace strata::oracle {
namespace {

using complex::Border;
using complex::Cell;
using complex::SelectiveComplex;

/// The same set both ways.
template <int D>
struct Both {
  SelectiveComplex ours;
  NefComplex<D> nef;
  /// Membership by the formula over simplices alone, without any overlay; unknown for results of operators.
  std::function<bool(const RationalPoint&)> is_in = nullptr;
};

RationalPoint middle(const std::vector<RationalPoint>& points) {
  RationalPoint sum;
  for (const RationalPoint& p : points)
    for (std::size_t i = 0; i < 3; ++i) sum[i] += p[i] / static_cast<unsigned>(points.size());
  return sum;
}

/// A point of each cell that is no vertex and not unbounded.
std::vector<std::pair<Cell, RationalPoint>> samples(const SelectiveComplex& s) {
  std::vector<std::pair<Cell, RationalPoint>> result;
  const complex::Cells& cells = s.cells();
  for (std::uint32_t v = 0; v < s.count(0); ++v) result.push_back({{0, v}, cells.position(v)});
  for (std::uint32_t e = 0; e < s.count(1); ++e)
    result.push_back({{1, e}, middle({cells.position(cells.edges[e][0]), cells.position(cells.edges[e][1])})});
  // Beside a triangle of a face, or an edge in the plane, are the cells of full dimension.
  const auto beside = [&](RationalPoint p, RationalPoint d, Cell wanted) {
    for (;; d = {d[0] / 2, d[1] / 2, d[2] / 2})
      for (const int sign : {1, -1})
        if (const RationalPoint q{p[0] + sign * d[0], p[1] + sign * d[1], p[2] + sign * d[2]};
            complex::locate(s, q) == wanted) {
          result.emplace_back(wanted, q);
          return;
        }
  };
  if (s.dimension() == 2) {
    std::vector<bool> known(s.count(2), false);
    for (const complex::Wing& w : cells.wings) {
      if (known[w.face]) continue;
      known[w.face] = true;
      const RationalPoint a = cells.position(cells.edges[w.edge][0]), b = cells.position(cells.edges[w.edge][1]);
      beside(middle({a, b}), {a[1] - b[1], b[0] - a[0], 0}, {2, w.face});
    }
    return result;
  }
  const complex::Soup soup = complex::soup_of(cells);
  const std::uint32_t first_face = cells.count(0) + cells.count(1);
  std::vector<bool> known_face(s.count(2), false), known_volume(s.count(3), false);
  for (std::size_t t = 0; t < soup.face_cell.size(); ++t) {
    if (soup.face_cell[t] == complex::none || known_face[soup.face_cell[t] - first_face]) continue;
    const std::uint32_t f = soup.face_cell[t] - first_face;
    known_face[f] = true;
    const auto& v = soup.mesh.mesh.triangles[t];
    const RationalPoint a = soup.mesh.position(v[0]), b = soup.mesh.position(v[1]), c = soup.mesh.position(v[2]);
    result.push_back({{2, f}, middle({a, b, c})});
    const RationalPoint u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, w{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const RationalPoint n{u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]};
    for (const std::uint32_t volume : cells.sides[f])
      if (!known_volume[volume]) {
        known_volume[volume] = true;
        beside(middle({a, b, c}), n, {3, volume});
      }
  }
  return result;
}

/// What tells the two apart, or nothing: as many cells of each dimension, the same vertices, and a point of each of our
/// cells in both sets or in neither.
template <int D>
std::string difference(const Both<D>& s) {
  for (const auto& [cell, point] : samples(s.ours)) {
    const std::string where = std::to_string(cell.dimension) + ":" + std::to_string(cell.index);
    if (complex::locate(s.ours, point) != cell) return "our cell " + where + " is not where it is";
    if (s.is_in && s.is_in(point) != s.ours.mark(cell)) return "our mark of " + where + " is wrong";
    if (s.nef.contains(point) != s.ours.mark(cell)) return "marks of " + where + " differ";
  }
  const auto counts = s.nef.counts();
  for (int d = 0; d <= D; ++d)
    if (counts[static_cast<std::size_t>(d)] != s.ours.count(d)) return "cells of dimension " + std::to_string(d);
  std::vector<RationalPoint> vertices = s.nef.vertices();
  std::sort(vertices.begin(), vertices.end());
  for (std::uint32_t v = 0; v < s.ours.count(0); ++v)
    if (vertices[v] != s.ours.cells().position(v)) return "vertex " + std::to_string(v);
  return {};
}

/// Ways to the same set: CGAL 5.5 sometimes crashes or answers wrongly on one of them.
enum class Way { as_said, by_complements, by_parts };

template <int D>
class RandomPairs {
 public:
  RandomPairs(std::uint32_t seed, Way way) : random_(seed), way_(way) {}

  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }

  Both<D> simplex() {
    while (true) {
      std::vector<Vertex> corners(1 + static_cast<std::size_t>(below(D + 1)));
      for (Vertex& c : corners) c = {1. * below(4), 1. * below(4), D == 2 ? 0. : 1. * below(4)};
      const bool closed = below(2) == 0;
      try {
        const SelectiveComplex ours = complex::simplex(D, corners, closed ? Border::closed : Border::open);
        return {ours, NefComplex<D>::simplex(corners, closed),
                [ours](const RationalPoint& p) { return complex::contains(ours, p); }};
      } catch (const InputError&) {  // not independent
      }
    }
  }

  Both<D> next(int simplices) {
    Both<D> s = simplex();
    for (int i = 1; i < simplices; ++i) {
      const Both<D> t = simplex();
      switch (below(5)) {
        case 0:
        case 1:
          s = {s.ours | t.ours, united(s.nef, t.nef),
               [f = s.is_in, g = t.is_in](const auto& p) { return f(p) || g(p); }};
          break;
        case 2:
          s = {s.ours ^ t.ours, excluded(s.nef, t.nef),
               [f = s.is_in, g = t.is_in](const auto& p) { return f(p) != g(p); }};
          break;
        case 3:
          s = {s.ours - t.ours, subtracted(s.nef, t.nef),
               [f = s.is_in, g = t.is_in](const auto& p) { return f(p) && !g(p); }};
          break;
        default:
          s = {~s.ours & t.ours, subtracted(t.nef, s.nef),
               [f = s.is_in, g = t.is_in](const auto& p) { return !f(p) && g(p); }};
      }
    }
    if (below(5) == 0) s = {~s.ours, s.nef.complement(), [f = s.is_in](const auto& p) { return !f(p); }};
    return s;
  }

 private:
  using N = NefComplex<D>;
  N united(const N& a, const N& b) const {
    if (way_ == Way::as_said) return a.unite(b);
    if (way_ == Way::by_parts) return b.subtract(a).unite(a);
    return a.complement().intersect(b.complement()).complement();
  }
  N excluded(const N& a, const N& b) const {
    return way_ == Way::as_said ? a.exclude(b) : united(subtracted(b, a), subtracted(a, b));
  }
  N subtracted(const N& a, const N& b) const {
    if (way_ == Way::as_said) return a.subtract(b);
    if (way_ == Way::by_parts) return a.exclude(a.intersect(b));
    return a.complement().unite(b).complement();
  }

  std::mt19937 random_;
  Way way_;
};

/// Of a random set, its complement and what operators make of it.
template <int D>
std::string differences(std::uint32_t seed, Way way) {
  RandomPairs<D> random(seed, way);
  const Both<D> s = random.next(3 + random.below(2));
  const std::vector<std::pair<const char*, Both<D>>> sets{
      {"the set", s},
      {"complement", {~s.ours, s.nef.complement()}},
      {"interior", {interior(s.ours), s.nef.interior()}},
      {"closure", {closure(s.ours), s.nef.closure()}},
      {"boundary", {boundary(s.ours), s.nef.boundary()}},
      {"regularization", {regularized(s.ours), s.nef.regularization()}}};
  std::string text;
  for (const auto& [name, both] : sets)
    if (const std::string found = difference<D>(both); !found.empty()) text += std::string(name) + ": " + found + "; ";
  return text;
}

/// Equal when CGAL agrees by one of the ways. Crashes and contradictions on all of them are no answer, of which there
/// must be few.
template <int D>
void compare(std::uint32_t first, std::uint32_t last) {
  std::uint32_t failed = 0, failed_once = 0;
  for (std::uint32_t seed = first; seed < last; ++seed) {
    CAPTURE(D, seed);
    std::string text, errors;
    bool is_equal = false;
    for (const Way way : {Way::as_said, Way::by_complements, Way::by_parts}) {
      try {
        const std::string found = in_child([&] { return differences<D>(seed, way); });
        is_equal = found.empty();
        text += found;
      } catch (const OracleFailed& error) {
        errors += error.what();
      }
      if (is_equal) break;
      ++failed_once;
    }
    if (!is_equal) {
      CAPTURE(text, errors);
      CHECK(text.empty());
      ++failed;
    }
  }
  if (failed_once > 0)
    WARN("of " << last - first << " complexes CGAL failed on " << failed << " by all ways, and " << failed_once
               << " times by one");
  CHECK(failed <= 1 + (last - first) / 100);
}

}  // namespace

TEST_CASE("complexes of the plane are CGAL's", "[oracle][complex]") { compare<2>(0, 100); }
TEST_CASE("complexes of space are CGAL's", "[oracle][complex]") { compare<3>(0, 20); }
TEST_CASE("a thousand complexes of the plane are CGAL's", "[oracle][complex][slow]") { compare<2>(100, 1000); }
TEST_CASE("a thousand complexes of space are CGAL's", "[oracle][complex][slow]") { compare<3>(20, 1000); }

}  // namespace strata::oracle
