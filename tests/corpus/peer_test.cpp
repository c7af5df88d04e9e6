#include <array>
#include <catch2/catch.hpp>
#include <iostream>
#include <map>
#include <sstream>

#include "corpus/corpus.h"
#include "corpus/operands.h"
#include "strata/measure.h"
#include "support/transform.h"

namespace strata::test {
namespace {

/// Rows whose components or Euler characteristic differ from ours for a known reason: "case, op" -> reason.
/// The peer's conventions are ours: equal coordinates are one vertex, components are joined over shared vertices.
const std::map<std::string, std::string> explained_differences{};

/// "name t=(x y z)"
Vertex translation_of(const std::string& text) {
  std::istringstream numbers(text.substr(text.find('(') + 1));
  Vertex by{};
  numbers >> by[0] >> by[1] >> by[2];
  return by;
}

/// Operands of a row as its group makes them.
MeshPair operands_of(const std::filesystem::path& root, const Row& row) {
  const std::string& group = row.at("group");
  const std::string& name = row.at("case");
  if (group == "ember") return ember_pair(root, name.substr(name.find(' ') + 1));
  const Mesh a = load(root, row.at("A"));
  if (group == "self-translate") return {a, translated(a, translation_of(name))};
  return {a, load(root, row.at("B"))};
}

Solid result_of(const std::filesystem::path& root, const Row& row) {
  if (row.at("group") == "geogram-self-union") return Solid(load(root, row.at("A")), InputClass::overlapping);
  const MeshPair pair = operands_of(root, row);
  return evaluate(row.at("op"), Solid(pair.a), Solid(pair.b));
}

void check_row(const Row& row, const Solid& result) {
  const Rational volume = result.volume();
  CAPTURE(to_nearest_double(volume), row.at("volume"));
  CHECK(within(volume, *exact_number(row.at("volume")), Rational(1, Integer("1000000000000"))));
  const Topology facts = topology(result.exact_mesh());
  CHECK(facts.open_edges == 0);
  if (explained_differences.contains(row.at("case") + ", " + row.at("op"))) return;
  CHECK(facts.components == std::stoul(row.at("components")));
  CHECK(facts.euler == std::stol(row.at("euler")));
  CHECK(facts.non_manifold_edges == std::stoul(row.at("nm_edges")));
}

/// All rows of the exact kernel in the group "ember", or all others.
void run(bool ember) {
  const auto root = corpus_or_skip();
  if (!root) return;
  std::size_t ran = 0;
  for (const Row& row : read_csv(*root / "expected/peer_reference_values.csv")) {
    if (row.at("engine") != "igl" || (row.at("group") == "ember") != ember) continue;
    const std::string name = row.at("group") + ", " + row.at("case") + ", " + row.at("op");
    CAPTURE(name);
    try {
      check_row(row, result_of(*root, row));
    } catch (const std::exception& e) {
      FAIL_CHECK("threw: " << e.what());
    }
    ++ran;
  }
  std::cout << "peer table: " << ran << " rows of the exact kernel compared, " << explained_differences.size()
            << " explained differences\n";
  CHECK(ran > 0);
}

}  // namespace

// Catches: wrong labels of whole regions on real meshes, lost components, holes closed or opened.
TEST_CASE("real pairs have the volume, components and Euler characteristic of the exact kernel", "[corpus][peer]") {
  run(false);
}

TEST_CASE("printed objects have the volume, components and Euler characteristic of the exact kernel",
          "[corpus][peer][slow]") {
  run(true);
}

}  // namespace strata::test
