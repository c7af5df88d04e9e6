// Every extension, used by its public header from outside.
#include <strata/bsp.h>
#include <strata/complex.h>
#include <strata/contact.h>
#include <strata/convex.h>
#include <strata/incremental.h>
#include <strata/openscad.h>
#include <strata/planar.h>
#include <strata/query.h>
#include <strata/section.h>
#include <strata/strata.h>
#include <strata/surface.h>

#include <array>
#include <iostream>
#include <ostream>
#include <vector>

int main() {
  using namespace strata;
  const Mesh corner{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  Mesh moved = corner;
  for (Vertex& vertex : moved.vertices) vertex[0] += 1;
  const std::vector<Solid> solids{Solid(corner), Solid(moved)};

  const Rational hull = convex::solid_of(convex::convex_hull(solids)).volume();
  const bool is_bounded = bsp::Partition<3>::half_space(std::array<Rational, 4>{0, 0, 1, -1}).is_bounded();
  Options by_partitions;
  by_partitions.engine = &bsp_engine;
  const bool agree = combine_solids(Operation::difference, solids, by_partitions) == solids[0] - solids[1];
  const contact::Relation relation = contact::Assembly(solids).relation(0, 1);
  const complex::SelectiveComplex open = complex::of_solid(solids[0], complex::Border::open);
  const IncrementalSolid solid_in_steps = IncrementalSolid(solids[0]).with(Operation::difference, solids[1]);
  const CsgModel model = read_csg("cube(size = 2, center = false);", "model");
  const planar::PlanarFile file = planar::read_planar("POLYGON ((0 0, 3 0, 0 1))", planar::PlanarFormat::wkt, "text");
  const Where where = Locator(scene_of(solids)).membership({0.5, 0.5, 0.5});

  const std::size_t cells = cells_of(std::vector{Surface(solids[0]), Surface(solids[1])}).size();

  std::cout << "hull " << hull << ", bounded " << is_bounded << ", agree " << agree << ", " << name(relation)
            << ", open " << complex::is_open(open) << ", left " << solid_in_steps.volume() << ", cube "
            << model.expression.evaluate().volume() << ", polygon " << planar::area(planar::fill(file.loops)) << ", in "
            << (where == Where::in) << ", cells " << cells << ", section "
            << planar::area(section(solids[0], {{0, 0, 1}, 1})) << '\n';
}
