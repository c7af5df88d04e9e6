#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <utility>

#include "corpus/corpus.h"
#include "strata/bsp.h"
#include "strata/measure.h"
#include "support/shapes.h"
#include "support/transform.h"

namespace strata::test {
namespace {

RationalPoint point(std::string_view x, std::string_view y, std::string_view z) {
  return {*exact_number(x), *exact_number(y), *exact_number(z)};
}

/// What the cases are computed with: solids by the arrangement, or regions by merging partitions.
struct Region {
  explicit Region(const ExactMesh& mesh) : partition(bsp::partition_of(mesh)) {}
  explicit Region(const Mesh& mesh) : Region(ExactMesh{mesh, {}}) {}
  explicit Region(bsp::Partition<3> p) : partition(std::move(p)) {}

  friend Region operator|(const Region& a, const Region& b) { return Region(a.partition | b.partition); }
  friend Region operator&(const Region& a, const Region& b) { return Region(a.partition & b.partition); }
  friend Region operator-(const Region& a, const Region& b) { return Region(a.partition - b.partition); }
  friend Region operator^(const Region& a, const Region& b) { return Region(a.partition ^ b.partition); }

  bsp::Partition<3> partition;
};

template <class Join>
Region folded(std::span<const Region> operands, const Join& join) {
  Region result = operands[0];
  for (const Region& r : operands.subspan(1)) result = join(result, r);
  return result;
}
Region union_(std::span<const Region> operands) { return folded(operands, std::bit_or<>()); }
Region intersection(std::span<const Region> operands) { return folded(operands, std::bit_and<>()); }
Region difference(std::span<const Region> operands) { return folded(operands, std::minus<>()); }

/// A result as a solid that was checked on the way in.
Solid solid_of(Solid solid) { return solid; }
Solid solid_of(const Region& region) { return Solid(bsp::exact_mesh_of(region.partition)); }

template <class Model>
class CuratedCases {
 public:
  /// Every row that is a Boolean of boxes, tetrahedra or polyhedra, spelled out.
  explicit CuratedCases(const std::filesystem::path& root) {
    add_volume_identities();
    add_unit_cubes();
    cases_["mf-tetra"] = [] { return sponge_tetrahedron({0.5, 0.5, 0.5}) - sponge_tetrahedron({0, 0, 0}); };
    cases_["mf-mirrored"] = [] { return block({0, -1, 0}, {1, 0, 1}) - block({0, -1, 0}, point("0.5", "0", "0.5")); };
    cases_["mf-cubes"] = [] {
      return union_(std::array{block(point("-0.6", "-1", "0"), point("0.6", "0", "1")),
                               block(point("-0.5", "0", "0.5"), point("0.5", "0.8", "1")),
                               block(point("-0.6", "-0.1", "0"), point("0.6", "0", "0.5"))});
    };
    cases_["hp-cross"] = [] {
      return beam({1, 2, 3}, point("1", "0.1", "0.1")) |
             (beam({1, 2, 3}, point("0.1", "1", "0.1")) | beam({1, 2, 3}, point("0.1", "0.1", "1")));
    };
    cases_["hp-tetra"] = [] { return Model(tetrahedron({1, 2, 3}, {2, 2, 4}, {2, 3, 3}, {1, 3, 4})); };
    cases_["hp-pentomino"] = [root] {
      return Model(load(root,
                        "csg/hipparchus/hipparchus-geometry/src/test/resources/org/hipparchus/geometry/euclidean/"
                        "threed/pentomino-N.ply"));
    };
    cases_["mf-menger1"] = [] { return menger_sponge(1); };
    cases_["mf-menger2"] = [] { return menger_sponge(2); };
  }

  [[nodiscard]] const std::map<std::string, std::function<Model()>>& list() const { return cases_; }

 private:
  static Model block(const RationalPoint& lower, const RationalPoint& upper) { return Model(exact_box(lower, upper)); }

  /// A box by its middle and half its sides.
  static Model beam(const RationalPoint& middle, const RationalPoint& half) {
    RationalPoint lower;
    RationalPoint upper;
    for (int k = 0; k < 3; ++k) {
      lower[k] = middle[k] - half[k];
      upper[k] = middle[k] + half[k];
    }
    return block(lower, upper);
  }

  static Model cube_at(const RationalPoint& lower) { return block(lower, {lower[0] + 1, lower[1] + 1, lower[2] + 1}); }

  static Model centred_cube_at(const RationalPoint& middle) {
    return beam(middle, {Rational(1, 2), Rational(1, 2), Rational(1, 2)});
  }

  static Model sponge_tetrahedron(const Vertex& shift) {
    return Model(translated(tetrahedron({-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}, {1, 1, 1}), shift));
  }

  /// The unit cube without square tunnels along the three axes, down to the given level: one subtraction of all.
  static Model menger_sponge(int level) {
    std::vector<Model> operands{cube_at({0, 0, 0})};
    for (int size = 3, l = 0; l < level; ++l, size *= 3) {
      for (int axis = 0; axis < 3; ++axis) {
        for (int i = 1; i < size; i += 3) {
          for (int j = 1; j < size; j += 3) {
            RationalPoint lower{-1, -1, -1};
            RationalPoint upper{2, 2, 2};
            lower[(axis + 1) % 3] = Rational(i, size);
            lower[(axis + 2) % 3] = Rational(j, size);
            upper[(axis + 1) % 3] = Rational(i + 1, size);
            upper[(axis + 2) % 3] = Rational(j + 1, size);
            operands.push_back(block(lower, upper));
          }
        }
      }
    }
    return difference(operands);
  }

  void add_volume_identities() {
    const Model m1 = block({0, 0, 0}, {1, 1, 1});
    const Model m2 = block({1, 0, 0}, {3, 1, 1});
    const Model m4 = block({3, 0, 0}, {7, 1, 1});
    const Model m3 = block({0, 0, 0}, {3, 1, 1});
    const Model m7 = block({0, 0, 0}, {7, 1, 1});
    const std::string prefix = "mf-boolvol-";
    cases_[prefix + "m1^m2"] = [=] { return m1 & m2; };
    cases_[prefix + "m1+m2+m4"] = [=] { return union_(std::array{m1, m2, m4}); };
    cases_[prefix + "m1+m2-m4"] = [=] { return (m1 | m2) - m4; };
    cases_[prefix + "m1+(m2^m4)"] = [=] { return m1 | (m2 & m4); };
    cases_[prefix + "m7^m4"] = [=] { return m7 & m4; };
    cases_[prefix + "m7^m3^m1"] = [=] { return intersection(std::array{m7, m3, m1}); };
    cases_[prefix + "m7^(m1+m2)"] = [=] { return m7 & (m1 | m2); };
    cases_[prefix + "m7-m4"] = [=] { return m7 - m4; };
    cases_[prefix + "m7-m4-m2"] = [=] { return difference(std::array{m7, m4, m2}); };
    cases_[prefix + "m7-(m7-m1)"] = [=] { return m7 - (m7 - m1); };
    cases_[prefix + "m7-(m1+m2)"] = [=] { return m7 - (m1 | m2); };
  }

  void add_unit_cubes() {
    const Model unit = cube_at({0, 0, 0});
    const Model middle = centred_cube_at({0, 0, 0});
    const Model half_right = centred_cube_at(point("0.5", "0", "0"));
    cases_["mf-half-sub"] = [=] { return middle - half_right; };
    cases_["mf-half-union"] = [=] { return middle | half_right; };
    cases_["mf-half-int"] = [=] { return middle & half_right; };
    cases_["mf-self-sub"] = [=] { return unit - unit; };
    cases_["mf-faceunion"] = [=] { return unit | cube_at({1, 0, 0}); };
    cases_["mf-edgeunion"] = [=] { return unit | cube_at({1, 1, 0}); };
    cases_["mf-cornerunion"] = [=] { return unit | cube_at({1, 1, 1}); };
    cases_["mf-nonint"] = [=] { return unit | block({3, 0, 0}, {5, 2, 2}); };
    cases_["hp-box"] = [=] { return unit; };
    cases_["cg-disjoint"] = [=] { return middle | centred_cube_at({2, 0, 0}); };
    cases_["cg-sharedside"] = [=] { return middle | centred_cube_at({1, 0, 0}); };
    cases_["cg-sep1e-7"] = [=] { return middle | centred_cube_at(point("1.0000001", "0", "0")); };
    cases_["cg-sharededge"] = [=] { return middle | centred_cube_at({1, 1, 0}); };
    cases_["cg-sharedpoint"] = [=] { return middle | centred_cube_at({1, 1, 1}); };
    cases_["cg-xor"] = [=] { return unit ^ cube_at(point("0.5", "0.5", "0.5")); };
    const Model left = centred_cube_at(point("-0.5", "0", "0"));
    cases_["tb-touch-union"] = [=] { return left ^ half_right; };
    cases_["tb-touch-int"] = [=] { return left & half_right; };
  }

  std::map<std::string, std::function<Model()>> cases_;
};

/// Rows that are no such Boolean, and why.
const std::map<std::string, std::string> other_rows{
    {"mf-Havocglass8Bool", "no exact value here; compared with the exact kernel in the peer table"},
    {"mf-OffsetSelfIntersect", "no exact value here; compared with the exact kernel in the peer table"},
    {"hp-issue1211", "ray casts in a given BSP tree"},
    {"cg-diff", "a sphere by tolerance"},
};

/// "4.56", "formula=4.56", "2*sqrt(3)", "12 (remark)".
double expected_area(std::string text) {
  if (text == "2*sqrt(3)") return 2 * std::sqrt(3.0);
  text = text.substr(text.find('=') == std::string::npos ? 0 : text.find('=') + 1);
  return std::stod(text);
}

/// `components` in this table counts parts of the surface: cubes that share an edge or a vertex are two.
void check_row(const Row& row, const Solid& solid) {
  CHECK(solid.volume() == exact_number(row.at("exact_volume")));
  const Topology facts = topology(solid.exact_mesh());
  CHECK(facts.open_edges == 0);
  if (!row.at("expected_area").empty()) {
    CHECK(solid.area() == Approx(expected_area(row.at("expected_area"))).epsilon(1e-12));
  }
  if (!row.at("components").empty()) {
    CHECK(surface_parts(solid.mesh()) == std::stoul(row.at("components")));
  }
  if (!row.at("expected_genus").empty() && !solid.is_empty()) {
    CHECK(facts.euler == 2 - 2 * std::stol(row.at("expected_genus")));
  }
}

template <class Model>
void check_rows(const char* engine) {
  const auto root = corpus_or_skip();
  if (!root) return;
  const CuratedCases<Model> cases(*root);
  std::size_t ran = 0;
  for (const Row& row : read_csv(*root / "expected/curated_cases.csv")) {
    const std::string& id = row.at("id");
    CAPTURE(id);
    if (other_rows.contains(id)) continue;
    const auto found = cases.list().find(id);
    if (found == cases.list().end()) {
      FAIL_CHECK("a row that this test does not know");
      continue;
    }
    try {
      check_row(row, solid_of(found->second()));
    } catch (const std::exception& e) {
      FAIL_CHECK("threw: " << e.what());
    }
    ++ran;
  }
  std::cout << "curated cases by " << engine << ": " << ran << " rows compared, " << other_rows.size()
            << " of another kind\n";
  CHECK(ran == cases.list().size());
}

}  // namespace

// Catches: any loss of exactness from decimals and thirds to the volume, internal walls, zero-volume sheets.
TEST_CASE("curated Booleans of boxes and polyhedra have their exact rational volumes", "[corpus][curated]") {
  check_rows<Solid>("arrangements");
}

TEST_CASE("the same by merging partitions", "[corpus][curated][bsp]") { check_rows<Region>("merged partitions"); }

}  // namespace strata::test
