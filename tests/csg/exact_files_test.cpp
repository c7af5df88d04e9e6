// Results of results through files: what is written to XOFF and read again is the same, exactly; and rational vertices
// that come from anywhere are checked before they are used.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <iostream>
#include <ostream>
#include <stdexcept>

#include "core/system/program.h"
#include "csg/recipe_solids.h"
#include "strata/io.h"
#include "strata/strata.h"
#include "support/random_recipe.h"
#include "support/rounds.h"
#include "support/shapes.h"
#include "support/touching.h"

using namespace strata;

namespace {

ExactMesh through_file(const ExactMesh& mesh) {
  const std::string text = to_string(mesh, Format::xoff);
  MeshFile file = read_mesh(std::string_view(text), Format::xoff, "memory");
  return {std::move(file.mesh), std::move(file.exact)};
}

/// The same through a file that has a name.
ExactMesh through_named_file(const ExactMesh& mesh) {
  const auto path =
      std::filesystem::temp_directory_path() / ("strata-" + std::to_string(system::process_number()) + ".xoff");
  (void)write_mesh(path, mesh);
  MeshFile file = read_mesh(path);
  std::filesystem::remove(path);
  return {std::move(file.mesh), std::move(file.exact)};
}

/// Solids in no special position, with coordinates that are no nice numbers, about a common middle.
std::vector<ExactMesh> general_solids(test::Random& random) {
  std::vector<ExactMesh> solids;
  for (int n = random.between(2, 4); n > 0; --n) {
    const auto coordinate = [&] { return 2 * random.unit() - 1; };
    const Vertex middle{coordinate(), coordinate(), coordinate()};
    const Mesh ball = test::icosphere(middle, 1 + random.unit(), 0);
    std::array<Vertex, 4> corners;
    for (Vertex& v : corners)
      for (double& x : v) x = 3 * coordinate();
    const Mesh mesh = random.once_in(2) ? ball : test::tetrahedron(corners[0], corners[1], corners[2], corners[3]);
    solids.push_back(random.once_in(3) ? mapped(mesh, test::map_by_thirds(random)) : ExactMesh{mesh, {}});
  }
  return solids;
}

/// One to four operations, about solids that touch or, one time in eight, in general position.
test::Recipe few_operations(std::uint64_t seed) {
  constexpr test::RecipeSize size{.solids = 5, .leaves = 5, .depth = 5};
  if (seed % 8 != 0) return test::touching_recipe(seed + 50'000, size);
  test::Random random(seed);
  auto solids = general_solids(random);
  return test::random_recipe(random, std::move(solids), size);
}

std::size_t largest_digits(const ExactMesh& mesh) {
  std::size_t most = 0;
  for (const ExactVertex& e : mesh.exact)
    for (const Rational& x : e.position) most = std::max(most, x.str().size());
  return most;
}

bool same(const ExactMesh& a, const ExactMesh& b) {
  return a.mesh == b.mesh && std::equal(a.exact.begin(), a.exact.end(), b.exact.begin(), b.exact.end(),
                                        [](const ExactVertex& p, const ExactVertex& q) {
                                          return p.vertex == q.vertex && p.position == q.position;
                                        });
}

/// Rational numbers for coordinates: a solid that no doubles hold.
ExactMesh in_thirds(const Mesh& mesh) {
  ExactMesh result{mesh, {}};
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    RationalPoint p;
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = to_rational(mesh.vertices[v][i]) / 3;
      result.mesh.vertices[v][i] = to_nearest_double(p[i]);
    }
    result.exact.push_back({v, p});
  }
  return result;
}

/// Both meshes as one.
ExactMesh joined(ExactMesh a, const ExactMesh& b) {
  const auto first = static_cast<std::uint32_t>(a.mesh.vertices.size());
  a.mesh.vertices.insert(a.mesh.vertices.end(), b.mesh.vertices.begin(), b.mesh.vertices.end());
  for (const Triangle& t : b.mesh.triangles) a.mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  for (const ExactVertex& e : b.exact) a.exact.push_back({e.vertex + first, e.position});
  return a;
}

std::vector<DefectKind> errors_of(const ExactMesh& mesh) {
  std::vector<DefectKind> kinds;
  for (const Defect& d : check(mesh))
    if (d.severity == Severity::error) kinds.push_back(d.kind);
  return kinds;
}

}  // namespace

TEST_CASE("results survive files exactly", "[csg][xoff][property]") {
  std::size_t rational = 0;
  constexpr std::uint64_t count = test::rounds(1000);
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    CAPTURE(seed);
    const auto operands = test::touching_pair(seed);
    const Solid a(operands.meshes[0]), b(operands.meshes[1]);
    const Operation operation = std::array{Operation::union_, Operation::intersection, Operation::difference,
                                           Operation::symmetric_difference}[seed % 4];
    const Solid both[] = {a, b};
    const Solid result = combine_solids(operation, both);
    const ExactMesh read = through_file(result.exact_mesh());
    REQUIRE(same(read, result.exact_mesh()));
    const Solid again(read);
    CHECK(again.volume() == result.volume());
    REQUIRE(again.canonical() == result.canonical());
    rational += !read.exact.empty();
  }
  CHECK(rational * 10 > count);
}

// Catches: numerators and denominators cut short, vertices moved to the next double, exact places of the wrong vertex.
TEST_CASE("results of several operations about rational solids survive files exactly", "[csg][xoff][property]") {
  std::size_t rational = 0, empty = 0, digits = 0;
  constexpr std::uint64_t count = test::rounds(1000);
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    CAPTURE(seed);
    const auto recipe = few_operations(seed);
    const Solid result = test::by_steps(recipe, test::solids_of(recipe));
    const ExactMesh read = seed % 3 == 0 ? through_named_file(result.exact_mesh()) : through_file(result.exact_mesh());
    REQUIRE(same(read, result.exact_mesh()));
    REQUIRE(to_string(read, Format::xoff) == to_string(result.exact_mesh(), Format::xoff));
    const Solid again(read);
    REQUIRE(again.canonical() == result.canonical());
    REQUIRE(Solid(through_file((again | again).exact_mesh())) == result);
    rational += !read.exact.empty();
    empty += result.is_empty();
    digits = std::max(digits, largest_digits(read));
  }
  std::cout << count << " results through XOFF: " << rational << " with rational vertices, of up to " << digits
            << " digits; " << empty << " empty\n";
  CHECK(rational * 4 > count);
  CHECK(empty * 3 < count);
  CHECK(digits > 200);
}

TEST_CASE("a chain of operations through files is the chain without them", "[csg][xoff][property]") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    const auto operands = test::touching_operands(seed);
    Solid straight(operands.meshes[0]);
    ExactMesh stored = straight.exact_mesh();
    for (std::size_t k = 1; k < operands.meshes.size(); ++k) {
      const Operation operation = (seed + k) % 2 == 0 ? Operation::symmetric_difference : Operation::union_;
      const Solid both[] = {straight, Solid(operands.meshes[k])};
      straight = combine_solids(operation, both);
      stored = through_file(stored);
      const Operand raw[] = {{stored.mesh, stored.exact}, {operands.meshes[k], {}}};
      BooleanResult result = combine(operation, std::span<const Operand>(raw), {.exact_vertices = true});
      stored = {std::move(result.mesh), std::move(result.exact)};
    }
    REQUIRE(canonical_form(stored) == straight.canonical());
    CHECK(check(through_file(stored)).empty() == check(straight.exact_mesh()).empty());
  }
}

TEST_CASE("rational meshes are checked completely", "[csg][xoff]") {
  const Mesh box = test::box({0, 0, 0}, {1, 1, 1});
  CHECK(check(in_thirds(box)).empty());
  ExactMesh open = in_thirds(box);
  open.mesh.triangles.pop_back();
  CHECK(errors_of(open).front() == DefectKind::open_edge);
  ExactMesh turned = in_thirds(box);
  for (Triangle& t : turned.mesh.triangles) std::swap(t[0], t[1]);
  CHECK(errors_of(turned).front() == DefectKind::inside_out);
  ExactMesh flat = in_thirds(test::box({0, 0, 0}, {1, 1, 0}));
  CHECK(errors_of(flat).front() == DefectKind::degenerate_triangle);
  const ExactMesh crossing = joined(in_thirds(box), in_thirds(test::box({.5, .5, .5}, {2, 2, 2})));
  CHECK(errors_of(crossing).front() == DefectKind::self_intersection);
  const ExactMesh nested = joined(in_thirds(test::box({-1, -1, -1}, {2, 2, 2})), in_thirds(box));
  CHECK(errors_of(nested).front() == DefectKind::inside_out);
  for (const ExactMesh& bad : {open, turned, flat}) {
    CHECK_THROWS_AS(Solid(bad), InputError);
    CHECK_THROWS_AS(Solid(bad, InputClass::overlapping), InputError);
    CHECK_THROWS_AS(Solid(bad, InputClass::repair), InputError);
    const Operand operands[] = {{box, {}}, {bad.mesh, bad.exact}};
    CHECK_THROWS_AS(combine(Operation::union_, std::span<const Operand>(operands)), InputError);
  }
}

// Solids closer to one another than doubles tell: rounded they would touch, cross or turn over.
TEST_CASE("differences far below the last bit of doubles are seen in rational meshes", "[csg][xoff]") {
  const Rational tiny(1, Integer(1) << 3000);
  ExactMesh a = in_thirds(test::box({0, 0, 0}, {3, 3, 3})), b = in_thirds(test::box({3, 0, 0}, {6, 3, 3}));
  const auto shift = [&](ExactMesh& mesh, const Rational& by) {
    for (ExactVertex& e : mesh.exact) e.position[0] += by;
  };
  CHECK_FALSE(check(joined(a, b)).empty());  // a common face
  shift(b, tiny);
  CHECK(check(joined(a, b)).empty());
  CHECK(is_embedded(joined(a, b)));
  CHECK_FALSE(is_embedded(joined(a, b).mesh));
  CHECK((Solid(a) & Solid(b)).is_empty());
  CHECK_FALSE(Solid(a) == Solid(b));
  shift(b, -2 * tiny);
  CHECK((Solid(a) & Solid(b)).volume() == tiny);
  CHECK(Solid(joined(a, b), InputClass::overlapping) == (Solid(a) | Solid(b)));
  // A sheet as thin as that, which has no volume when rounded.
  ExactMesh sheet = in_thirds(test::box({0, 0, 0}, {0, 3, 3}));
  std::uint32_t moved = 0;
  const Mesh box = test::box({0, 0, 0}, {1, 3, 3});
  for (ExactVertex& e : sheet.exact)
    if (box.vertices[e.vertex][0] == 1) {
      e.position[0] += tiny;
      ++moved;
    }
  REQUIRE(moved == 4);
  CHECK(Solid(sheet).volume() == tiny);
  CHECK(check(sheet).empty());
  for (ExactVertex& e : sheet.exact) e.position[0] = -e.position[0];
  CHECK_THROWS_AS(Solid(sheet), InputError);
}

TEST_CASE("rational meshes that cross themselves are the union of their parts", "[csg][xoff][property]") {
  for (std::uint64_t seed = 0; seed < 80; ++seed) {
    CAPTURE(seed);
    const auto first = test::touching_pair(seed), second = test::touching_pair(seed + 7000);
    const Solid a = Solid(first.meshes[0]) - Solid(first.meshes[1]);
    const Solid b = Solid(second.meshes[0]) ^ Solid(second.meshes[1]);
    const ExactMesh both = joined(a.exact_mesh(), b.exact_mesh());
    CHECK(Solid(both, InputClass::overlapping) == (a | b));
    // Repair drops one of two faces that are the same in doubles.
    if (!both.exact.empty()) CHECK(Solid(both, InputClass::repair) == (a | b));
  }
}

TEST_CASE("seams of rational vertices are closed exactly", "[csg][xoff]") {
  const ExactMesh whole = in_thirds(test::box({0, 0, 0}, {1, 1, 1}));
  ExactMesh seams;
  for (const Triangle& t : whole.mesh.triangles) {
    for (const std::uint32_t v : t) {
      seams.exact.push_back({static_cast<std::uint32_t>(seams.mesh.vertices.size()), whole.position(v)});
      seams.mesh.vertices.push_back(whole.mesh.vertices[v]);
    }
    const auto n = static_cast<std::uint32_t>(seams.mesh.vertices.size());
    seams.mesh.triangles.push_back({n - 3, n - 2, n - 1});
  }
  CHECK(check(seams).empty());
  CHECK(Solid(seams) == Solid(whole));
  CHECK(Solid(seams).notes().size() == 1);
  seams.exact[5].position[1] += Rational(1, Integer(1) << 500);
  CHECK_THROWS_AS(Solid(seams), InputError);
}

TEST_CASE("exact places that do not belong to their mesh are refused", "[csg][xoff]") {
  ExactMesh mesh = in_thirds(test::box({0, 0, 0}, {1, 1, 1}));
  std::swap(mesh.exact[0], mesh.exact[1]);
  CHECK_THROWS_AS(Solid(mesh), std::invalid_argument);
  mesh = in_thirds(test::box({0, 0, 0}, {1, 1, 1}));
  mesh.exact[3].position[0] += Rational(1, 1000);
  CHECK_THROWS_AS(Solid(mesh), std::invalid_argument);
  mesh = in_thirds(test::box({0, 0, 0}, {1, 1, 1}));
  mesh.exact.back().vertex = 8;
  CHECK_THROWS_AS(Solid(mesh), std::invalid_argument);
}
