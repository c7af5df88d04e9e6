// Colours of OpenSCAD's models become materials.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "openscad/csg_text.h"
#include "strata/srgb.h"

using namespace strata;
using namespace strata::test;

namespace {

/// The area of all faces of a colour, by its numbers in tenths: "10,0,0,10". "none" is without.
std::map<std::string, double> areas_of(const std::string& text) {
  const Solid solid = solid_of(text);
  const Mesh& mesh = solid.mesh();
  const Channel* const channel = solid.attributes().find(channel_names::material);
  std::map<std::string, double> areas;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::int32_t number = channel == nullptr ? -1 : std::get<std::vector<std::int32_t>>(channel->values)[t];
    std::string color = "none";
    if (number >= 0) {
      const auto& c = solid.attributes().materials.at(static_cast<std::size_t>(number)).color;
      color.clear();
      for (std::size_t i = 0; i < 4; ++i)
        color += (i == 0 ? "" : ",") + std::to_string(std::lround(10 * (i < 3 ? srgb_of_light(c[i]) : c[i])));
    }
    const Mesh triangle{mesh.vertices, {mesh.triangles[t]}};
    areas[color] += area(ExactMesh{triangle, {}});
  }
  for (auto& [color, a] : areas) a = std::round(a * 1e9) / 1e9;
  return areas;
}

using Areas = std::map<std::string, double>;

std::string shifted(const std::string& what, int x) {
  return "multmatrix([[0.6,-0.8,0," + std::to_string(x) + "],[0.8,0.6,0,0],[0,0,1,0],[0,0,0,1]]) {" + what + "}";
}

const std::string red = "color([1, 0, 0, 1]) ", blue = "color([0, 0, 1, 0.5]) ", cube = "{ cube(1); }";

}  // namespace

TEST_CASE("faces have the colour of the solid that they come from", "[openscad]") {
  CHECK(areas_of(red + cube) == Areas{{"10,0,0,10", 6}});
  CHECK(areas_of("cube(1);") == Areas{{"none", 6}});
  CHECK(areas_of("difference() { " + red + "{ cube(2); } " + blue + cube + "}") ==
        Areas{{"10,0,0,10", 21}, {"0,0,10,5", 3}});
  CHECK(areas_of("difference() { " + red + "{ cube(2); } " + cube.substr(1, 9) + "}") ==
        Areas{{"10,0,0,10", 21}, {"none", 3}});
  CHECK(areas_of(red + "{ linear_extrude(height = 1) { square(1); } }") == Areas{{"10,0,0,10", 6}});
  CHECK(areas_of("hull() { " + red + cube + "}") == Areas{{"none", 6}});
}

// Catches: one solid in two colours that counts as one, equal texts that are one step although their colours differ.
TEST_CASE("equal solids may have different colours, and the outermost counts", "[openscad]") {
  CHECK(areas_of(shifted(red + cube, 0) + shifted(blue + cube, 4) + shifted("cube(1);", 8)) ==
        Areas{{"10,0,0,10", 6}, {"0,0,10,5", 6}, {"none", 6}});
  CHECK(areas_of(red + "{" + blue + cube + "}") == Areas{{"10,0,0,10", 6}});
  CHECK(areas_of(red + "{ group() {" + blue + cube + "} }" + shifted("group() {" + blue + cube + "}", 4)) ==
        Areas{{"10,0,0,10", 6}, {"0,0,10,5", 6}});
  CHECK(areas_of(shifted("group() {" + blue + cube + "}", 4) + red + "{ group() {" + blue + cube + "} }") ==
        Areas{{"10,0,0,10", 6}, {"0,0,10,5", 6}});
  CHECK(areas_of("color([-1, -1, -1, 1]) {" + blue + cube + "}") == Areas{{"0,0,10,5", 6}});
  std::string deep = "cube(1);";
  for (int i = 0; i < 2000; ++i) deep = "color([0, 1, 0, 1]) {" + deep + "}";
  CHECK(areas_of(red + "{" + deep + "}") == Areas{{"10,0,0,10", 6}});
}

TEST_CASE("colours that cannot be had are told", "[openscad]") {
  CHECK(areas_of("color(\"red\", 0.5) " + cube + blue + "{ square(1); }") == Areas{{"none", 6}});
  CHECK(notes_of("color(\"red\", 0.5) " + cube + "\n color([-1, -1, -1, 1]) " + cube) ==
        "a color that is not given as numbers from 0 is passed over (2 times, first in line 1)\n");
  CHECK(notes_of("linear_extrude(height = 1) { " + red + "{ square(1); } }") ==
        "the color of a shape is passed over (line 1)\n");
  CHECK(notes_of(red + cube).empty());
  CHECK(error_of("color([0, \"a\"]) cube(1);") == "1:7: the c of color has a component that is no number");
}
