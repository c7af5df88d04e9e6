#include <catch2/catch.hpp>
#include <iostream>

#include "corpus/corpus.h"
#include "strata/mesh/defect.h"
#include "strata/mesh/measure.h"

namespace strata::test {
namespace {

/// The volume that the exact kernel of the table found: as a fraction, or rounded to 15 digits.
void check_volume(const Row& row, const Rational& found) {
  if (const auto fraction = exact_number(row.at("volume_as_fraction"))) {
    CHECK(found == *fraction);
    return;
  }
  const std::string& column = row.at("volume_igl_exact_kernel").empty() ? "volume_manifold3d" : "volume_igl_exact_kernel";
  if (const auto rounded = exact_number(row.at(column))) {
    CAPTURE(to_nearest_double(found));
    CHECK(within(found, *rounded, Rational(1, Integer("1000000000000"))));
  }
}

void check_row(const Row& row, const Solid& result) {
  check_volume(row, result.volume());
  const Topology facts = topology(result.exact_mesh());
  CHECK(facts.open_edges == 0);
  if (!row.at("nm_edges").empty()) {
    CHECK(facts.non_manifold_edges == std::stoul(row.at("nm_edges")));
    CHECK(facts.euler == std::stol(row.at("euler")));
    CHECK(facts.components == std::stoul(row.at("components")));
  }
  CHECK((facts.non_manifold_edges == 0) == (row.at("cgal_expected_manifold") == "1"));
}

/// False when an operand is no closed surface; then the table must have no value either.
bool run_row(const std::filesystem::path& root, const Row& row) {
  try {
    const Solid a(load(root, row.at("A")));
    const Solid b(load(root, row.at("B")));
    check_row(row, evaluate(row.at("op"), a, b));
    return true;
  } catch (const InputError& e) {
    CAPTURE(e.what());
    CHECK(row.at("volume_igl_exact_kernel").empty());
    CHECK(row.at("volume_manifold3d").empty());
    return false;
  }
}

}  // namespace

// Catches: coplanar overlaps kept twice or lost, non-manifold edges split apart or merged away.
TEST_CASE("coplanar and touching pairs of the corefinement catalogue agree with the exact kernel",
          "[corpus][coplanar]") {
  const auto root = corpus_or_skip();
  if (!root) return;
  std::size_t ran = 0;
  std::size_t refused = 0;
  for (const Row& row : read_csv(*root / "expected/cgal_corefinement_bool_merged.csv")) {
    const std::string name = short_name(row.at("A")) + ' ' + row.at("op") + ' ' + short_name(row.at("B"));
    CAPTURE(name);
    try {
      ++(run_row(*root, row) ? ran : refused);
    } catch (const std::exception& e) {
      FAIL_CHECK("threw: " << e.what());
    }
  }
  std::cout << "corefinement catalogue: " << ran << " rows compared, " << refused
            << " with an open operand, refused as no solid\n";
  CHECK(ran > 0);
}

}  // namespace strata::test
