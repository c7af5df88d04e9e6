// What surfaces carry, through everything that makes surfaces and solids of them.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <vector>

#include "attributes/painted.h"
#include "strata/carry_attributes.h"
#include "strata/surface.h"
#include "support/random.h"
#include "support/rounds.h"
#include "support/shapes.h"
#include "support/touching.h"

using namespace strata;
using namespace strata::test;

namespace {

/// Surfaces with the place of every corner and a number per face, and all their faces by these numbers.
struct Scene {
  std::vector<Surface> surfaces;
  std::vector<std::array<RationalPoint, 3>> faces;

  void add(const Surface& surface) {
    Attributes attributes;
    attributes.channels = {places(surface.mesh()),
                           identifiers(surface.mesh(), static_cast<std::int32_t>(faces.size()))};
    for (std::size_t f = 0; f < surface.mesh().triangles.size(); ++f)
      faces.push_back(corners_of(surface.exact_mesh(), f));
    surfaces.push_back(surface.with_attributes(std::move(attributes)));
  }
};

/// Every triangle is a part of the face that its number names, and has its places.
template <class Part>
void require_carried(const Part& part, const Scene& scene) {
  if (part.is_empty()) return;
  REQUIRE(has_its_places(part.mesh(), part.attributes()));
  const auto& numbers = values_of<std::int32_t>(part.attributes(), "identifier");
  for (std::size_t t = 0; t < part.mesh().triangles.size(); ++t)
    for (const RationalPoint& p : corners_of(part.exact_mesh(), t))
      REQUIRE(is_in(scene.faces.at(static_cast<std::size_t>(numbers[t])), p));
}

}  // namespace

// Catches: corners in the wrong order on walls that are turned, attributes of another operand, lost cut faces.
TEST_CASE("clips, imprints, cells and splits carry what surfaces carry", "[surface][attributes][property]") {
  std::size_t cells = 0;
  for (std::uint64_t seed = 0; seed < rounds(60); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Operands touching = seed % 2 == 0 ? touching_pair(seed) : touching_operands(seed);
    Scene scene;
    for (Mesh mesh : touching.meshes) {
      if (random.once_in(3)) mesh.triangles.pop_back();  // open
      scene.add(Surface(mesh));
    }
    const std::vector<Surface> imprinted = imprint(scene.surfaces);
    for (const Surface& s : imprinted) require_carried(s, scene);
    const std::vector<Solid> enclosed = cells_of(scene.surfaces);
    for (const Solid& s : enclosed) require_carried(s, scene);
    cells += enclosed.size();
    const Solid solid(touching.meshes.front());
    for (const ClipTo part : all_clips) require_carried(clip(scene.surfaces.back(), solid, part), scene);
    Scene with_solid;
    with_solid.add(Surface(solid));
    const Solid painted_solid = solid.with_attributes(carry_attributes(
        std::array{AttributedMesh{with_solid.surfaces[0].exact_mesh(), &with_solid.surfaces[0].attributes()}},
        solid.exact_mesh(), with_solid.surfaces[0].sources()));
    for (std::size_t k = 1; k < scene.surfaces.size(); ++k) with_solid.add(scene.surfaces[k].with_attributes({}));
    for (const Solid& s : split(painted_solid, std::span(with_solid.surfaces).subspan(1)))
      require_carried(s, with_solid);
  }
  CHECK(2 * cells > rounds(60));
}

TEST_CASE("an imprint has the channels of its own surface, a clip those of the surface, lists included",
          "[surface][attributes]") {
  Mesh sheet;
  sheet.vertices = {{-2, -2, 0.5}, {2, -2, 0.5}, {2, 2, 0.5}, {-2, 2, 0.5}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  Attributes photo;
  photo.materials.emplace_back().name = "photo";
  photo.channels = {{"texcoord", Element::vertex, Interpolation::linear, 2, std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1}},
                    {"material", Element::face, Interpolation::nearest, 1, std::vector<std::int32_t>{0, 0}}};
  const Surface terrain = Surface(sheet).with_attributes(photo);
  const Surface cube(test::box({-1, -1, 0}, {1, 1, 1}));
  const std::vector<Surface> both = imprint(std::array{cube, terrain});
  CHECK(both[0].attributes().empty());
  CHECK(both[1].attributes().materials == photo.materials);
  CHECK(both[1].attributes().channels.size() == 2);
  CHECK(both[1].attributes().find("texcoord")->element == Element::vertex);
  const Surface part = clip(terrain, Solid(test::box({-1, -1, 0}, {1, 1, 1})), ClipTo::inside);
  const auto& values = values_of<float>(part.attributes(), "texcoord");
  for (std::size_t v = 0; v < part.mesh().vertices.size(); ++v)
    for (std::size_t i = 0; i < 2; ++i)
      CHECK(values[2 * v + i] == static_cast<float>((part.mesh().vertices[v][i] + 2) / 4));
  CHECK_THROWS_AS(Surface(sheet).with_attributes(part.attributes()), std::invalid_argument);
  const Solid gray = Solid(test::box({-1, -1, 0}, {1, 1, 1}));
  const std::vector<Solid> halves = split(gray, std::array{terrain});
  REQUIRE(halves.size() == 2);
  for (const Solid& half : halves) {
    const auto& material = values_of<std::int32_t>(half.attributes(), "material");
    for (std::size_t f = 0; f < material.size(); ++f)
      CHECK(material[f] == (half.sources()[f].operand == 1 ? 0 : -1));  // the cut is of the surface
    CHECK(std::count(material.begin(), material.end(), 0) >= 2);
  }
}
