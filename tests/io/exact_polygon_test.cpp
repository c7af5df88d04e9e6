// Faces with holes in triangles: the triangles are counter-clockwise, their boundary is that of the face, and none lies
// on another. Together that says that they are the face.
#include "core/io/exact_polygon.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <random>
#include <set>

using namespace strata;
using io::LoopFace;

namespace {

using Flat = std::array<Rational, 2>;
using Loops = std::vector<std::vector<std::uint32_t>>;

Rational double_area(const Flat& a, const Flat& b, const Flat& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

LoopFace face_of(const Loops& loops) {
  LoopFace face;
  for (const auto& loop : loops) {
    face.corners.insert(face.corners.end(), loop.begin(), loop.end());
    face.ends.push_back(face.corners.size());
  }
  return face;
}

/// Points of a plane in space, exactly: no coordinate of it is a double for most.
struct Embedded {
  std::vector<Vertex> rounded;
  std::vector<ExactVertex> exact;

  [[nodiscard]] io::ExactVertices vertices() const { return {rounded, exact}; }
};

Embedded embedded(const std::vector<Flat>& points, unsigned kind) {
  const Rational third = Rational(1) / 3, big = Rational(Integer("1234567890123456789012345678901"), 7);
  const std::array<Rational, 3> origin{third, -2, kind == 0 ? 0 : big};
  const std::array<std::array<Rational, 3>, 3> u{{{1, 0, 0}, {third, 2, big}, {0, third, 1}}},
      v{{{0, 1, 0}, {-1, big, third}, {0, 0, big}}};
  Embedded result;
  for (const Flat& p : points) {
    RationalPoint q;
    for (std::size_t i = 0; i < 3; ++i) q[i] = (kind == 0 ? 0 : origin[i]) + p[0] * u[kind][i] + p[1] * v[kind][i];
    const Vertex r{to_nearest_double(q[0]), to_nearest_double(q[1]), to_nearest_double(q[2])};
    if (to_rational(r[0]) != q[0] || to_rational(r[1]) != q[1] || to_rational(r[2]) != q[2])
      result.exact.push_back({static_cast<std::uint32_t>(result.rounded.size()), q});
    result.rounded.push_back(r);
  }
  return result;
}

using Chain = std::map<std::pair<std::uint32_t, std::uint32_t>, int>;

void add_side(Chain& chain, std::uint32_t a, std::uint32_t b) {
  const auto key = std::minmax(a, b);
  if ((chain[key] += a < b ? 1 : -1) == 0) chain.erase(key);
}

Rational area_of(const std::vector<Flat>& points, const std::vector<std::uint32_t>& loop) {
  Rational sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Flat &p = points[loop[i]], &q = points[loop[(i + 1) % loop.size()]];
    sum += p[0] * q[1] - p[1] * q[0];
  }
  return sum;
}

bool is_inside(const Flat& p, const std::vector<Flat>& points, const Triangle& t) {
  for (std::size_t i = 0; i < 3; ++i)
    if (double_area(points[t[i]], points[t[(i + 1) % 3]], p) <= 0) return false;
  return true;
}

/// The triangles are the face. `turned`: seen from the other side.
void check_triangles(const std::vector<Flat>& points, const Loops& loops, const std::vector<Triangle>& triangles,
                     bool turned = false) {
  Chain expected, found;
  Rational expected_area = 0, area = 0;
  for (const auto& loop : loops) {
    expected_area += area_of(points, loop);
    for (std::size_t i = 0; i < loop.size(); ++i) add_side(expected, loop[i], loop[(i + 1) % loop.size()]);
  }
  for (const Triangle& t : triangles) {
    const Rational own = double_area(points[t[0]], points[t[1]], points[t[2]]);
    REQUIRE((turned ? own < 0 : own > 0));
    area += own;
    for (std::size_t i = 0; i < 3; ++i) add_side(found, t[i], t[(i + 1) % 3]);
  }
  CHECK(area == expected_area);
  CHECK(found == expected);
}

void check_no_overlap(const std::vector<Flat>& points, const std::vector<Triangle>& triangles) {
  for (const Triangle& t : triangles) {
    const Flat &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    const Flat middle{Rational((a[0] + b[0] + c[0]) / 3), Rational((a[1] + b[1] + c[1]) / 3)};
    CHECK(std::count_if(triangles.begin(), triangles.end(),
                        [&](const Triangle& s) { return is_inside(middle, points, s); }) == 1);
  }
}

std::string fault_of(const std::vector<Flat>& points, const Loops& loops) {
  const Embedded e = embedded(points, 1);
  std::vector<Triangle> triangles;
  const std::string fault = io::divide_face(face_of(loops), e.vertices(), triangles);
  if (!fault.empty()) CHECK(triangles.empty());
  return fault;
}

/// Unit squares of a grid that hang together over sides, with holes and places where only corners touch.
class Squares {
 public:
  static constexpr int side = 9;

  explicit Squares(std::mt19937& random) : random_(random) {
    const auto wanted = 5 + random() % 50;
    std::set<std::pair<int, int>> seen;
    std::vector<std::pair<int, int>> ways{{side / 2, side / 2}};
    while (cells_.size() < wanted && !ways.empty()) {
      std::swap(ways[random() % ways.size()], ways.back());
      const auto [x, y] = ways.back();
      ways.pop_back();
      if (x < 0 || y < 0 || x >= side || y >= side || !seen.insert({x, y}).second || random() % 4 == 0) continue;
      cells_.insert({x, y});
      ways.insert(ways.end(), {{x + 1, y}, {x - 1, y}, {x, y + 1}, {x, y - 1}});
    }
    if (cells_.empty()) cells_.insert({0, 0});
  }

  [[nodiscard]] std::size_t count() const { return cells_.size(); }

  /// The boundary as loops with the squares on their left. Where four sides meet, loops touch or pass through one
  /// another's corner, as chance has it; the one that is counter-clockwise comes first.
  [[nodiscard]] Loops loops(const std::vector<Flat>& points) {
    for (int attempt = 0;; ++attempt) {
      Loops all = trace(attempt < 20);
      const auto is_outer = [&](const auto& loop) { return area_of(points, loop) > 0; };
      if (std::count_if(all.begin(), all.end(), is_outer) != 1 ||
          std::any_of(all.begin(), all.end(), [&](const auto& loop) { return area_of(points, loop) == 0; }))
        continue;
      std::shuffle(all.begin(), all.end(), random_);
      std::swap(*std::find_if(all.begin(), all.end(), is_outer), all.front());
      for (auto& loop : all)
        std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(random_() % loop.size()), loop.end());
      return all;
    }
  }

 private:
  static std::uint32_t corner(int x, int y) { return static_cast<std::uint32_t>(y * (side + 1) + x); }

  Loops trace(bool by_chance) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> next;
    for (const auto& [x, y] : cells_) {
      const auto add = [&](int dx, int dy, std::uint32_t a, std::uint32_t b) {
        if (!cells_.count({x + dx, y + dy})) next[a].push_back(b);
      };
      add(0, -1, corner(x, y), corner(x + 1, y));
      add(1, 0, corner(x + 1, y), corner(x + 1, y + 1));
      add(0, 1, corner(x + 1, y + 1), corner(x, y + 1));
      add(-1, 0, corner(x, y + 1), corner(x, y));
    }
    Loops all;
    while (!next.empty()) {
      std::vector<std::uint32_t> loop{next.begin()->first};
      std::uint32_t before = loop[0];
      for (std::uint32_t at = take(next, loop[0], loop[0], by_chance); at != loop[0];) {
        loop.push_back(at);
        const std::uint32_t behind = take(next, at, before, by_chance);
        before = at;
        at = behind;
      }
      all.push_back(std::move(loop));
    }
    return all;
  }

  /// The next corner; where there is a choice, by chance or to the left, which stays within one square.
  std::uint32_t take(std::map<std::uint32_t, std::vector<std::uint32_t>>& next, std::uint32_t at, std::uint32_t before,
                     bool by_chance) {
    auto& ways = next[at];
    if (ways.size() == 2) {
      const auto step = [](std::uint32_t a, std::uint32_t b) { return static_cast<int>(b) - static_cast<int>(a); };
      const int came = step(before, at);
      const int left = came == 1 ? side + 1 : came == side + 1 ? -1 : came == -1 ? -side - 1 : 1;
      if (by_chance ? random_() % 2 == 0 : step(at, ways[0]) == left) std::swap(ways[0], ways[1]);
    }
    const std::uint32_t result = ways.back();
    ways.pop_back();
    if (ways.empty()) next.erase(at);
    return result;
  }

  std::mt19937& random_;
  std::set<std::pair<int, int>> cells_;
};

/// The corners of the grid, on their places or moved a little: the squares still do not overlap.
std::vector<Flat> grid(std::mt19937& random, bool moved) {
  std::vector<Flat> points;
  for (int y = 0; y <= Squares::side; ++y)
    for (int x = 0; x <= Squares::side; ++x) {
      const auto jitter = [&] { return moved ? Rational(static_cast<int>(random() % 401) - 200, 1001) : Rational(0); };
      points.push_back({x + jitter(), y + jitter()});
    }
  return points;
}

}  // namespace

TEST_CASE("Faces of squares with holes that touch are divided exactly", "[io][polygon][property]") {
  std::size_t holes = 0, passed_twice = 0;
  for (unsigned seed = 0; seed < 800; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const auto points = grid(random, seed % 2 == 1);
    Squares squares(random);
    const Loops loops = squares.loops(points);
    holes += loops.size() - 1;
    for (const auto& loop : loops)
      passed_twice += std::set<std::uint32_t>(loop.begin(), loop.end()).size() < loop.size();
    const Embedded e = embedded(points, seed % 3);
    std::vector<Triangle> triangles;
    REQUIRE(io::divide_face(face_of(loops), e.vertices(), triangles).empty());
    check_triangles(points, loops, triangles);
    if (seed % 2 == 0) {
      Rational area = 0;
      for (const Triangle& t : triangles) area += double_area(points[t[0]], points[t[1]], points[t[2]]);
      CHECK(area == 2 * squares.count());
    }
    if (seed % 10 == 0) check_no_overlap(points, triangles);
  }
  CHECK(holes > 400);
  CHECK(passed_twice > 100);
}

TEST_CASE("A face is seen from the side that shows its first loop counter-clockwise", "[io][polygon]") {
  std::mt19937 random(5);
  const auto points = grid(random, true);
  Loops loops = Squares(random).loops(points);
  for (auto& loop : loops) std::reverse(loop.begin(), loop.end());
  const Embedded e = embedded(points, 2);
  std::vector<Triangle> triangles;
  REQUIRE(io::divide_face(face_of(loops), e.vertices(), triangles).empty());
  check_triangles(points, loops, triangles, true);
}

namespace {

/// Do two sides have a point in common other than a corner that both end in?
bool sides_meet(const std::vector<Flat>& p, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  const auto orientation = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    return double_area(p[i], p[j], p[k]).sign();
  };
  const auto between = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {  // k strictly within ij
    return orientation(i, j, k) == 0 && p[k] != p[i] && p[k] != p[j] && std::min(p[i], p[j]) < p[k] &&
           p[k] < std::max(p[i], p[j]);
  };
  if (between(a, b, c) || between(a, b, d) || between(c, d, a) || between(c, d, b)) return true;
  if ((p[a] == p[c] && p[b] == p[d]) || (p[a] == p[d] && p[b] == p[c])) return true;
  return orientation(a, b, c) * orientation(a, b, d) < 0 && orientation(c, d, a) * orientation(c, d, b) < 0;
}

}  // namespace

TEST_CASE("Of random loops the simple ones are divided, and no wrong one is", "[io][polygon][property]") {
  std::size_t simple = 0, accepted = 0;
  for (unsigned seed = 0; seed < 8000; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const auto count = static_cast<std::uint32_t>(4 + random() % 6);
    std::vector<Flat> points;
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x) points.push_back({x, y});
    std::vector<std::uint32_t> loop;
    while (loop.size() < count) loop.push_back(static_cast<std::uint32_t>(random() % points.size()));
    bool meets = false;
    for (std::uint32_t i = 0; i < count; ++i) {
      meets = meets || std::count(loop.begin(), loop.end(), loop[i]) > 1;
      for (std::uint32_t j = 0; j < i; ++j)
        meets = meets || sides_meet(points, loop[i], loop[(i + 1) % count], loop[j], loop[(j + 1) % count]);
    }
    const Embedded e = embedded(points, seed % 3);
    std::vector<Triangle> triangles;
    const std::string fault = io::divide_face(face_of({loop}), e.vertices(), triangles);
    CAPTURE(fault);
    if (!meets) {
      ++simple;
      CHECK(fault.empty());
    }
    if (!fault.empty()) continue;
    ++accepted;
    const bool turned = area_of(points, loop) < 0;
    check_triangles(points, {loop}, triangles, turned);
    if (turned)
      for (Triangle& t : triangles) std::swap(t[0], t[1]);
    check_no_overlap(points, triangles);
  }
  CHECK(simple > 300);
  CHECK(accepted > simple);
}

TEST_CASE("A face that is none says what is wrong with it", "[io][polygon]") {
  const std::vector<Flat> p{{0, 0}, {8, 0}, {8, 8},  {0, 8},  {2, 2}, {2, 4}, {4, 4},
                            {4, 2}, {9, 9}, {9, 10}, {10, 9}, {4, 0}, {3, 3}, {0, 0}};
  const std::vector<std::uint32_t> square{0, 1, 2, 3};
  const auto says = [&](const Loops& loops, const std::string& what) {
    const std::string fault = fault_of(p, loops);
    CAPTURE(fault, what);
    CHECK(fault.find(what) != std::string::npos);
  };
  says({{0, 1, 3, 2}}, "encloses no area");
  says({square, {7, 6, 10}}, "crosses itself");
  says({square, {4, 7, 6, 5}}, "not clockwise");
  says({square, {8, 9, 10}}, "hole outside");
  says({square, {4, 5, 6, 7}, {4, 5, 6, 7}}, "crosses itself");
  says({square, {4, 5, 6, 7}, {12, 6, 7}}, "crosses itself");
  says({square, {11, 4, 7}}, "cross or touch");
  says({{4, 7, 6, 5}, {0, 3, 2, 1}}, "hole outside");
  says({{0, 1, 2, 0, 1, 2}}, "crosses itself");
  says({{0, 11, 1}, {4, 5, 6}}, "no area");
  says({{0, 12, 6, 2}}, "one line");
  says({{0, 1, 2, 3, 2}}, "doubles back");
  says({{0, 13, 1, 2}}, "without length");
  CHECK(fault_of(p, {square, {4, 5, 6, 7}}).empty());
  CHECK(fault_of(p, {square, {0, 12, 7}}).empty());
}

TEST_CASE("A stretch that a loop runs along in both directions makes a hole", "[io][polygon]") {
  const std::vector<Flat> p{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {2, 2}, {2, 4}, {4, 4}, {4, 2}};
  const Loops loops{{0, 1, 2, 3, 0, 4, 5, 6, 7, 4}};
  const Embedded e = embedded(p, 1);
  std::vector<Triangle> triangles;
  REQUIRE(io::divide_face(face_of(loops), e.vertices(), triangles).empty());
  check_triangles(p, loops, triangles);
  check_no_overlap(p, triangles);
}

TEST_CASE("Corners that miss their plane by less than a double's last bit are seen", "[io][polygon]") {
  const std::vector<Flat> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  Embedded e = embedded(points, 1);
  std::vector<Triangle> triangles;
  REQUIRE(io::divide_face(face_of({{0, 1, 2, 3}}), e.vertices(), triangles).empty());
  REQUIRE(e.exact.size() == 4);
  e.exact[2].position[1] += Rational(1, Integer(1) << 2000);
  CHECK(io::divide_face(face_of({{0, 1, 2, 3}}), e.vertices(), triangles).find("in one plane") != std::string::npos);
}

TEST_CASE("Large faces take no time that grows with the square", "[io][polygon]") {
  // A comb of 40,000 teeth, with a hole in each.
  std::vector<Vertex> vertices;
  Loops loops(1);
  const std::uint32_t teeth = 40'000;
  const auto add = [&](double x, double y) {
    vertices.push_back({x, y, 0});
    return static_cast<std::uint32_t>(vertices.size() - 1);
  };
  for (std::uint32_t i = 0; i < teeth; ++i) {
    loops[0].push_back(add(4 * i, 10));
    loops[0].push_back(add(4 * i + 1, 0));
    loops[0].push_back(add(4 * i + 3, 0));
    const std::uint32_t a = add(4 * i + 1.5, 1), b = add(4 * i + 1.5, 2), c = add(4 * i + 2.5, 1);
    loops.push_back({a, b, c});
  }
  loops[0].push_back(add(4 * teeth, 10));
  loops[0].push_back(add(2 * teeth, 20));
  std::vector<Triangle> triangles;
  REQUIRE(io::divide_face(face_of(loops), {vertices, {}}, triangles).empty());
  CHECK(triangles.size() == (loops[0].size() - 2) + 5 * std::size_t{teeth});
}
