#include "core/kernel/predicates.h"

#include <catch2/catch.hpp>
#include <map>
#include <string>

#include "kernel/scene.h"
#include "kernel/tiers.h"

using namespace strata;
using namespace strata::test;

namespace {

/// Which tiers each predicate has used so far.
class TierTable {
 public:
  /// Asks a question and books the tiers it took under the name of its predicate.
  template <class Question>
  auto ask(const char* predicate, const Question& question) {
    (void)probe_.take();
    const auto answer = question();
    const auto counts = probe_.take();
    auto& row = rows_[predicate];
    for (std::size_t i = 0; i < counts.size(); ++i) row[i] += counts[i];
    return answer;
  }

  [[nodiscard]] std::uint64_t count(const char* predicate, Tier tier) {
    return rows_[predicate][static_cast<std::size_t>(tier)];
  }

  [[nodiscard]] std::string to_string() const {
    std::string r;
    for (const auto& [name, row] : rows_) {
      r += name + ":";
      for (std::size_t i = 0; i < row.size(); ++i) r += std::string(" ") + tier_names[i] + "=" + std::to_string(row[i]);
      r += "\n";
    }
    return r;
  }

 private:
  TierProbe probe_;
  std::map<std::string, TierProbe::Counts> rows_;
};

void check_vertices(Scene& s, TierTable& table) {
  std::array<std::uint32_t, 4> v{};
  for (auto& x : v) x = s.any_vertex();
  const auto ask = [&](int a, int b, int c, int d) {
    return table.ask("orient3d of vertices", [&] {
      return orient3d(s.input, v[static_cast<std::size_t>(a)], v[static_cast<std::size_t>(b)],
                      v[static_cast<std::size_t>(c)], v[static_cast<std::size_t>(d)]);
    });
  };
  const Sign expected = RationalPlane{s.places[v[0]], s.places[v[1]], s.places[v[2]]}.side(s.places[v[3]]);
  REQUIRE(ask(0, 1, 2, 3) == expected);
  REQUIRE(ask(1, 2, 0, 3) == expected);
  REQUIRE(ask(1, 0, 2, 3) == -expected);
  REQUIRE(ask(0, 1, 3, 2) == -expected);
}

void check_orient3d(Scene& s, TierTable& table, const std::vector<Known>& known) {
  const Known &p = s.random.pick(known), &q = s.random.pick(known), &r = s.random.pick(known),
              &t = s.random.pick(known);
  const Sign expected = RationalPlane{p.place, q.place, r.place}.side(t.place);
  REQUIRE(table.ask("orient3d", [&] { return orient3d(s.input, p.point, q.point, r.point, t.point); }) == expected);
  REQUIRE(table.ask("orient3d", [&] { return orient3d(s.input, t.point, q.point, r.point, p.point); }) == -expected);
}

void check_side(Scene& s, TierTable& table, const std::vector<Known>& known) {
  const Known& p = s.random.pick(known);
  const std::uint32_t f = s.any_face();
  REQUIRE(table.ask("side_of_face", [&] { return side_of_face(s.input, f, p.point); }) == s.plane(f).side(p.place));
}

void check_orient2d(Scene& s, TierTable& table, const std::vector<Known>& known) {
  const Known &p = s.random.pick(known), &q = s.random.pick(known), &r = s.random.pick(known);
  const int axis = s.random.between(0, 2), other = (axis + s.random.between(1, 2)) % 3;
  const Sign expected = sign_of(twice_area(p.place, q.place, r.place, axis, other));
  const Projection view{axis, other}, mirrored{other, axis};
  REQUIRE(table.ask("orient2d", [&] { return orient2d(s.input, view, p.point, q.point, r.point); }) == expected);
  REQUIRE(orient2d(s.input, mirrored, p.point, q.point, r.point) == -expected);
  REQUIRE(orient2d(s.input, view, q.point, p.point, r.point) == -expected);
  const auto quick = filtered_orient2d(view, p.point, q.point, r.point);
  if (quick) REQUIRE(*quick == expected);
}

void check_order(Scene& s, TierTable& table, const std::vector<Known>& known) {
  const Known &p = s.random.pick(known), &q = s.random.pick(known);
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const Sign expected = sign_of(Rational(p.place[i] - q.place[i]));
    REQUIRE(table.ask("compare", [&] { return compare(s.input, axis, p.point, q.point); }) == expected);
    REQUIRE(compare(s.input, axis, q.point, p.point) == -expected);
  }
  REQUIRE(table.ask("equal", [&] { return equal(s.input, p.point, q.point); }) == (p.place == q.place));
  REQUIRE(equal(s.input, q.point, p.point) == (p.place == q.place));
}

void check_face(Scene& s, TierTable& table) {
  const std::uint32_t f = s.any_face();
  const RationalPlane plane = s.plane(f);
  const RationalPoint n = plane.normal();
  for (int axis = 0; axis < 3; ++axis)
    REQUIRE(table.ask("normal_component", [&] { return normal_component(s.input, f, axis); }) ==
            sign_of(n[static_cast<std::size_t>(axis)]));
  REQUIRE(table.ask("is_degenerate", [&] { return is_degenerate(s.input, f); }) == is_zero(n));
  if (is_zero(n)) return;
  const Projection view = table.ask("projection_of", [&] { return projection_of(s.input, f); });
  REQUIRE(twice_area(plane.a, plane.b, plane.c, view.u, view.v) > 0);
  for (std::uint32_t g = 0; g < s.corners.size(); ++g) {
    const RationalPoint m = s.plane(g).normal();
    if (is_zero(m) || !is_zero(cross(m, n)) || plane.side(s.plane(g).a) != Sign::zero) continue;
    REQUIRE(table.ask("same_orientation", [&] { return same_orientation(s.input, f, g); }) == sign_of(dot(m, n)));
  }
}

void check_scene(Scene& s, TierTable& table) {
  const std::vector<Known> known = s.known_points(20);
  for (int i = 0; i < 8; ++i) {
    check_vertices(s, table);
    check_face(s, table);
    if (known.empty()) continue;
    check_orient3d(s, table, known);
    for (int k = 0; k < 4; ++k) check_side(s, table, known);
    check_orient2d(s, table, known);
    for (int k = 0; k < 3; ++k) check_order(s, table, known);
  }
}

void check_tiers(TierTable& table) {
  constexpr Tier widths[] = {Tier::bits_128,  Tier::bits_256,  Tier::bits_512,
                             Tier::bits_1024, Tier::bits_4096, Tier::unbounded};
  for (const char* predicate : {"orient3d of vertices", "orient3d", "side_of_face", "orient2d", "compare", "equal",
                                "normal_component", "is_degenerate", "projection_of", "same_orientation"}) {
    CAPTURE(predicate);
    CHECK(table.count(predicate, Tier::filter) > 0);
    CHECK(table.count(predicate, Tier::double_double) > 0);
    for (const Tier tier : widths) {
      CAPTURE(tier_names[static_cast<std::size_t>(tier)]);
      CHECK(table.count(predicate, tier) > 0);
    }
  }
  for (const char* predicate : {"orient3d of vertices", "orient3d", "side_of_face"}) {
    CAPTURE(predicate);
    CHECK(table.count(predicate, Tier::steps) > 0);
  }
  for (const char* predicate : {"orient3d of vertices", "side_of_face", "compare"})
    CHECK(table.count(predicate, Tier::names) > 0);
}

}  // namespace

// Catches: a wrong sign in any formula, a filter that is too bold, a width too small, a name trusted wrongly.
TEST_CASE("every predicate agrees with rationals and every tier of it is reached", "[kernel][property][degenerate]") {
  TierTable table;
  for (int family = 0; family < family_count; ++family) {
    for (int i = 0; i < affordable(static_cast<Family>(family), 300); ++i) {
      CAPTURE(family, i);
      Scene scene(static_cast<Family>(family), i % 4 == 3, static_cast<std::uint64_t>(i) + 1'000'000);
      check_scene(scene, table);
    }
  }
  if (!counts_tiers || is_sanitized) return;  // a tenth of the scenes misses the rarest
  INFO(table.to_string());
  check_tiers(table);
}
