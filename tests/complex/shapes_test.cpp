#include <catch2/catch.hpp>
#include <numeric>

#include "strata/complex.h"
#include "strata/errors.h"

namespace strata::complex {
namespace {

SelectiveComplex square(double x, double y, double size, Border border) {
  return polygon(std::vector<std::vector<Point2>>{{{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}}},
                 border);
}

SelectiveComplex point2(double x, double y) { return simplex(2, std::vector<Vertex>{{x, y, 0}}); }
SelectiveComplex segment2(Vertex a, Vertex b, Border border = Border::closed) {
  return simplex(2, std::vector<Vertex>{a, b}, border);
}

Solid box(Vertex low, Vertex high) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.push_back({i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]});
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return Solid(mesh);
}

std::array<std::uint32_t, 4> counts(const SelectiveComplex& s) {
  return {s.count(0), s.count(1), s.count(2), s.count(3)};
}

using Counts = std::array<std::uint32_t, 4>;

}  // namespace

TEST_CASE("a box has eight vertices, twelve edges, six faces and two volumes", "[complex]") {
  const SelectiveComplex s = of_solid(box({0, 0, 0}, {1, 2, 3}));
  CHECK(counts(s) == Counts{8, 12, 6, 2});
  CHECK(volume(s) == Rational(6));
  CHECK(area(s) == 22);
  CHECK(length(s) == 24);
  CHECK(s.incidences().size() == 24 + 24 + 24 + 12 + 24 + 16);
}

TEST_CASE("a polygon's canonical decomposition has the vertices that it needs", "[complex][plane]") {
  // 3.2: a vertex is where the boundary is no edge, so points within sides vanish.
  const SelectiveComplex s =
      polygon(std::vector<std::vector<Point2>>{{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1}}}, Border::open);
  CHECK(counts(s) == Counts{4, 4, 2, 0});
  CHECK(exact_area(s) == Rational(4));
  CHECK(s.mark({2, 1}));
  CHECK(boundary(s) == (~s & closure(s)));
  CHECK(is_open_regularized(s));
}

TEST_CASE("a polygon without its centre has a boundary with an isolated point", "[complex][plane]") {
  const SelectiveComplex disk = square(-1, -1, 2, Border::open), s = disk - point2(0, 0);
  CHECK(boundary(s) == (boundary(disk) | point2(0, 0)));
  CHECK(part(s, Part::cut) == point2(0, 0));
  CHECK(part(s, Part::wound) == boundary(disk));
  CHECK(regularized(s) == closure(disk));
  CHECK(open_regularized(s) == disk);
  CHECK(count_holes(s) == 1);
  CHECK(holes(s) == point2(0, 0));
}

TEST_CASE("a box without its centre has a cut of one point", "[complex]") {
  const SelectiveComplex centre = simplex(3, std::vector<Vertex>{{0.5, 0.5, 0.5}});
  const SelectiveComplex s = of_solid(box({0, 0, 0}, {1, 1, 1})) - centre;
  CHECK(counts(s) == Counts{9, 12, 6, 2});
  CHECK(part(s, Part::cut) == centre);
  CHECK(part(s, Part::hair).is_empty());
  CHECK(regularized(s) == of_solid(box({0, 0, 0}, {1, 1, 1})));
}

TEST_CASE("two squares in a checkerboard have an open union that is not open-regularized", "[complex][plane]") {
  const SelectiveComplex a = square(0, 0, 1, Border::open), b = square(1, 1, 1, Border::open);
  const SelectiveComplex beside = square(1, 0, 1, Border::open);
  CHECK(is_open_regularized(a | b));  // they touch in a point, which the exterior touches, too
  const SelectiveComplex s = a | beside;
  CHECK(is_open(s));
  CHECK(!is_open_regularized(s));
  CHECK(part(s, Part::cut) == segment2({1, 0, 0}, {1, 1, 0}, Border::open));
  CHECK(components(s).count == 2);
  CHECK(components(open_regularized(s)).count == 1);
  const SelectiveComplex four = s | b | square(0, 1, 1, Border::open);
  CHECK(part(four, Part::cut).count(0) == 5);  // the cross with its centre, without its four ends
  CHECK(open_regularized(four) == square(0, 0, 2, Border::open));
}

TEST_CASE("hair, cut and wound may each be a single point", "[complex][plane]") {
  const SelectiveComplex s = (square(0, 0, 4, Border::closed) - point2(2, 2) - point2(0, 0)) | point2(9, 9);
  CHECK(part(s, Part::hair) == point2(9, 9));
  CHECK(part(s, Part::cut) == point2(2, 2));
  CHECK(part(s, Part::wound) == point2(0, 0));
  CHECK(part(s, Part::skin) == (boundary(square(0, 0, 4, Border::closed)) - point2(0, 0)));
}

TEST_CASE("the closure of the open regularization is not the closure where there is hair", "[complex][plane]") {
  const SelectiveComplex s = square(0, 0, 1, Border::closed) | segment2({1, 0, 0}, {2, 0, 0});
  CHECK(closure(open_regularized(s)) != closure(s));
  CHECK(closure(open_regularized(s)) == square(0, 0, 1, Border::closed));
}

TEST_CASE("hair may touch the interior only, and a cut the exterior only", "[complex][plane]") {
  // Against a note of the source; theory.md, section 5.
  const SelectiveComplex slit = square(0, 0, 4, Border::closed) - segment2({1, 1, 0}, {3, 1, 0});
  const SelectiveComplex s = (slit | point2(2, 1)) | segment2({5, 0, 0}, {6, 0, 0}, Border::open);
  CHECK(part(s, Part::hair) == (point2(2, 1) | segment2({5, 0, 0}, {6, 0, 0}, Border::open)));
  CHECK((part(s, Part::cut) & exterior(square(0, 0, 4, Border::closed))) == (point2(5, 0) | point2(6, 0)));
  // So trimming all hair and healing all cuts is not the regularization.
  CHECK(((s - part(s, Part::hair)) | part(s, Part::wound) | part(s, Part::cut)) != regularized(s));
  CHECK(regularized(s) == square(0, 0, 4, Border::closed));
}

TEST_CASE("manifold polygons may have four polygons in common, one of them not manifold", "[complex][plane]") {
  // Problem 5: rooms that a corridor above joins in A, one below in B. In the second room A and B lack triangles that
  // touch in a point. No two of the four can merge: theory.md, section 5.
  const auto loop = [](std::vector<Point2> points) {
    return polygon(std::vector<std::vector<Point2>>{std::move(points)}, Border::closed);
  };
  SelectiveComplex a = loop({{0, 8}, {40, 8}, {40, 10}, {0, 10}}), b = loop({{0, -2}, {40, -2}, {40, 0}, {0, 0}});
  for (const double x : {0., 10., 20., 30.}) {
    a = a | loop({{x, 0}, {x + 8, 0}, {x + 8, 8}, {x, 8}});
    b = b | loop({{x, 0}, {x + 8, 0}, {x + 8, 6}, {x, 6}});
  }
  a = interior(a - loop({{12, 1}, {16, 1}, {14, 3}}));
  b = interior(b - loop({{12, 5}, {14, 3}, {16, 5}}));
  for (const SelectiveComplex& s : {a, b}) CHECK((is_manifold(s) && is_connected(s) && is_open_regularized(s)));
  CHECK(is_open_regularized(a & b));
  const std::vector<SelectiveComplex> rooms = separate(a & b);
  REQUIRE(rooms.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) CHECK(is_manifold(rooms[i]) == (i != 1));
  CHECK(count_holes(rooms[1]) == 1);  // the triangles are one component of the complement
}

TEST_CASE("manifold boundaries are told from others", "[complex]") {
  CHECK(is_manifold(square(0, 0, 1, Border::open)));
  CHECK(
      !is_manifold(square(0, 0, 1, Border::open) - point2(0.5, 0.5)));  // exercise 26: neither the disk without centre,
  CHECK(is_manifold(closure(square(0, 0, 1, Border::open) - point2(0.5, 0.5))));  // but its closure
  CHECK(!is_manifold(point2(0, 0)));                                              // exercise 25
  CHECK(non_manifold_cells(square(0, 0, 1, Border::closed) | square(1, 1, 1, Border::closed)).size() == 1);

  const SelectiveComplex a = of_solid(box({0, 0, 0}, {2, 2, 2}));
  CHECK(is_manifold(a));
  CHECK(is_manifold(a - of_solid(box({1, 1, 1}, {3, 3, 3}))));
  CHECK(non_manifold_cells(a | of_solid(box({2, 2, 2}, {3, 3, 3}))) == std::vector<Cell>{{0, 7}});
  const SelectiveComplex beside = a | of_solid(box({2, 2, 0}, {4, 4, 2}));  // a common edge and its ends
  CHECK(non_manifold_cells(beside).size() == 3);
  // A face with two corners at one vertex, where a box stands on its edge's end from above and one from below.
  const SelectiveComplex chess = a | of_solid(box({2, 2, 0}, {4, 4, 3}));
  CHECK(non_manifold_cells(chess).size() == 3);
  CHECK(!is_manifold(a - simplex(3, std::vector<Vertex>{{1, 1, 1}})));
  CHECK(is_manifold(a - simplex(3, std::vector<Vertex>{{1, 1, 2}})));  // a wound of one point in a face
  CHECK(!is_manifold(a | simplex(3, std::vector<Vertex>{{1, 1, 2}, {1, 1, 3}})));
}

TEST_CASE("complements are sets like others", "[complex]") {
  const SelectiveComplex s = of_solid(box({0, 0, 0}, {1, 1, 1}), Border::open);
  CHECK(!(~s).is_bounded());
  CHECK(is_closed(~s));
  CHECK(!volume(~s).has_value());
  CHECK(~(~s) == s);
  CHECK((s | ~s).is_all());
  CHECK(exterior(s) == ~of_solid(box({0, 0, 0}, {1, 1, 1})));
}

TEST_CASE("nested shells are volumes in one another", "[complex]") {
  SelectiveComplex s;
  for (int i = 0; i < 6; ++i) s = s ^ of_solid(box({0. + i, 0. + i, 0. + i}, {20. - i, 20. - i, 20. - i}));
  CHECK(s.count(3) == 7);
  CHECK(components(s).count == 3);
  Rational expected = 0;
  for (int i = 0, sign = 1; i < 6; ++i, sign = -sign)
    expected += sign * Rational((20 - 2 * i) * (20 - 2 * i) * (20 - 2 * i));
  CHECK(volume(s) == expected);
}

TEST_CASE("shells beside and inside each other are told apart", "[complex]") {
  std::vector<SelectiveComplex> parts;
  for (int i = 0; i < 3; ++i) {
    parts.push_back(of_solid(box({10. * i, 0, 0}, {10. * i + 8, 8, 8})) -
                    of_solid(box({10. * i + 1, 1, 1}, {10. * i + 7, 7, 7}), Border::open));
    parts.push_back(of_solid(box({10. * i + 3, 3, 3}, {10. * i + 4, 4, 4})));
    parts.push_back(simplex(3, std::vector<Vertex>{{10. * i + 2, 2, 2}}));
    parts.push_back(simplex(3, std::vector<Vertex>{{10. * i + 2, 5, 5}, {10. * i + 5, 5, 5.5}}));
    parts.push_back(simplex(3, std::vector<Vertex>{{10. * i + 5, 2, 2}, {10. * i + 6, 2, 2}, {10. * i + 6, 3, 2}}));
  }
  const SelectiveComplex s = union_(parts);
  CHECK(components(s).count == 15);
  CHECK(count_holes(s) == 3);
  CHECK(s.count(3) == 1 + 3 * 3);
  CHECK(volume(s) == 3 * Rational(512 - 216 + 1));
  CHECK(volume(holes(s)) == 3 * Rational(216 - 1));
  CHECK(contains(s, Vertex{12, 2, 2}));
  CHECK(!contains(s, Vertex{12, 2.5, 2}));
  CHECK(locate(s, Vertex{12, 5, 5}).dimension == 0);
  CHECK(locate(s, Vertex{13.5, 5, 5.25}).dimension == 1);
  CHECK(locate(s, Vertex{13.5, 3.5, 3.5}).dimension == 3);
}

TEST_CASE("exact places decide, at any scale", "[complex]") {
  const double tiny = 1e-300, huge = 1e300;
  const SelectiveComplex s = simplex(3, std::vector<Vertex>{{0, 0, 0}, {huge, 0, 0}, {0, huge, 0}});
  const SelectiveComplex near = simplex(3, std::vector<Vertex>{{tiny, tiny, 0}}),
                         off = simplex(3, std::vector<Vertex>{{tiny, tiny, tiny}});
  CHECK((s | near) == s);
  CHECK((s | off) != s);
  CHECK((s | off).count(0) == 4);
  CHECK((s - near).count(0) == 4);
  CHECK(contains(s - near, Vertex{tiny / 2, tiny, 0}));
  CHECK(!contains(s - near, Vertex{tiny, tiny, 0}));
}

TEST_CASE("bad input has a name", "[complex]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto kind = [](const auto& make) {
    try {
      make();
    } catch (const InputError& error) {
      return std::string(name(error.defects().front().kind));
    } catch (const std::invalid_argument&) {
      return std::string("invalid argument");
    }
    return std::string("none");
  };
  CHECK(kind([&] { (void)simplex(3, std::vector<Vertex>{{nan, 0, 0}}); }) == "non-finite coordinate");
  CHECK(kind([&] {
          (void)polygon(std::vector<std::vector<Point2>>{{{0, 0}, {1, 0}, {nan, 1}}});
        }) == "non-finite coordinate");
  CHECK(kind([&] { (void)simplex(3, std::vector<Vertex>{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}); }) == "degenerate triangle");
  CHECK(kind([&] { (void)simplex(3, std::vector<Vertex>{{0, 0, 0}, {0, 0, 0}}); }) == "degenerate triangle");
  CHECK(kind([&] { (void)simplex(2, std::vector<Vertex>{{0, 0, 1}}); }) == "invalid argument");
  CHECK(kind([&] { (void)unite_closed({{{0, 0, 0}}, {{0, 0, 7}}, {}, {}}); }) == "index out of range");
  CHECK(kind([&] { (void)(SelectiveComplex(2) | SelectiveComplex(3)); }) == "invalid argument");
  CHECK(kind([&] { (void)Solid(Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}); }) == "open edge");
}

}  // namespace strata::complex
