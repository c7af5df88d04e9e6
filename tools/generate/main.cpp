// strata_generate SHAPE -o OUT: a part of known shape, for data/ and for trying things out.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "shapes.h"
#include "strata/io.h"

namespace {

struct Wish {
  std::string shape;
  std::string output;
  unsigned resolution = 32;
  double radius = 1;
  double inner = 0.75;
  double height = 2;
  double thickness = 0.25;
  std::string axis = "z";
  std::vector<double> at = {0, 0, 0};
};

void add_options(CLI::App& app, Wish& wish) {
  app.add_option("SHAPE", wish.shape)
      ->required()
      ->check(CLI::IsMember({"box", "sphere", "torus", "cylinder", "gear", "bracket"}));
  app.add_option("-o,--output", wish.output, "A mesh file")->required();
  app.add_option("--resolution", wish.resolution, "Teeth, sides, or half the meridians")->check(CLI::Range(3, 4096));
  app.add_option("--radius", wish.radius, "Radius, leg, or half a side")->capture_default_str();
  app.add_option("--inner", wish.inner, "Of a gear between its teeth")->capture_default_str();
  app.add_option("--height", wish.height, "Along the axis")->capture_default_str();
  app.add_option("--thickness", wish.thickness, "Of a bracket's legs, radius of a torus' tube")->capture_default_str();
  app.add_option("--axis", wish.axis, "Where the shape's z axis goes")->check(CLI::IsMember({"x", "y", "z"}));
  app.add_option("--at", wish.at, "Where the origin goes")->expected(3);
}

strata::Mesh make(const Wish& wish) {
  const double side = 2 * wish.radius;
  if (wish.shape == "box") return shapes::box({side, side, wish.height});
  if (wish.shape == "sphere") return shapes::sphere(wish.radius, wish.resolution);
  if (wish.shape == "torus") return shapes::torus(wish.radius, wish.thickness, wish.resolution);
  if (wish.shape == "cylinder") return shapes::cylinder(wish.radius, wish.height, wish.resolution);
  if (wish.shape == "gear") return shapes::gear(wish.inner, wish.radius, wish.height, wish.resolution);
  return shapes::bracket(wish.radius, wish.thickness, wish.height);
}

void place(strata::Mesh& mesh, const Wish& wish) {
  const int orientations = wish.axis == "x" ? 2 : wish.axis == "y" ? 1 : 0;  // a cyclic exchange of axes: exact
  for (strata::Vertex& vertex : mesh.vertices) {
    std::rotate(vertex.begin(), vertex.begin() + orientations, vertex.end());
    for (std::size_t k = 0; k < 3; ++k) vertex[k] += wish.at[k];
  }
}

}  // namespace

int main(int argc, char** argv) {
  Wish wish;
  CLI::App app("Makes a part of known shape", "strata_generate");
  add_options(app, wish);
  CLI11_PARSE(app, argc, argv);
  try {
    strata::Mesh mesh = make(wish);
    place(mesh, wish);
    strata::write_mesh(wish.output, mesh);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "strata_generate: %s\n", error.what());
    return 1;
  }
}
