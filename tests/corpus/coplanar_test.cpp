#include <catch2/catch.hpp>
#include <iostream>

#include "corpus/corpus.h"
#include "strata/errors.h"
#include "strata/measure.h"

namespace strata::test {
namespace {

const Rational last_digits(1, Integer("1000000000000"));

/// The volume on the doubles in the files, which the exact kernel of the table rounded to 15 digits.
void check_volume(const Row& row, const Rational& found) {
  const std::string& column =
      row.at("volume_igl_exact_kernel").empty() ? "volume_manifold3d" : "volume_igl_exact_kernel";
  if (const auto rounded = exact_number(row.at(column))) {
    CAPTURE(to_nearest_double(found));
    CHECK(within(found, *rounded, last_digits));
  }
}

/// The fractions are the volumes for decimal coordinates: for one tenth, not for the double beside it.
bool check_fraction(const std::filesystem::path& root, const Row& row) {
  const auto fraction = exact_number(row.at("volume_as_fraction"));
  if (!fraction) return false;
  const Solid a(load_decimals(root, row.at("A")));
  const Solid b(load_decimals(root, row.at("B")));
  CHECK(evaluate(row.at("op"), a, b).volume() == *fraction);
  return true;
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
bool check_doubles(const std::filesystem::path& root, const Row& row) {
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
  std::size_t fractions = 0;
  for (const Row& row : read_csv(*root / "expected/cgal_corefinement_bool_merged.csv")) {
    const std::string name = short_name(row.at("A")) + ' ' + row.at("op") + ' ' + short_name(row.at("B"));
    CAPTURE(name);
    try {
      ++(check_doubles(*root, row) ? ran : refused);
      fractions += check_fraction(*root, row);
    } catch (const std::exception& e) {
      FAIL_CHECK("threw: " << e.what());
    }
  }
  std::cout << "corefinement catalogue: " << ran << " rows compared, " << fractions << " of them with a fraction, "
            << refused << " more with an open operand, refused as no solid\n";
  CHECK(ran > 0);
}

}  // namespace strata::test
