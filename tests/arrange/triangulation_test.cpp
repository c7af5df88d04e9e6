#include "core/arrange/triangulation.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <optional>

#include "core/overlap/meeting.h"
#include "kernel/tiers.h"
#include "support/random.h"
#include "support/shapes.h"

using namespace strata;

namespace {

/// One big face in the plane z = 0, and walls that cut it, each a face of its own: trace lines through it.
struct Plate {
  std::vector<InputComplex::Coordinates> points{{0, 0, 0}, {64, 0, 0}, {0, 64, 0}};
  std::vector<InputComplex::Indices> faces{{0, 1, 2}};
  InputComplex input;

  /// A wall over the segment from (x0, y0) to (x1, y1): its vertices are on the plate's plane at both ends and above.
  std::uint32_t wall(double x0, double y0, double x1, double y1) {
    const auto v = static_cast<std::uint32_t>(points.size());
    points.push_back({x0, y0, 0});
    points.push_back({x1, y1, 0});
    points.push_back({(x0 + x1) / 2, (y0 + y1) / 2, 5});
    faces.push_back({v, v + 1, v + 2});
    return v;
  }
  void build() { input.add(points, faces); }
};

/// Invariants of a triangulation: neighbours agree, triangles turn left, areas add up.
void validate(const InputComplex& input, const Triangulation& t) {
  const Projection xy{0, 1};
  Rational area = 0;
  const auto triangles = t.triangles();
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& x = triangles[i];
    const Point &p = t.points()[x.v[0]], &q = t.points()[x.v[1]], &r = t.points()[x.v[2]];
    REQUIRE(orient2d(input, xy, p, q, r) == Sign::positive);
    const auto a = exact_position(input, p), b = exact_position(input, q), c = exact_position(input, r);
    area += (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t n = x.n[k];
      if (n < 0) continue;
      const auto& y = triangles[std::size_t(n)];
      int back = 0;
      for (std::size_t j = 0; j < 3; ++j)
        back += y.n[j] == std::int32_t(i) && y.v[j] == x.v[(k + 1) % 3] && y.v[(j + 1) % 3] == x.v[k];
      REQUIRE(back == 1);
    }
  }
  REQUIRE(area == 64 * 64);
}

/// How many triangles have an angle that is nearly 180 degrees: seen from the longest side, they are almost flat.
int flat_angles(const Triangulation& t) {
  int count = 0;
  for (const auto& x : t.triangles())
    for (std::size_t k = 0; k < 3; ++k) {
      const auto &p = t.points()[x.v[k]].at, &q = t.points()[x.v[(k + 1) % 3]].at, &r = t.points()[x.v[(k + 2) % 3]].at;
      const double ax = q[0].value - p[0].value, ay = q[1].value - p[1].value, bx = r[0].value - p[0].value,
                   by = r[1].value - p[1].value;
      count += static_cast<int>(std::abs(std::atan2(ax * by - ay * bx, ax * bx + ay * by)) > 3.14159);
    }
  return count;
}

/// Two surfaces, each of two faces that are nearly in one plane, in which paths cross the plate: bent ones.
struct BentPaths {
  Plate plate;
  std::array<std::vector<Vertex>, 2> corners;
  std::vector<Triangle> quads{{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
  std::vector<Constraint> constraints;
  std::optional<PointTable> table;

  BentPaths(const BentPaths&) = delete;
  BentPaths& operator=(const BentPaths&) = delete;
  explicit BentPaths(double bend) {
    plate.build();
    for (std::size_t n = 0; n < 2; ++n) {
      const double y = n == 0 ? 8 : 24;
      for (const double z : {-5, 5}) corners[n].insert(corners[n].end(), {{-9, y, z}, {21, y + bend, z}, {80, y, z}});
      plate.input.add(corners[n], quads);
    }
    PairIntersections found;
    const FilteredFace face(plate.input, 0);
    for (std::uint32_t g = 1; g < plate.input.face_count(); ++g)
      meet_faces(plate.input, face, FilteredFace(plate.input, g), found);
    table.emplace(plate.input);
    const auto numbers = table->add(found.constructed, {});
    for (Constraint c : found.constraints) {
      for (PointId* id : {&c.tail, &c.head})
        if (!table->is_input(*id)) *id = numbers[*id - table->first()];
      if (c.face == 0) constraints.push_back(c);
    }
  }
};

}  // namespace

// Catches: caps left beside a diagonal, a diagonal flipped where the quadrilateral is not convex.
TEST_CASE("paths that are bent by a little have no flat triangles beside them", "[arrange]") {
  int before = 0;
  for (const double bend : {0x1p-45, -0x1p-45, 0x1p-20}) {
    CAPTURE(bend);
    const BentPaths bent(bend);
    REQUIRE(bent.constraints.size() == 7);
    for (const bool cut_ears : {true, false}) {
      CAPTURE(cut_ears);
      Triangulation t(bent.plate.input, *bent.table);
      t.start(0, Triangulation::Names::lowest);
      if (cut_ears) {
        const PathPolygons* paths = t.find_paths(bent.constraints);
        REQUIRE(paths != nullptr);
        for (std::size_t i = 0; i < paths->count(); ++i) REQUIRE(t.fill(i));
      } else {
        t.add_constraints(bent.constraints);
      }
      before += flat_angles(t);
      t.avoid_flat_angles();
      validate(bent.plate.input, t);
      CHECK(flat_angles(t) == 0);
    }
  }
  CHECK(before > 0);
}

TEST_CASE("random segments on a lattice, and nearly, with all their coincidences", "[arrange][property]") {
  int flipped = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    Plate plate;
    std::vector<std::uint32_t> walls;
    const int count = random.between(1, 14), range = random.once_in(2) ? 5 : 24;
    const double bend = random.once_in(2) ? 0x1p-30 : 0;
    const auto coordinate = [&] { return random.between(0, range) + bend * random.between(0, 2); };
    for (int i = 0; i < count; ++i) {
      const double x0 = coordinate(), y0 = coordinate(), x1 = coordinate(), y1 = coordinate();
      if (x0 == x1 && y0 == y1) continue;
      walls.push_back(plate.wall(x0, y0, x1, y1));
    }
    plate.build();
    const PointTable table(plate.input);
    Triangulation t(plate.input, table);
    t.start(0, Triangulation::Names::any);
    std::vector<std::pair<std::int32_t, std::int32_t>> ends;
    for (const std::uint32_t v : walls) ends.emplace_back(t.add_point(v), t.add_point(v + 1));
    for (std::size_t i = 0; i < walls.size(); ++i)
      t.add_segment(ends[i].first, ends[i].second, std::int32_t(i), ConstraintLine::along_edge(walls[i], walls[i] + 1));
    const int flat = flat_angles(t);
    t.avoid_flat_angles();
    CHECK(flat_angles(t) <= flat);
    flipped += flat_angles(t) < flat;
    validate(plate.input, t);
    // Every segment is a chain of sides that carry it: their lengths in x and y add up.
    for (std::size_t i = 0; i < walls.size(); ++i) {
      Rational dx = 0, dy = 0;
      for (const auto& x : t.triangles())
        for (std::size_t k = 0; k < 3; ++k)
          for (std::int32_t n = x.c[k]; n >= 0; n = t.note(n).next) {
            if (t.note(n).constraint != std::int32_t(i) || !t.note(n).forward) continue;
            const auto a = exact_position(plate.input, t.points()[x.v[k]]);
            const auto b = exact_position(plate.input, t.points()[x.v[(k + 1) % 3]]);
            dx += b[0] - a[0];
            dy += b[1] - a[1];
          }
      const auto &p = plate.points[walls[i]], &q = plate.points[walls[i] + 1];
      // Sides on the border of the face have one triangle; a segment that runs against it is noted backwards there.
      const bool on_border = (p[0] == 0 && q[0] == 0) || (p[1] == 0 && q[1] == 0);
      if (!on_border) {
        REQUIRE(dx == to_rational(q[0]) - to_rational(p[0]));
        REQUIRE(dy == to_rational(q[1]) - to_rational(p[1]));
      }
    }
  }
  CHECK(flipped > 10);
}

TEST_CASE("points of one place and different names become one vertex, and are noted", "[arrange][degenerate]") {
  Plate plate;
  const auto a = plate.wall(1, 1, 5, 5), b = plate.wall(5, 5, 9, 1);  // they touch in (5, 5) with vertices of their own
  plate.build();
  const PointTable table(plate.input);
  Triangulation t(plate.input, table);
  t.start(0, Triangulation::Names::any);
  CHECK(t.add_point(a + 1) == t.add_point(b));
  REQUIRE(t.other_names().size() == 1);
  CHECK(t.add_point(b) == 3);
}

TEST_CASE("concurrent segments share one vertex", "[arrange][degenerate]") {
  Plate plate;
  std::vector<std::uint32_t> walls;
  for (int k = -6; k <= 6; ++k) walls.push_back(plate.wall(10 - 7, 10 - k, 10 + 7, 10 + k));
  plate.build();
  const PointTable table(plate.input);
  Triangulation t(plate.input, table);
  t.start(0, Triangulation::Names::any);
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const auto p = t.add_point(walls[i]), q = t.add_point(walls[i] + 1);
    t.add_segment(p, q, std::int32_t(i), ConstraintLine::along_edge(walls[i], walls[i] + 1));
  }
  CHECK(t.points().size() == std::int32_t(3 + 2 * walls.size() + 1));
  validate(plate.input, t);
}

TEST_CASE("thousands of points in one face are located in little time", "[arrange]") {
  Plate plate;
  test::Random random(1);
  for (int i = 0; i < 4000; ++i) {
    const double x = random.between(1, 30'000) / 1024.0, y = random.between(1, 30'000) / 1024.0;
    plate.wall(x, y, x + 0.001, y);
  }
  plate.build();
  const PointTable table(plate.input);
  Triangulation t(plate.input, table);
  t.start(0, Triangulation::Names::any);
  for (std::uint32_t v = 3; v < plate.points.size(); v += 3) t.add_point(v);
  CHECK(t.points().size() > 3900);
  validate(plate.input, t);
}

// Catches: polygons traced the wrong way round, an ear over a point, sides left without their neighbours.
TEST_CASE("paths of a surface that crosses a face are cut at once; rings are not", "[arrange][property]") {
  int cut = 0, left = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    Plate plate;
    plate.build();
    const Mesh ball =
        test::icosphere({64 * random.unit(), 64 * random.unit(), random.unit()}, 1 + 20 * random.unit(), 1);
    plate.input.add(ball.vertices, ball.triangles);
    PairIntersections intersections;
    const FilteredFace face(plate.input, 0);
    for (std::uint32_t g = 1; g < plate.input.face_count(); ++g)
      meet_faces(plate.input, face, FilteredFace(plate.input, g), intersections);
    PointTable table(plate.input);
    const auto numbers = table.add(intersections.constructed, {});
    std::vector<Constraint> constraints;
    for (Constraint c : intersections.constraints) {
      if (c.face != 0) continue;
      for (PointId* id : {&c.tail, &c.head})
        if (!table.is_input(*id)) *id = numbers[*id - table.first()];
      constraints.push_back(c);
    }
    Triangulation t(plate.input, table);
    t.start(0, Triangulation::Names::lowest);
    const PathPolygons* paths = t.find_paths(constraints);
    bool are_paths = paths != nullptr;
    for (std::size_t i = 0; are_paths && i < paths->count(); ++i) are_paths = t.fill(i);
    if (paths != nullptr && !are_paths) t.start(0, Triangulation::Names::lowest);
    validate(plate.input, t);
    (are_paths ? cut : left) += static_cast<int>(!constraints.empty());
    std::size_t notes = 0;
    for (const auto& x : t.triangles())
      for (const std::int32_t c : x.c) notes += static_cast<std::size_t>(c >= 0);
    CHECK(notes == (are_paths ? 2 * constraints.size() : 0));
  }
  CHECK(cut > 20);
  CHECK(left > 20);
}

// Four vertices, or nearly, in a plane whose trace no coordinate shows: below two doubles' reach of it, if at all.
// Catches: edges taken for coplanar because they are neighbours, and the exact turn asked where they are.
TEST_CASE("where a quadrilateral crosses a face, its sides and diagonal tell if the trace bends",
          "[arrange][degenerate]") {
  const double least = 1e-60;
  for (const double off : {-least, 0.0, least}) {
    CAPTURE(off);
    const std::vector<InputComplex::Coordinates> points{{0, 0, 0},  {64, 0, 0}, {0, 64, 0},  // the face
                                                        {3, 3, -3}, {5, 5, 5},  {7, 7, -4}, {off, 0, 7}};
    const std::vector<InputComplex::Indices> faces{{0, 1, 2}, {3, 5, 4}, {4, 5, 6}};
    InputComplex input;
    input.add(points, faces);
    const std::vector<SymbolicPoint> names{SymbolicPoint::edge_face(3, 4, 0), SymbolicPoint::edge_face(4, 5, 0),
                                           SymbolicPoint::edge_face(5, 6, 0)};
    PointTable table(input);
    const auto numbers = table.add(names, {});
    FacePoints face(input, table);
    face.start(0);
    std::vector<std::int32_t> v;
    for (const PointId id : numbers) v.push_back(face.add(id));
    const Sign expected = off < 0 ? Sign::positive : off > 0 ? Sign::negative : Sign::zero;
    test::TierProbe probe;
    CHECK(face.orientation(v[0], v[1], v[2]) == expected);
    const auto asked = probe.take();
    if (test::counts_tiers && off == 0)
      CHECK(asked[static_cast<std::size_t>(Tier::bits_512)] + asked[static_cast<std::size_t>(Tier::bits_1024)] == 0);
    CHECK(orient2d(input, face.projection(), face[v[0]], face[v[1]], face[v[2]]) == expected);
  }
}
