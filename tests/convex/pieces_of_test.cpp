// Attributes of convex pieces.
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "attributes/painted.h"
#include "convex/decomposition_check.h"
#include "strata/check.h"
#include "support/random.h"
#include "support/rounds.h"
#include "support/shapes.h"
#include "support/touching.h"

namespace strata::test {
namespace {

using convex::decompose;
using convex::Decomposition;
using convex::pieces_of;

using Faces = std::vector<std::array<RationalPoint, 3>>;

Faces faces_of(const Solid& solid) {
  Faces faces;
  for (std::size_t f = 0; f < solid.mesh().triangles.size(); ++f) faces.push_back(corners_of(solid.exact_mesh(), f));
  return faces;
}

/// A solid with an affine function of position on corners, vertices and as floats, directions, and a number per face.
Solid with_channels(const Solid& solid) {
  const Mesh& mesh = solid.mesh();
  Attributes attributes;
  attributes.channels = {places(mesh), identifiers(mesh, 0)};
  std::vector<double> heights;
  for (const Vertex& v : mesh.vertices) heights.push_back(v[2]);
  attributes.channels.push_back({"height", Element::vertex, Interpolation::linear, 1, std::move(heights)});
  attributes.channels.push_back(
      {"normal", Element::face, Interpolation::spherical, 3, std::vector<float>(3 * mesh.triangles.size(), 0.5F)});
  attributes.channels.push_back(
      {"material", Element::face, Interpolation::nearest, 1, std::vector<std::int32_t>(mesh.triangles.size(), 0)});
  attributes.materials.emplace_back().name = "paint";
  return solid.with_attributes(std::move(attributes));
}

/// The value is the nearest double of the coordinate, give or take one unit of the largest: places were rounded before.
bool is_near(double value, double coordinate, double size) {
  return std::abs(value - coordinate) <= std::nextafter(size, HUGE_VAL) - size;
}

/// Corners of the solid's triangles have their places, others none; empty if all is right.
std::string fault_of_places(const Solid& piece, double size) {
  const auto& at = values_of<double>(piece.attributes(), "place");
  const auto& heights = values_of<double>(piece.attributes(), "height");
  const auto& numbers = values_of<std::int32_t>(piece.attributes(), "identifier");
  for (std::size_t t = 0; t < piece.sources().size(); ++t) {
    const bool is_wall = piece.sources()[t].operand == 1;
    if (numbers[t] != (is_wall ? -1 : static_cast<std::int32_t>(piece.sources()[t].face))) return "an identifier";
    for (std::size_t c = 3 * t; c < 3 * t + 3; ++c) {
      const Vertex& v = piece.mesh().vertices[piece.mesh().triangles[t][c % 3]];
      for (std::size_t i = 0; i < 3; ++i)
        if (!(is_wall ? at[3 * c + i] == 0 : is_near(at[3 * c + i], v[i], size))) return "a place";
      const bool is_on_vertices = piece.attributes().find("height")->element == Element::vertex;
      const double height = heights[is_on_vertices ? piece.mesh().triangles[t][c % 3] : c];
      if (!(is_wall ? height == 0 : is_near(height, v[2], size))) return "a height";
    }
  }
  return {};
}

/// The triangles of a piece from the solid lie in their sources, those from walls in theirs.
bool are_in_their_sources(const Solid& piece, const Faces& faces, const Decomposition& d) {
  for (std::size_t t = 0; t < piece.sources().size(); ++t) {
    const Source& s = piece.sources()[t];
    for (const RationalPoint& p : corners_of(piece.exact_mesh(), t)) {
      if (s.operand == 0 && !is_in(faces.at(s.face), p)) return false;
      if (s.operand == 0) continue;
      const std::vector<std::uint32_t>& wall = d.walls.at(s.face).polygon;
      bool is_in_wall = false;
      for (std::size_t k = 2; k < wall.size(); ++k)
        is_in_wall = is_in_wall || is_in({d.position(wall[0]), d.position(wall[k - 1]), d.position(wall[k])}, p);
      if (!is_in_wall) return false;
    }
  }
  return true;
}

/// Checks all that `pieces_of` says.
std::vector<Solid> checked(const Solid& given) {
  const Solid solid = with_channels(given);
  const Decomposition d = decompose(solid);
  Material cut;
  cut.name = "cut";
  std::vector<Solid> pieces = pieces_of(solid, d, {.cut_material = &cut});
  REQUIRE(pieces.size() == d.pieces.size());
  double size = 1e-300;
  for (const Vertex& v : solid.mesh().vertices)
    for (const double x : v) size = std::max(size, std::abs(x));
  const Faces faces = faces_of(solid);
  for (std::uint32_t p = 0; p < pieces.size(); ++p) {
    CAPTURE(p);
    REQUIRE(check(pieces[p].exact_mesh()).empty());
    REQUIRE(pieces[p] == convex::solid_of(d.polytope(p)));
    REQUIRE(are_in_their_sources(pieces[p], faces, d));
    REQUIRE(fault_of_places(pieces[p], size).empty());
    const auto& materials = values_of<std::int32_t>(pieces[p].attributes(), "material");
    for (std::size_t t = 0; t < materials.size(); ++t)
      REQUIRE(pieces[p].attributes().materials.at(static_cast<std::size_t>(materials[t])).name ==
              (pieces[p].sources()[t].operand == 1 ? "cut" : "paint"));
  }
  return pieces;
}

/// A slab with a comb of slots in its top and another across in its bottom: sides of pieces meet in many points.
Solid slotted(int slots) {
  const double length = 2.0 * slots + 1;
  std::vector<Solid> solids{Solid(box({0, 0, 0}, {length, length, 4}))};
  for (int k = 0; k < slots; ++k) {
    solids.emplace_back(box({2.0 * k + 1, -1, 3}, {2.0 * k + 2, length + 1, 5}));
    solids.emplace_back(box({-1, 2.0 * k + 1, -1}, {length + 1, 2.0 * k + 2, 1}));
  }
  return difference(solids);
}

}  // namespace

// Catches: values of another face, a wall with values of a face, sides that are not divided, triangles without area.
TEST_CASE("pieces have the values of the faces that they have of the solid", "[convex][attributes]") {
  checked(Solid(l_shape()));
  checked(Solid(box_with_hole()));
  checked(Solid(box_with_cavity(2)));
  checked(Solid(edge_sharing_cells()));
  checked(Solid(vertex_sharing_cells()));
  for (const int slots : {1, 3}) checked(slotted(slots));
  for (const int copies : {2, 3}) checked(Solid(cube_grid(copies)));
}

TEST_CASE("affine functions stay what they are, and identifiers name their faces, through decompositions",
          "[convex][attributes][property]") {
  for (std::uint64_t seed = 0; seed < rounds(100); ++seed) {
    CAPTURE(seed);
    const Operands pair = touching_pair(seed);
    checked(Solid(pair.meshes[0]) | Solid(pair.meshes[1]));
    checked(Solid(pair.meshes[0]) - Solid(pair.meshes[1]));
    Random random(seed);
    checked(Solid(kuhn_solid(random, {2, 2, 2}, 2)));
  }
}

TEST_CASE("pieces of pieces of random chains keep affine functions and identifiers", "[convex][attributes][property]") {
  for (std::uint64_t seed = 0; seed < rounds(40); ++seed) {
    CAPTURE(seed);
    const Operands pair = touching_pair(seed);
    const Solid solid = painted(pair.meshes[0], 0);
    const Faces faces = faces_of(solid);
    const Solid rest = solid - Solid(pair.meshes[1]).with_attributes({});
    std::vector<Solid> pieces;
    for (const Solid& piece : pieces_of(rest, decompose(rest))) {
      const Solid part = piece & Solid(pair.meshes[0]).scaled(Rational(2, 3));
      for (Solid& p : pieces_of(part, decompose(part))) pieces.push_back(std::move(p));
    }
    for (const Solid& piece : pieces) {
      const auto* numbers = std::get_if<std::vector<std::int32_t>>(&piece.attributes().find("identifier")->values);
      REQUIRE(numbers != nullptr);
      const auto& at = values_of<double>(piece.attributes(), "place");
      for (std::size_t t = 0; t < numbers->size(); ++t) {
        if ((*numbers)[t] < 0) continue;
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t v = piece.mesh().triangles[t][k];
          REQUIRE(is_in(faces.at(static_cast<std::size_t>((*numbers)[t])), piece.exact_mesh().position(v)));
          for (std::size_t i = 0; i < 3; ++i) {
            const double x = piece.mesh().vertices[v][i];
            REQUIRE(at[3 * (3 * t + k) + i] == Approx(x).epsilon(0).margin(4e-15 * 16));
          }
        }
      }
    }
  }
}

TEST_CASE("rational vertices and scales beyond reason carry attributes to pieces", "[convex][attributes][degenerate]") {
  for (std::uint64_t seed = 0; seed < rounds(20); ++seed) {
    CAPTURE(seed);
    const Operands pair = touching_pair(seed);
    const Transform thirds(Transform::scaling({Rational(1, 3), Rational(2, 7), 1}) *
                           Transform::translation({Rational(1, 9), 0, Rational(-5, 11)}));
    checked((Solid(pair.meshes[0]) - Solid(pair.meshes[1])).transformed(thirds));
  }
}

TEST_CASE("a convex piece keeps a channel on vertices, walls make it one on corners", "[convex][attributes]") {
  const auto element = [](const Mesh& mesh) {
    const Solid solid = with_channels(Solid(mesh));
    return pieces_of(solid, decompose(solid)).front().attributes().find("height")->element;
  };
  CHECK(element(octahedron({0, 0, 0}, 2)) == Element::vertex);
  CHECK(element(l_shape()) == Element::corner);
}

TEST_CASE("walls have the normals of their faces", "[convex][attributes]") {
  const Solid solid = with_channels(Solid(l_shape()));
  for (const Solid& piece : pieces_of(solid, decompose(solid))) {
    const Channel* normal = piece.attributes().find("normal");
    const auto& values = std::get<std::vector<float>>(normal->values);
    for (std::size_t t = 0; t < piece.sources().size(); ++t) {
      if (piece.sources()[t].operand == 0) continue;
      const auto corners = corners_of(piece.exact_mesh(), t);
      Rational along = 0;  // of a vector in the wall's plane, then of the outward side
      for (std::size_t i = 0; i < 3; ++i) along += to_rational(values[3 * t + i]) * (corners[1][i] - corners[0][i]);
      CHECK(along == 0);  // walls of this solid are perpendicular to axes
      CHECK(std::abs(values[3 * t]) + std::abs(values[3 * t + 1]) + std::abs(values[3 * t + 2]) == 1);
    }
  }
}

TEST_CASE("pieces of nothing are none, and of a solid that carries nothing carry nothing", "[convex][attributes]") {
  CHECK(pieces_of(Solid(), decompose(Solid())).empty());
  const Solid solid(l_shape());
  for (const Solid& piece : pieces_of(solid, decompose(solid))) CHECK(piece.attributes().empty());
}

TEST_CASE("pieces with attributes are the same for any number of threads", "[convex][attributes]") {
  const Solid solid = with_channels(slotted(3));
  const Decomposition d = decompose(solid);
  const auto one = pieces_of(solid, d, {.threads = 1}), all = pieces_of(solid, d, {.threads = 4});
  REQUIRE(one.size() == all.size());
  for (std::size_t p = 0; p < one.size(); ++p) {
    CHECK(one[p].mesh().triangles == all[p].mesh().triangles);
    CHECK(one[p].attributes() == all[p].attributes());
  }
}

}  // namespace strata::test
