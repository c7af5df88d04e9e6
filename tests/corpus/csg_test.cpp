#include <catch2/catch.hpp>
#include <filesystem>
#include <iostream>
#include <map>

#include "corpus/corpus.h"
#include "strata/openscad.h"

namespace strata::test {
namespace {

const Rational six_digits(1, 1'000'000);

/// Volumes that are known from the files alone: boxes at integers, and a pyramid.
const std::map<std::string, Rational> exact_volumes{
    {"example003-expected.csg", 23750}, {"union-expected.csg", 23750}, {"example011-expected.csg", Rational(2000, 3)}};

void check_row(const Row& row, const Solid& result) {
  const Rational volume = result.volume();
  CAPTURE(to_nearest_double(volume), result.area());
  CHECK(within(volume, *exact_number(row.at("volume")), six_digits));
  CHECK(result.area() == Approx(std::stod(row.at("area"))).epsilon(1e-6));
  const auto known = exact_volumes.find(short_name(row.at("file")));
  if (known != exact_volumes.end()) CHECK(volume == known->second);
}

}  // namespace

// Catches: tessellations that differ from OpenSCAD's, primitives that lie elsewhere, children in the wrong order.
TEST_CASE("trees that OpenSCAD wrote have the reference volumes", "[corpus][csg]") {
  const auto root = corpus_or_skip();
  if (!root) return;
  std::size_t compared = 0;
  for (const Row& row : read_csv(*root / "expected/csg_reference_values.csv")) {
    if (!row.at("file").starts_with("csg/openscad/")) continue;  // the other one imports meshes
    CAPTURE(row.at("file"));
    try {
      check_row(row, read_csg_file(*root / row.at("file")).expression.evaluate());
    } catch (const std::exception& e) {
      FAIL_CHECK("threw: " << e.what());
    }
    ++compared;
  }
  std::cout << "OpenSCAD trees: " << compared << " compared, " << exact_volumes.size() << " of them exactly\n";
  CHECK(compared == 21);
}

TEST_CASE("trees that OpenSCAD wrote are read, or refused by name", "[corpus][csg]") {
  const auto root = corpus_or_skip();
  if (!root) return;
  std::size_t read = 0;
  std::map<std::string, std::size_t> refused;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(*root / "csg/openscad")) {
    if (entry.path().extension() != ".csg") continue;
    CAPTURE(entry.path().string());
    try {
      (void)read_csg_file(entry.path());
      ++read;
    } catch (const CsgError& e) {
      CHECK_THAT(e.reason(), Catch::Contains(" is not supported") || Catch::Contains(" is missing: there is no "));
      ++refused[e.reason().substr(0, e.reason().find(" is "))];
    }
  }
  std::cout << "OpenSCAD trees: " << read << " read; refused for";
  for (const auto& [name, count] : refused) std::cout << ' ' << name << ' ' << count;
  std::cout << '\n';
  CHECK(read >= 34);
}

}  // namespace strata::test
