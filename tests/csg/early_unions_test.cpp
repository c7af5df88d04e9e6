#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "core/csg/coincident_facets.h"
#include "core/csg/overlapping_operands.h"
#include "strata/strata.h"
#include "support/random.h"
#include "support/rounds.h"
#include "support/shapes.h"

using namespace strata;
using test::Random;

namespace {

/// A four-sided outline across a sweep, at a place of its path.
std::array<Vertex, 4> loop(double x, double y, double z) {
  return {{{x, y - 1, z}, {x, y, z - 1}, {x, y + 1, z}, {x, y, z + 1}}};
}

/// The piece of a sweep between two outlines; neighbours have caps with the same corners.
Mesh piece(const std::array<Vertex, 4>& from, const std::array<Vertex, 4>& to) {
  Mesh mesh;
  mesh.vertices.assign(from.begin(), from.end());
  mesh.vertices.insert(mesh.vertices.end(), to.begin(), to.end());
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t k = (i + 1) % 4;
    mesh.triangles.push_back({i, k + 4, i + 4});
    mesh.triangles.push_back({i, k, k + 4});
  }
  for (const Triangle& t : {Triangle{0, 1, 2}, Triangle{0, 2, 3}}) {
    mesh.triangles.push_back({t[0], t[2], t[1]});
    mesh.triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
  }
  return mesh;
}

/// A sweep in pieces along x, which wanders across.
std::vector<Mesh> sweep(Random& random, int pieces) {
  std::vector<Mesh> meshes;
  auto at = loop(0, random.between(-2, 2), random.between(-2, 2));
  for (int i = 0; i < pieces; ++i) {
    const auto next = loop(2 * i + 2, random.between(-2, 2), random.between(-2, 2));
    meshes.push_back(piece(at, next));
    at = next;
  }
  return meshes;
}

std::vector<Operand> operands_of(const std::vector<Mesh>& meshes) {
  std::vector<Operand> operands;
  for (const Mesh& m : meshes) operands.push_back({MeshView(m), {}, false});
  return operands;
}

std::vector<std::uint32_t> numbers(std::size_t count) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t o = 0; o < count; ++o) all.push_back(o);
  return all;
}

CanonicalForm form_of(const BooleanResult& r) { return canonical_form(ExactMesh{r.mesh, r.exact}); }

RationalPoint place(const BooleanResult& r, std::uint32_t vertex) {
  const auto e = std::lower_bound(r.exact.begin(), r.exact.end(), vertex,
                                  [](const ExactVertex& x, std::uint32_t v) { return x.vertex < v; });
  if (e != r.exact.end() && e->vertex == vertex) return e->position;
  const Vertex& v = r.mesh.vertices[vertex];
  return {to_rational(v[0]), to_rational(v[1]), to_rational(v[2])};
}

/// Every triangle of a result lies in the plane of the face it is said to come from.
void check_sources(const BooleanResult& r, const std::vector<Mesh>& meshes) {
  REQUIRE(r.sources.size() == r.mesh.triangles.size());
  std::size_t off = 0;
  for (std::size_t t = 0; t < r.sources.size(); ++t) {
    const Mesh& mesh = meshes[r.sources[t].operand];
    RationalPoint p[3];
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) p[i][k] = to_rational(mesh.vertices[mesh.triangles[r.sources[t].face][i]][k]);
    for (const std::uint32_t v : r.mesh.triangles[t]) {
      const RationalPoint q = place(r, v);
      Rational m[3][3];
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) m[i][k] = (i == 0 ? q[k] : p[i][k]) - p[0][k];
      const Rational det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
      off += det != 0;
    }
  }
  CHECK(off == 0);
}

/// (first operand) - (union of the middle ones) ^ (union of the last `count`).
Formula mixed_formula(std::uint32_t operands, std::uint32_t count) {
  Formula f(operands);
  std::vector<Formula::Term> middle, last;
  for (std::uint32_t o = 1; o < operands; ++o) (o + count < operands ? middle : last).push_back(f.operand(o));
  const Formula::Term some_middle = f.join(Formula::Join::any, middle), some_last = f.join(Formula::Join::any, last);
  const std::vector<Formula::Term> difference{f.operand(0), !some_middle};
  const std::vector<Formula::Term> whole{f.join(Formula::Join::all, difference), some_last};
  f.close(f.join(Formula::Join::odd, whole));
  return f;
}

/// An operation or a formula: in stages as it is all at once, which overlapping operands are.
template <class AnyRule>
void check_rule(const std::vector<Mesh>& meshes, const AnyRule& rule) {
  const auto operands = operands_of(meshes);
  const Options together{.input = InputClass::overlapping, .exact_vertices = true}, staged{.exact_vertices = true};
  const BooleanResult r = combine(rule, std::span<const Operand>(operands), staged);
  REQUIRE(form_of(r) == form_of(combine(rule, std::span<const Operand>(operands), together)));
  check_sources(r, meshes);
}

}  // namespace

TEST_CASE("pieces of a sweep have walls in common, other neighbours have none", "[csg]") {
  Random random(1);
  std::vector<Mesh> meshes = sweep(random, 5);
  meshes.push_back(test::box({0, 10, 10}, {1, 11, 11}));
  meshes.push_back(test::box({1, 10, 10}, {2, 12, 12}));  // touches in a part of a side
  meshes.push_back(test::box({0, 10, 10}, {1, 11, 11}));  // the same as one: its faces look the same way
  for (const Mesh& m : sweep(random, 40)) meshes.push_back(m);
  for (std::size_t i = 8; i < meshes.size(); ++i)
    for (Vertex& v : meshes[i].vertices) v[2] += 100;
  const std::vector<Operand> operands = operands_of(meshes);
  const auto groups = groups_with_coincident_facets(operands, boxes_of(operands, numbers(meshes.size())));
  REQUIRE(groups.size() == 2);  // what is more than half of all is not grouped: 32 of 48 are not, the rest of them are
  CHECK(groups[0] == std::vector<std::uint32_t>{0, 1, 2, 3, 4});
  CHECK(groups[1].size() == 8);
  CHECK(groups_with_coincident_facets(operands, boxes_of(operands, std::vector<std::uint32_t>{0, 2, 4, 6})).empty());
  CancelToken token;
  token.cancel();
  CHECK_THROWS_AS(groups_with_coincident_facets(operands, boxes_of(operands, numbers(meshes.size())), Monitor(&token)),
                  Cancelled);
}

// Catches: faces that are lost, or go to different buckets, where there are enough to be divided.
TEST_CASE("walls are found among many faces", "[csg]") {
  Random random(3);
  const std::vector<Mesh> meshes = sweep(random, 1500);  // 18,000 faces
  const std::vector<Operand> operands = operands_of(meshes);
  const auto groups = groups_with_coincident_facets(operands, boxes_of(operands, numbers(meshes.size())));
  REQUIRE(groups.size() == (meshes.size() + 31) / 32);
  for (std::size_t o = 0; o < meshes.size(); ++o) {
    REQUIRE(o % 32 < groups[o / 32].size());
    CHECK(groups[o / 32][o % 32] == o);
  }
}

TEST_CASE("only operands that overlap most others are a crowd", "[csg]") {
  std::vector<Mesh> meshes;
  for (int i = 0; i < 30; ++i) meshes.push_back(test::box({i + 0., 0, 0}, {i + 40., 1, 1}));  // all over x = 30
  CHECK(groups_of_overlapping_operands(boxes_of(operands_of(meshes), numbers(16))).empty());
  const auto groups = groups_of_overlapping_operands(boxes_of(operands_of(meshes), numbers(30)));
  REQUIRE(groups.size() == 4);
  std::vector<std::uint32_t> members;
  for (const auto& group : groups) {
    CHECK(std::is_sorted(group.begin(), group.end()));
    CHECK(group.size() <= 13);
    CHECK(group.back() - group.front() == group.size() - 1);  // neighbours
    members.insert(members.end(), group.begin(), group.end());
  }
  std::sort(members.begin(), members.end());
  CHECK(members == numbers(30));
  for (int i = 0; i < 40; ++i) meshes.push_back(test::box({2 * i + 100., 0, 0}, {2 * i + 101., 1, 1}));  // apart
  CHECK(groups_of_overlapping_operands(boxes_of(operands_of(meshes), numbers(70))).empty());
}

// Catches: members that are united twice or lost, unions of what is no union, sources that name the wrong operand.
TEST_CASE("operands that are united first give what all together give", "[csg][property]") {
  for (std::uint64_t seed = 0; seed < test::rounds(25); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<Mesh> meshes{test::box({-1, -3, -3}, {7, 3, 3})};
    for (int s = 0; s < 3; ++s)
      for (Mesh& m : sweep(random, 4)) meshes.push_back(std::move(m));
    for (const Operation op :
         {Operation::union_, Operation::difference, Operation::intersection, Operation::symmetric_difference}) {
      CAPTURE(static_cast<int>(op));
      check_rule(meshes, op);
    }
    check_rule(meshes, mixed_formula(13, 4));
  }
}

TEST_CASE("crowds that are united in groups give what all together give", "[csg][property]") {
  for (std::uint64_t seed = 0; seed < test::rounds(4); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<Mesh> meshes;
    for (int i = 0; i < 36; ++i) {
      const auto about = [&] { return i % 2 == 0 ? random.between(-2, 2) : 4 * random.unit() - 2; };
      meshes.push_back(test::octahedron({about(), about(), about()}, 4 + random.between(0, 2)));
    }
    check_rule(meshes, mixed_formula(36, 18));
  }
}

TEST_CASE("unions of neighbours do not depend on the number of threads", "[csg]") {
  Random random(7);
  std::vector<Mesh> meshes{test::box({-1, -3, -3}, {30, 3, 3})};
  for (int s = 0; s < 6; ++s)
    for (Mesh& m : sweep(random, 14)) meshes.push_back(std::move(m));
  const auto operands = operands_of(meshes);
  const BooleanResult one = combine(Operation::difference, std::span<const Operand>(operands), {.threads = 1}),
                      two = combine(Operation::difference, std::span<const Operand>(operands), {.threads = 2});
  CHECK(one.mesh.vertices == two.mesh.vertices);
  CHECK(one.mesh.triangles == two.mesh.triangles);
  CHECK(one.sources == two.sources);
}

TEST_CASE("an operand with a wall in common that is no solid is named", "[csg]") {
  Random random(2);
  std::vector<Mesh> meshes;
  for (int s = 0; s < 3; ++s)
    for (Mesh& m : sweep(random, 4)) meshes.push_back(std::move(m));
  meshes[6].triangles.erase(meshes[6].triangles.begin());
  meshes[10].triangles.erase(meshes[10].triangles.begin());
  try {
    (void)combine(Operation::union_, std::span<const Operand>(operands_of(meshes)));
    FAIL("an open operand was accepted");
  } catch (const InputError& e) {
    CHECK(e.operand() == 6);
  }
}
