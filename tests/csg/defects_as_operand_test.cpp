#include <catch2/catch.hpp>

#include "strata/check.h"
#include "strata/solid.h"
#include "support/shapes.h"

using namespace strata;

namespace {

std::vector<std::string> texts(const std::vector<Defect>& defects) {
  std::vector<std::string> list;
  for (const Defect& d : defects) list.push_back(describe(d));
  return list;
}

}  // namespace

// Catches: another preparation than the one that a Solid goes through.
TEST_CASE("what is said of an operand is what its solid says", "[csg]") {
  Mesh open = test::cube_grid(1);
  open.triangles.pop_back();
  CHECK(defects_as_operand({test::cube_grid(1), {}}, InputClass::solid).empty());
  for (const InputClass input : all_input_classes) {
    try {
      const Solid solid(open, input);
      CHECK(texts(defects_as_operand({open, {}}, input)) == texts(solid.notes()));
    } catch (const InputError& error) {
      CHECK(texts(defects_as_operand({open, {}}, input)) == texts(error.defects()));
    }
  }
  Mesh doubled = test::cube_grid(1);
  doubled.vertices.push_back(doubled.vertices[doubled.triangles[0][0]]);
  doubled.triangles[0][0] = static_cast<std::uint32_t>(doubled.vertices.size() - 1);
  CHECK(!defects_as_operand({doubled, {}}, InputClass::repair).empty());
  CHECK(texts(defects_as_operand({doubled, {}}, InputClass::solid)) == texts(Solid(doubled).notes()));
}
