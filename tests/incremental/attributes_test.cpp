// Attributes through the steps of an incremental solid.
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "attributes/painted.h"
#include "strata/incremental.h"
#include "support/rounds.h"
#include "support/shapes.h"
#include "support/touching.h"

using namespace strata;
using test::Random;

namespace {

constexpr Operation operations[] = {Operation::union_, Operation::difference, Operation::symmetric_difference,
                                    Operation::intersection};

/// Places are those of the vertices where a triangle has an identifier, else 0.
bool has_places_where_painted(const Solid& solid) {
  const auto& places = test::values_of<double>(solid.attributes(), "place");
  const auto& numbers = test::values_of<std::int32_t>(solid.attributes(), "identifier");
  for (std::size_t t = 0; t < solid.mesh().triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) {
        const double x = solid.mesh().vertices[solid.mesh().triangles[t][k]][i];
        if (places[9 * t + 3 * k + i] != (numbers[t] == -1 ? 0 : x)) return false;
      }
  return true;
}

/// A solid with the faces of which every triangle that has an identifier must be a part.
struct Painting {
  std::vector<std::array<RationalPoint, 3>> faces;

  Solid paint(const Mesh& mesh) {
    const Solid solid = test::painted(mesh, static_cast<std::int32_t>(faces.size()));
    for (std::size_t f = 0; f < solid.mesh().triangles.size(); ++f)
      faces.push_back(test::corners_of(solid.exact_mesh(), f));
    return solid;
  }
  [[nodiscard]] bool fits(const Solid& solid) const {
    const auto& numbers = test::values_of<std::int32_t>(solid.attributes(), "identifier");
    for (std::size_t t = 0; t < numbers.size(); ++t)
      for (const RationalPoint& p : test::corners_of(solid.exact_mesh(), t))
        if (numbers[t] != -1 && !test::is_in(faces.at(static_cast<std::size_t>(numbers[t])), p)) return false;
    return true;
  }
};

}  // namespace

// Catches: the origin of another face after corners are removed, origins lost in a later step, the wrong tool's.
TEST_CASE("every triangle has the attributes of the face that it is a part of, after any steps",
          "[workpiece][attributes][property]") {
  for (std::uint64_t seed = 0; seed < test::rounds(60); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    Painting painting;
    Solid solid = painting.paint(test::lattice_solid(random));
    IncrementalSolid in_steps(solid);
    for (int i = 0; i < 10; ++i) {
      CAPTURE(i);
      std::vector<Solid> tools;
      for (std::size_t n = 1 + random.below(3); n > 0; --n) {
        const Mesh mesh = test::lattice_solid(random);
        tools.push_back(random.once_in(4) ? Solid(mesh) : painting.paint(mesh));
      }
      const Operation operation = random.once_in(12) ? operations[3] : operations[random.below(3)];
      in_steps = in_steps.with(operation, tools);
      tools.insert(tools.begin(), solid);
      solid = combine_solids(operation, tools);
      const Solid now = in_steps.solid();
      REQUIRE(now == solid);
      if (now.attributes().empty()) continue;
      REQUIRE(has_places_where_painted(now));
      REQUIRE(painting.fits(now));
    }
  }
}

TEST_CASE("one tool with attributes among others paints what it cuts, and nothing else", "[workpiece][attributes]") {
  Painting painting;
  const IncrementalSolid block(Solid(test::box({0, 0, 0}, {4, 4, 4})));
  CHECK(block.solid().attributes().empty());
  const Solid tool = painting.paint(test::box({1, 1, 3}, {2, 2, 5}));
  const Solid cut = block.with(Operation::difference, Solid(test::box({3, 3, 3}, {5, 5, 5})))
                        .with(Operation::difference, tool)
                        .solid();
  const auto& numbers = test::values_of<std::int32_t>(cut.attributes(), "identifier");
  for (std::size_t t = 0; t < numbers.size(); ++t) {
    const auto corners = test::corners_of(cut.exact_mesh(), t);
    const bool is_of_tool = std::all_of(corners.begin(), corners.end(), [](const RationalPoint& p) {
      return p[0] >= 1 && p[0] <= 2 && p[1] >= 1 && p[1] <= 2;
    });
    CHECK((numbers[t] >= 0) == is_of_tool);
  }
  CHECK(painting.fits(cut));
  CHECK(has_places_where_painted(cut));
}

TEST_CASE("cut surfaces of an incremental solid have the material that is asked for", "[workpiece][attributes]") {
  const Mesh box = test::box({0, 0, 0}, {4, 4, 4});
  Attributes attributes;
  attributes.materials.resize(1);
  attributes.channels = {{"material", Element::face, Interpolation::nearest, 1, std::vector<std::int32_t>(12, 0)}};
  const IncrementalSolid block(Solid(box).with_attributes(attributes));
  Material fresh;
  fresh.name = "fresh";
  const Solid cut =
      block.with(Operation::difference, Solid(test::box({1, 1, 3}, {2, 2, 5}))).solid({.cut_material = &fresh});
  const auto& materials = test::values_of<std::int32_t>(cut.attributes(), "material");
  REQUIRE(cut.attributes().materials.size() == 2);
  CHECK(cut.attributes().materials[1].name == "fresh");
  for (std::size_t t = 0; t < materials.size(); ++t) {
    CAPTURE(t);
    const auto corners = test::corners_of(cut.exact_mesh(), t);
    const bool is_inside = std::all_of(corners.begin(), corners.end(), [](const RationalPoint& p) {
      return p[0] >= 1 && p[0] <= 2 && p[1] >= 1 && p[1] <= 2 && p[2] >= 3;
    });
    const bool is_top = corners[0][2] == 4 && corners[1][2] == 4 && corners[2][2] == 4;
    CHECK(materials[t] == (is_inside && !is_top ? 1 : 0));
  }
}
