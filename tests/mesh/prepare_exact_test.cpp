#include <catch2/catch.hpp>
#include <stdexcept>

#include "core/mesh/prepare.h"
#include "shapes.h"

using namespace strata;

namespace {

const Rational tiny(1, Integer(1) << 2000);

/// The mesh with one coordinate of a vertex moved by less than doubles tell.
ExactMesh nudged(const Mesh& mesh, std::uint32_t vertex, std::size_t axis, const Rational& by) {
  ExactMesh result{mesh, {}};
  result.exact.push_back({vertex, result.position(vertex)});
  result.exact[0].position[axis] += by;
  return result;
}

bool is_refused(const ExactMesh& mesh, DefectKind kind) {
  try {
    (void)prepare_exact(mesh, 3);
  } catch (const InputError& error) {
    return error.operand() == 3 && error.defects().front().kind == kind;
  }
  return false;
}

/// Corner a is moved out of the plane of the others, which has it in doubles.
Mesh flat_tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {.25, .25, 0}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

}  // namespace

TEST_CASE("the orientation of rational meshes is seen below the last bit of doubles", "[mesh]") {
  CHECK(orientation({shapes::box({0, 0, 0}, {1, 1, 1}), {}}) == Sign::positive);
  CHECK(orientation({flat_tetrahedron(), {}}) == Sign::zero);
  CHECK(orientation(nudged(flat_tetrahedron(), 3, 2, tiny)) == Sign::positive);
  CHECK(orientation(nudged(flat_tetrahedron(), 3, 2, -tiny)) == Sign::negative);
}

TEST_CASE("a rational mesh is accepted by its exact places", "[mesh]") {
  const Prepared prepared = prepare_exact(nudged(flat_tetrahedron(), 3, 2, tiny));
  CHECK_FALSE(prepared.mesh);
  CHECK(prepared.notes.empty());
  CHECK(is_refused(nudged(flat_tetrahedron(), 3, 2, -tiny), DefectKind::inside_out));
}

TEST_CASE("zero area is decided by exact places, and refused among rationals", "[mesh]") {
  Mesh needle = flat_tetrahedron();
  needle.vertices[3] = {.5, 0, 0};  // on the side from 0 to 1
  CHECK(is_refused(nudged(needle, 2, 2, tiny), DefectKind::degenerate_triangle));
  CHECK(is_refused(nudged(needle, 3, 1, -tiny), DefectKind::inside_out) ==
        is_refused(nudged(needle, 3, 1, tiny), DefectKind::inside_out));  // flat, but no triangle is
  CHECK_NOTHROW(prepare_exact(nudged(needle, 3, 2, tiny)));
  for (const Defect& d : diagnose(nudged(needle, 2, 2, tiny))) CHECK(d.remedy.find("repair") == std::string::npos);
}

TEST_CASE("rational vertices listed twice are joined where they are equal exactly", "[mesh]") {
  const Mesh parts = shapes::shattered(flat_tetrahedron());
  ExactMesh mesh{parts, {}};
  for (std::uint32_t v = 0; v < parts.vertices.size(); ++v)
    if (parts.vertices[v][0] == .25) mesh.exact.push_back({v, {Rational(1, 4), Rational(1, 4), tiny}});
  REQUIRE(mesh.exact.size() == 3);
  const Prepared prepared = prepare_exact(mesh);
  REQUIRE(prepared.mesh);
  CHECK(prepared.notes.front().count == 8);
  CHECK(prepared.source_face == std::vector<std::uint32_t>{0, 1, 2, 3});
  mesh.exact.back().position[2] += tiny;
  CHECK(is_refused(mesh, DefectKind::open_edge));
}

TEST_CASE("an exact place of a vertex that is not there is not looked at", "[mesh]") {
  ExactMesh mesh{shapes::box({0, 0, 0}, {1, 1, 1}), {}};
  mesh.exact = {{1u << 30, {Rational(1, 3), 0, 0}}};
  CHECK_THROWS_AS(diagnose(mesh), std::invalid_argument);
  mesh.exact = {{2, mesh.position(2)}, {2, mesh.position(2)}};
  CHECK_THROWS_AS(diagnose(mesh), std::invalid_argument);
}

TEST_CASE("exact places that are not those of the mesh are the caller's error", "[mesh]") {
  ExactMesh mesh = nudged(shapes::box({0, 0, 0}, {1, 1, 1}), 3, 2, tiny);
  CHECK_NOTHROW(prepare_exact(mesh));
  mesh.exact.push_back(mesh.exact.front());
  CHECK_THROWS_AS(prepare_exact(mesh), std::invalid_argument);
  mesh = nudged(shapes::box({0, 0, 0}, {1, 1, 1}), 3, 2, Rational(1, 3));
  CHECK_THROWS_AS(prepare_exact(mesh), std::invalid_argument);
  mesh.exact = {{8, {}}};
  CHECK_THROWS_AS(prepare_exact(mesh), std::invalid_argument);
}
