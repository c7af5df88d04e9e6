#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <limits>

#include "strata/strata.h"
#include "support/planes.h"
#include "support/shapes.h"
#include "support/touching.h"

using namespace strata;
using test::box;

TEST_CASE("untouched faces come out as they went in", "[csg]") {
  const Mesh a = test::icosphere({0, 0, 0}, 1, 3), b = test::icosphere({.9, .1, .05}, 1, 3);
  const std::vector<MeshView> operands{a, b};
  const BooleanResult r = combine(Operation::union_, std::span<const MeshView>(operands));
  REQUIRE(r.sources.size() == r.mesh.triangles.size());
  std::size_t whole = 0;
  for (std::size_t t = 0; t < r.sources.size(); ++t) {
    const Mesh& m = r.sources[t].operand == 0 ? a : b;
    const Triangle& face = m.triangles[r.sources[t].face];
    bool same = true;
    for (std::size_t i = 0; i < 3; ++i) same = same && r.mesh.vertices[r.mesh.triangles[t][i]] == m.vertices[face[i]];
    whole += same;
  }
  CHECK(whole > r.mesh.triangles.size() / 2);
}

TEST_CASE("every triangle lies in the plane of its source", "[csg][property]") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    const auto operands = test::touching_pair(seed);
    std::vector<MeshView> views(operands.meshes.begin(), operands.meshes.end());
    const BooleanResult r =
        combine(Operation::symmetric_difference, std::span<const MeshView>(views), {.exact_vertices = true});
    CHECK(test::wrong_sources({r.mesh, r.exact}, r.sources, operands.meshes).empty());
  }
}

TEST_CASE("the same bytes for any number of threads", "[csg][property]") {
  const Mesh a = test::icosphere({0, 0, 0}, 1, 4), b = test::icosphere({.3, .2, .1}, 1, 4),
             c = box({-.5, -.5, -.5}, {.75, .5, .5});
  const std::vector<MeshView> operands{a, b, c};
  for (const Operation op : all_operations) {
    const BooleanResult one = combine(op, std::span<const MeshView>(operands), {.threads = 1});
    for (const unsigned threads : {2u, 8u}) {
      const BooleanResult many = combine(op, std::span<const MeshView>(operands), {.threads = threads});
      CHECK(one.mesh == many.mesh);
      CHECK(one.sources == many.sources);
    }
  }
}

TEST_CASE("results are exact operands of further operations", "[csg][property]") {
  const Solid a(test::icosphere({0, 0, 0}, 1, 1)), b(test::icosphere({.5, .25, .125}, 1, 1)),
      c(test::octahedron({.25, .5, .25}, 1));
  CHECK(((a | b) & c) == ((a & c) | (b & c)));
  CHECK((a - b - c) == (a - (b | c)));
  CHECK(((a ^ b) ^ b) == a);
  CHECK(((a - b) | (a & b)) == a);
}

TEST_CASE("laws hold on random touching solids", "[csg][property]") {
  for (std::uint64_t seed = 1000; seed < 1150; ++seed) {
    CAPTURE(seed);
    const auto operands = test::touching_pair(seed);
    const Solid a(operands.meshes[0]), b(operands.meshes[1]);
    const Solid u = a | b, i = a & b, d = a - b, x = a ^ b;
    CHECK(u.volume() + i.volume() == a.volume() + b.volume());
    CHECK(d.volume() + i.volume() == a.volume());
    CHECK(x.volume() + i.volume() == u.volume());
    CHECK(u == (b | a));
    CHECK(i == (b & a));
    CHECK((d | (b - a)) == x);
    CHECK((u - i) == x);
  }
}

// Deep inside many operands most faces are settled by one of them; step by step nothing is.
TEST_CASE("many operands at once give what one after the other gives", "[csg][property]") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    std::vector<Solid> all;
    for (int n = random.between(4, 9); n > 0; --n) all.emplace_back(test::lattice_solid(random));
    Solid u = all[0], i = all[0], d = all[0], x = all[0];
    for (std::size_t k = 1; k < all.size(); ++k) {
      u = u | all[k];
      i = i & all[k];
      d = d - all[k];
      x = x ^ all[k];
    }
    CHECK(union_(all) == u);
    CHECK(intersection(all) == i);
    CHECK(difference(all) == d);
    CHECK(symmetric_difference(all) == x);
  }
}

TEST_CASE("overlapping input is resolved: inside is where the winding number is positive", "[csg]") {
  Mesh two = box({0, 0, 0}, {2, 2, 2});
  const Mesh other = box({1, 1, 1}, {3, 3, 3});
  for (const Triangle& t : other.triangles) two.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  two.vertices.insert(two.vertices.end(), other.vertices.begin(), other.vertices.end());
  CHECK_FALSE(check(two).empty());
  const Solid resolved(two, InputClass::overlapping);
  CHECK(resolved.volume() == 15);
  CHECK(check(resolved.mesh()).empty());
  CHECK(resolved == (Solid(box({0, 0, 0}, {2, 2, 2})) | Solid(other)));
}

TEST_CASE("an operand that crosses itself where the other one cuts it is refused, with the faces", "[csg]") {
  Mesh two = box({0, 0, 0}, {2, 2, 2});
  const Mesh other = box({1, 1, 1}, {3, 3, 3});
  for (const Triangle& t : other.triangles) two.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  two.vertices.insert(two.vertices.end(), other.vertices.begin(), other.vertices.end());
  const Mesh cutter = box({1.5, 1.5, -1}, {1.75, 1.75, 4});
  const std::vector<MeshView> operands{cutter, two};
  try {
    (void)combine(Operation::difference, std::span<const MeshView>(operands), {.input = InputClass::solid});
    FAIL("accepted");
  } catch (const InputError& e) {
    CHECK(e.operand() == 1);
    REQUIRE_FALSE(e.defects().empty());
    CHECK(e.defects().front().kind == DefectKind::self_intersection);
    CHECK(e.defects().front().faces.size() == 2);
  }
}

TEST_CASE("what is no solid is refused with its defects", "[csg]") {
  Mesh open = box({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  CHECK_THROWS_AS(Solid(open), InputError);
  Mesh inside_out = box({0, 0, 0}, {1, 1, 1});
  for (Triangle& t : inside_out.triangles) std::swap(t[0], t[1]);
  CHECK_THROWS_AS(Solid(inside_out), InputError);
  CHECK_THROWS_AS(Solid(inside_out, InputClass::overlapping), InputError);  // not silently the empty solid
  Mesh wild = box({0, 0, 0}, {1, 1, 1});
  wild.vertices[3][1] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(Solid(wild), InputError);
  Mesh astray = box({0, 0, 0}, {1, 1, 1});
  astray.triangles[5][2] = 77;
  CHECK_THROWS_AS(Solid(astray), InputError);
  CHECK(Solid(inside_out, InputClass::repair).volume() == 1);
}

TEST_CASE("a shell that is inside out is found by the complete check", "[csg]") {
  Mesh nested = box({0, 0, 0}, {4, 4, 4});
  const Mesh inner = box({1, 1, 1}, {2, 2, 2});
  for (const Triangle& t : inner.triangles) nested.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  nested.vertices.insert(nested.vertices.end(), inner.vertices.begin(), inner.vertices.end());
  const auto defects = check(nested);  // winding number 2 inside the inner shell
  REQUIRE_FALSE(defects.empty());
  CHECK(defects.front().kind == DefectKind::inside_out);
  CHECK(check(Mesh(test::box_with_cavity(1))).empty());
}

TEST_CASE("an operation can be cancelled", "[csg]") {
  CancelToken cancel;
  cancel.cancel();
  const Mesh a = box({0, 0, 0}, {1, 1, 1});
  const std::vector<MeshView> operands{a, a};
  CHECK_THROWS_AS(combine(Operation::union_, std::span<const MeshView>(operands), {.cancel = &cancel}), Cancelled);
  CHECK_THROWS_AS(measure(ExactMesh{a, {}}, {.cancel = &cancel}), Cancelled);
}

TEST_CASE("progress grows from zero to one", "[csg]") {
  const Mesh a = test::icosphere({0, 0, 0}, 1, 2), b = test::icosphere({.5, 0, 0}, 1, 2);
  const std::vector<MeshView> operands{a, b};
  std::vector<double> seen;
  (void)combine(Operation::union_, std::span<const MeshView>(operands),
                {.progress = [&](double x) { seen.push_back(x); }});
  REQUIRE(seen.size() > 3);
  CHECK(std::is_sorted(seen.begin(), seen.end()));
  CHECK(seen.front() >= 0);
  CHECK(seen.back() == 1);
}
