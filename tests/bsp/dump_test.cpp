#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>

#include "strata/bsp.h"

namespace strata::bsp {

TEST_CASE("dumps that are cut off or wrong are refused with their line", "[bsp]") {
  const std::string head = "PolyhedronsSet\ntolerance 1e-8\n";
  const auto error_of = [](const std::string& text) -> std::string {
    try {
      (void)read_polyhedrons_set(text);
      return "";
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  };
  CHECK(error_of(head + "plus leaf true\n") == "");
  CHECK(read_polyhedrons_set(head + "plus leaf true\n").is_full());
  CHECK(error_of("PolygonsSet\n") == "line 1: no PolyhedronsSet");
  CHECK(error_of(head + "plus internal 0 0 0 1 0 0 1e-8\n minus leaf true\n") == "line 4: the tree ends too early");
  CHECK(error_of(head + "plus internal 0 0 0 0 0 0 1e-8\n") == "line 3: a plane without a normal");
  CHECK(error_of(head + "plus internal 0 0 x 1 0 0 1e-8\n") == "line 3: no number: x");
  CHECK(error_of(head + "plus leaf maybe\n") == "line 3: neither a plane nor a leaf");
}

TEST_CASE("planes of a dump that do not divide their part of space are passed over", "[bsp]") {
  // Below x = 0, planes x = 1 and x = 0 again: only their minus sides are there.
  const Partition<3> half = read_polyhedrons_set(
      "PolyhedronsSet\ntolerance 1e-8\nplus internal 0 0 0 1 0 0 1e-8\n"
      " minus internal 1 0 0 2 0 0 1e-8\n  minus internal 0 5 0 -3 0 0 1e-8\n   minus leaf false\n   plus leaf true\n"
      "  plus leaf false\n plus leaf false\n");
  CHECK(size_of_tree(half).nodes == 1);
  CHECK(half.classify({-1, 0, 0}) == Where::in);
  CHECK(half.classify({1, 0, 0}) == Where::out);
}

}  // namespace strata::bsp
