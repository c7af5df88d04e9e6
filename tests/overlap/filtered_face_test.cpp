#include "core/overlap/filtered_face.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/overlap/meeting.h"
#include "support/random.h"

using namespace strata;

namespace {

using Corners = std::array<InputComplex::Coordinates, 3>;

/// Two faces of one operand; corners at one place have one number.
struct Neighbours {
  InputComplex input;
  std::vector<InputComplex::Coordinates> points;
  std::vector<InputComplex::Indices> faces;

  Neighbours(const Corners& f, const Corners& g) {
    for (const Corners* face : {&f, &g}) {
      InputComplex::Indices& t = faces.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const auto at = std::find(points.begin(), points.end(), (*face)[i]);
        t[i] = static_cast<std::uint32_t>(at - points.begin());
        if (at == points.end()) points.push_back((*face)[i]);
      }
    }
    input.add(points, faces);
  }
  [[nodiscard]] bool is_off() const { return FilteredFace(input, 0).is_off(FilteredFace(input, 1)); }
  [[nodiscard]] bool is_beside() const {
    const FilteredFace f(input, 0), g(input, 1);
    return f.is_beside(g, f.sides_of(g));
  }
};

/// True when all corners of what faces of two operands share are corners of both.
bool share_corners_only(const Corners& f, const Corners& g) {
  const std::vector<InputComplex::Indices> face{{0, 1, 2}};
  InputComplex input;
  input.add(f, face);
  input.add(g, face);
  PairIntersections intersections;
  if (!meet_faces(input, FilteredFace(input, 0), FilteredFace(input, 1), intersections)) return true;
  const auto is_common = [&](PointId id) {
    const SymbolicPoint name =
        id < input.vertex_count() ? SymbolicPoint::input(id) : intersections.constructed[id - input.vertex_count()];
    const InputComplex::Coordinates p = nearest_doubles(input, make_point(input, name));
    return std::find(f.begin(), f.end(), p) != f.end() && std::find(g.begin(), g.end(), p) != g.end();
  };
  return std::all_of(intersections.constraints.begin(), intersections.constraints.end(), [&](const Constraint& c) {
    return c.kind == ConstraintKind::coplanar || (is_common(c.tail) && is_common(c.head));
  });
}

Corners random_face(test::Random& random, int height) {
  for (;;) {
    Corners face;
    for (auto& p : face)
      p = {double(random.between(0, 3)), double(random.between(0, 3)), double(random.between(0, height))};
    const Neighbours one(face, face);
    if (one.points.size() == 3 &&
        (face[1][0] - face[0][0]) * (face[2][1] - face[0][1]) != (face[1][1] - face[0][1]) * (face[2][0] - face[0][0]))
      return face;
  }
}

}  // namespace

TEST_CASE("faces in a plane are off each other beyond a line, and along it beyond a corner", "[overlap]") {
  const Corners f{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  const auto is_off = [&](const Corners& g) { return Neighbours(f, g).is_off(); };
  CHECK(is_off({{{0, -1, 0}, {3, -1, 0}, {1, -5, 0}}}));
  CHECK(is_off({{{0, 0, 0}, {4, 0, 0}, {1, -5, 0}}}));        // an edge in common
  CHECK(is_off({{{0, 0, 0}, {-2, -1, 0}, {-1, -2, 0}}}));     // a corner
  CHECK(is_off({{{0, 0, 0}, {-2, 0, 0}, {-2, -2, 0}}}));      // and along an edge's line beyond it
  CHECK(is_off({{{4, 0, 0}, {6, 0, 0}, {4, -2, 7}}}));        // out of the plane, seen along its normal
  CHECK_FALSE(is_off({{{0, 0, 0}, {2, 0, 0}, {2, -2, 0}}}));  // along the edge itself
  CHECK_FALSE(is_off({{{0, 0, 0}, {6, 0, 0}, {2, -2, 0}}}));
  CHECK_FALSE(is_off({{{4, 0, 0}, {-6, 0, 0}, {2, -2, 0}}}));
  CHECK_FALSE(is_off({{{2, 0, 0}, {3, -2, 0}, {1, -2, 0}}}));  // a corner on the edge
  CHECK_FALSE(is_off({{{0, 0, 0}, {4, 0, 0}, {1, 5, 0}}}));    // on the same side of the edge
  CHECK_FALSE(is_off({{{0, 0, 0}, {-2, 0, 0}, {1, 1, 0}}}));
}

TEST_CASE("faces that are off or beside each other share no more than corners", "[overlap][property]") {
  int told = 0;
  for (std::uint64_t seed = 0; seed < 20'000; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const int height = random.once_in(2) ? 0 : 2;
    const Corners f = random_face(random, height), g = random_face(random, height);
    const Neighbours two(f, g);
    if (two.points.size() == 3 || !(two.is_off() || two.is_beside())) continue;
    ++told;
    CHECK(share_corners_only(f, g));
  }
  CHECK(told > 5000);
}
