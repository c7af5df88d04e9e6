#include <catch2/catch.hpp>

#include "strata/errors.h"

using namespace strata;

TEST_CASE("a defect is described in one line with coordinates, faces and remedy", "[mesh]") {
  Defect defect{DefectKind::open_edge,      Severity::error, Vertex{0.5, 0, -1}, {3, 7}, 12,
                "12 edges have no partner", "close the hole"};
  CHECK(describe(defect) == "open edge: 12 edges have no partner at (0.5, 0, -1), faces 3, 7; close the hole");
  CHECK(describe(Defect{}) == "empty mesh");
}

TEST_CASE("an input error carries its defects and says which operand", "[mesh]") {
  Defect first;
  first.kind = DefectKind::inside_out;
  const InputError error({first, Defect{}}, 2);
  CHECK(error.operand() == 2);
  CHECK(error.defects().size() == 2);
  CHECK(std::string(error.what()) == "operand 2: inside-out (and 1 more)");
}
