#include "core/select/covering.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <optional>

#include "core/overlap/candidates.h"
#include "core/overlap/intersect.h"
#include "core/select/hidden_faces.h"
#include "core/winding/local_windings.h"
#include "strata/options.h"
#include "support/shapes.h"
#include "support/subdivision.h"
#include "support/touching.h"

using namespace strata;

namespace {

/// What a face's coplanar faces tell, held against walks.
class Scene {
 public:
  explicit Scene(std::vector<Mesh> meshes)
      : meshes_(std::move(meshes)),
        candidates_(find_candidates(input_complex_of(meshes_), monitor_)),
        input_(candidates_.input()),
        layers_(input_, candidates_.cells()),
        constraints_(intersect(candidates_, monitor_).constraints) {}

  void check(Operation operation) {
    const Rule rule(operation, input_.operand_count());
    Covering covering(input_, rule);
    const auto met = meet_faces_in_general(candidates_, monitor_);
    found_ = find_hidden_faces(input_, met, rule, monitor_);
    REQUIRE(std::is_sorted(found_.begin(), found_.end()));
    found_early += static_cast<int>(found_.size());
    for (std::size_t first = 0, last = 0; first < constraints_.size(); first = last) {
      while (last < constraints_.size() && constraints_[last].face == constraints_[first].face) ++last;
      covering.start(std::span(constraints_).subspan(first, last - first));
      check(constraints_[first].face, covering, rule);
    }
  }

  int told = 0, hidden = 0;  ///< how often something was known without a walk
  int found_early = 0;       ///< hidden faces known before coplanar faces are intersected

 private:
  static InputComplex input_complex_of(const std::vector<Mesh>& meshes) {
    InputComplex input;
    for (const Mesh& m : meshes) input.add(m.vertices, m.triangles);
    return input;
  }

  void check(std::uint32_t f, Covering& covering, const Rule& rule) {
    const bool hides = covering.hides_face();
    const bool is_found = std::binary_search(found_.begin(), found_.end(), f);
    hidden += static_cast<int>(hides);
    for (std::uint32_t t = 1; t < 8; ++t) {
      const Point q = make_point(input_, SymbolicPoint::weighted(f, t));
      const auto covers = covers_at(f, q, covering);
      if (!covers) continue;
      const Windings above = walk(f, q, *covers);
      if (const auto said = covering.above(*covers)) {
        ++told;
        REQUIRE(*said == above);
      }
      if (hides || is_found || covering.leaves_nothing(*covers)) REQUIRE(is_dropped(f, above, *covers, rule));
    }
  }

  /// The faces through q; nothing when it is on one that is not coplanar, or on an edge.
  std::optional<std::vector<std::uint32_t>> covers_at(std::uint32_t f, const Point& q, Covering& covering) const {
    std::vector<std::uint32_t> covers;
    for (std::uint32_t g = 0; g < input_.face_count(); ++g) {
      if (input_.operand_of_face(g) == input_.operand_of_face(f)) continue;
      if (side_of_face(input_, g, q) != Sign::zero || !is_in_closed(g, q)) continue;
      const auto coplanar = covering.coplanar();
      if (std::find(coplanar.begin(), coplanar.end(), g) == coplanar.end() || !covering.covers(g, q))
        return std::nullopt;
      covers.push_back(g);
    }
    return covers;
  }
  bool is_in_closed(std::uint32_t g, const Point& q) const {
    const auto v = input_.face(g);
    const Projection projection = projection_of(input_, g);
    for (std::size_t i = 0; i < 3; ++i)
      if (orient2d(input_, projection, corner(v[i]), corner(v[(i + 1) % 3]), q) == Sign::negative) return false;
    return true;
  }
  Point corner(std::uint32_t v) const { return make_point(input_, SymbolicPoint::input(v)); }

  Windings walk(std::uint32_t f, const Point& q, std::vector<std::uint32_t> through) const {
    through.push_back(f);
    Windings w = layers_.above(f, q, through);
    w.set(input_.operand_of_face(f), 0);
    return w;
  }

  bool is_dropped(std::uint32_t f, const Windings& above, const std::vector<std::uint32_t>& covers, const Rule& rule) {
    if (!covers.empty() && covers.front() < f) return true;
    Windings below = above;
    below.add(input_.operand_of_face(f), 1);
    for (const std::uint32_t g : covers) below.add(input_.operand_of_face(g), to_int(same_orientation(input_, f, g)));
    return rule.inside(above) == rule.inside(below);
  }

  std::vector<Mesh> meshes_;
  Monitor monitor_;
  Candidates candidates_;
  const InputComplex& input_;
  LocalWindings layers_;
  std::vector<Constraint> constraints_;
  std::vector<std::uint32_t> found_;
};

}  // namespace

// Catches: above and below mixed up, operands without a cover taken for known, a face in part covered taken for hidden,
// walls of touching parts of one operand taken for its outside.
TEST_CASE("what covers tell is what walks tell", "[select][property]") {
  int told = 0, hidden = 0, found_early = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    auto meshes = (seed % 3 == 0 ? test::touching_operands(seed) : test::touching_pair(seed)).meshes;
    if (seed % 2 == 0)
      for (Mesh& m : meshes) m = test::subdivided(std::move(m), random, random.between(0, 20));
    Scene scene(std::move(meshes));
    for (const Operation op : all_operations) scene.check(op);
    told += scene.told;
    hidden += scene.hidden;
    found_early += scene.found_early;
  }
  CHECK(told > 1000);
  CHECK(hidden > 1000);
  CHECK(found_early > 1000);
}

TEST_CASE("faces of a wall between two solids are hidden, whatever their triangles", "[select][degenerate]") {
  test::Random random(7);
  Scene scene({test::subdivided(test::box({0, 0, 0}, {1, 4, 4}), random, 100),
               test::subdivided(test::box({1, 0, 0}, {2, 4, 4}), random, 100)});
  scene.check(Operation::union_);
  CHECK(scene.hidden > 20);
  CHECK(scene.found_early == scene.hidden);
}

// Catches: faces on both sides of an edge taken for alike where a solid that has the edge's vertices, too, ends there.
TEST_CASE("a wall hides what it covers, up to edges that both solids have", "[select][degenerate]") {
  for (const int from : {0, 1, 2})
    for (const int to : {from + 1, from + 2}) {
      const int squares = 2 * (to - from);
      Scene scene(
          {test::box_in_squares({0, 0, 0}, {1, 4, 4}, false), test::box_in_squares({1, from, 1}, {2, to, 3}, true)});
      scene.check(Operation::union_);
      CHECK(scene.hidden == 4 * squares);
      CHECK(scene.found_early == 4 * squares);
      for (const Operation op : all_operations) scene.check(op);
    }
}

TEST_CASE("faces that touch beside one another hide nothing", "[select][degenerate]") {
  Scene scene({test::box({0, 0, 0}, {1, 1, 1}), test::box({1, 1, 0}, {2, 2, 1})});
  for (const Operation op : all_operations) scene.check(op);
  CHECK(scene.hidden == 0);
}
