#include "core/kernel/hyperplane_table.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>

#include "support/random.h"

namespace strata {
namespace {

using test::Random;

/// Small integers, so that hyperplanes love to meet in one point; seldom doubles of many sizes.
Rational number(Random& random, int largest_exponent) {
  if (!random.once_in(12)) return random.between(-2, 2);
  return to_rational(std::ldexp(random.unit() - 0.5, random.between(-largest_exponent, largest_exponent)));
}

template <int D>
std::optional<std::uint32_t> random_hyperplane(Random& random, HyperplaneTable<D>& table, int largest_exponent) {
  std::array<Rational, D + 1> form;
  bool has_normal = false;
  for (std::size_t i = 0; i <= D; ++i) {
    form[i] = number(random, largest_exponent);
    has_normal |= i < D && form[i] != 0;
  }
  if (!has_normal) return std::nullopt;
  return table.add(oriented_hyperplane<D>(form).hyperplane);
}

/// By elimination in rationals; the frame is at a distance that nothing here comes near to.
template <int D>
std::optional<RationalVector<D>> solved(const HyperplaneTable<D>& table, const std::array<std::uint32_t, D>& names) {
  const Rational far = Rational(Integer(1) << 3000);
  std::array<std::array<Rational, D + 1>, D> rows{};
  for (std::size_t r = 0; r < D; ++r) {
    for (std::size_t axis = 0; axis < D; ++axis)
      for (const bool is_upper : {false, true})
        if (names[r] == HyperplaneTable<D>::frame(axis, is_upper)) {
          rows[r][axis] = 1;
          rows[r][D] = is_upper ? far : Rational(-far);
        }
    if (HyperplaneTable<D>::is_frame(names[r])) continue;
    for (std::size_t i = 0; i < D; ++i) rows[r][i] = table[names[r]].exact()[i];
    rows[r][D] = -table[names[r]].exact()[D];
  }
  for (std::size_t c = 0; c < D; ++c) {
    std::size_t pivot = c;
    while (pivot < D && rows[pivot][c] == 0) ++pivot;
    if (pivot == D) return std::nullopt;
    std::swap(rows[c], rows[pivot]);
    for (std::size_t r = 0; r < D; ++r) {
      if (r == c || rows[r][c] == 0) continue;
      const Rational factor = rows[r][c] / rows[c][c];
      for (std::size_t i = c; i <= D; ++i) rows[r][i] -= factor * rows[c][i];
    }
  }
  RationalVector<D> x;
  for (std::size_t c = 0; c < D; ++c) x[c] = rows[c][D] / rows[c][c];
  return x;
}

/// Notes some of the points with small integers on each hyperplane.
template <int D>
void note_points(Random& random, HyperplaneTable<D>& table) {
  std::array<int, D> place;
  place.fill(-2);
  const auto next = [&place] {
    std::size_t i = 0;
    while (i < D && place[i] == 2) place[i++] = -2;
    if (i < D) ++place[i];
    return i < D;
  };
  do {
    std::array<double, D> p;
    std::copy(place.begin(), place.end(), p.begin());
    for (std::uint32_t h = 0; h < table.size(); ++h)
      if (table.side(h, p) == Sign::zero && !random.once_in(3)) table.note(h, p);
  } while (next());
}

/// Rounding to the nearest double, and the sign of what that left out.
template <int D>
void check_rounded(const RoundedPoint<D>& rounded, const RationalVector<D>& place) {
  for (std::size_t i = 0; i < D; ++i) {
    REQUIRE(rounded.nearest[i] == to_nearest_double(place[i]));
    REQUIRE_FALSE((rounded.nearest[i] == 0 && std::signbit(rounded.nearest[i])));
    REQUIRE(rounded.rest[i] == sign_of(Rational(place[i] - to_rational(rounded.nearest[i]))));
  }
}

/// Where the form is certain, it is right; where coordinates are doubles and the value is large, it is certain.
template <int D>
void check_form(const HyperplaneTable<D>& table, std::uint32_t h, const HyperplaneMeet<D>& corner) {
  std::array<Bounded, D> largest;
  for (std::size_t i = 0; i < D; ++i) largest[i] = Bounded(std::abs(corner.at[i].value), corner.at[i].error);
  const auto [form, bound] = table.form_within(h, largest);
  double value = form[D];
  for (std::size_t i = 0; i < D; ++i) value += form[i] * corner.at[i].value;
  if (std::abs(value) > bound) REQUIRE(table.side(h, corner) == (value > 0 ? Sign::positive : Sign::negative));
  if (corner.is_given() && std::abs(value) > 1e-3 && std::abs(value) < 10) REQUIRE(bound < 1e-3);
}

template <int D>
void check_random_meets(bool with_frame, int fewest_zeros, bool is_noted = false, int largest_exponent = 200) {
  int asked = 0, zeros = 0;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    CAPTURE(D, seed);
    Random random(seed);
    HyperplaneTable<D> table;
    std::array<std::uint32_t, D> names{};
    for (std::size_t i = 0; i < D; ++i) {
      const auto h = random_hyperplane<D>(random, table, largest_exponent);
      names[i] = h ? *h : HyperplaneTable<D>::frame(0, false);
      if (with_frame && random.once_in(2)) names[i] = HyperplaneTable<D>::frame(random.below(D), random.once_in(2));
      if (!with_frame && !h) names[i] = table.add(axis_hyperplane<D>(i, 1));
    }
    const auto h = random_hyperplane<D>(random, table, largest_exponent);
    const auto place = solved<D>(table, names);
    if (!h || !place) continue;
    if (is_noted) note_points(random, table);
    const HyperplaneMeet<D> corner = table.meet(names);
    const Sign side = table.side(*h, corner);
    CHECK(side == table.side(*h, *place));
    ++asked;
    zeros += side == Sign::zero ? 1 : 0;
    if (corner.is_far) continue;
    CHECK(table.position(corner) == *place);
    check_form<D>(table, *h, corner);
    const auto is_finite = [](const Rational& x) { return std::isfinite(to_nearest_double(x)); };
    if (!std::all_of(place->begin(), place->end(), is_finite)) continue;
    check_rounded<D>(table.rounded(corner), *place);
    for (std::size_t i = 0; i < D; ++i) {
      const Rational off = abs(to_rational(corner.at[i].value) - (*place)[i]);
      CHECK(off <= to_rational(corner.at[i].error * Bounded::slack));
    }
  }
  CHECK(asked > 1500);
  CHECK(zeros >= fewest_zeros);
}

}  // namespace

TEST_CASE("corners of hyperplanes are on the sides that elimination in rationals says", "[kernel][property]") {
  check_random_meets<1>(false, 300);
  check_random_meets<2>(false, 100);
  check_random_meets<3>(false, 50);
}

// Integers of more than 4096 bits: the long ones do not hold these.
TEST_CASE("corners of hyperplanes of very different sizes are on the right sides", "[kernel][property]") {
  check_random_meets<2>(false, 100, false, 1020);
  check_random_meets<3>(false, 50, true, 1020);
}

TEST_CASE("noted points change no answer", "[kernel][property]") {
  check_random_meets<1>(false, 300, true);
  check_random_meets<2>(true, 60, true);
  check_random_meets<3>(false, 50, true);
  check_random_meets<3>(true, 25, true);
}

TEST_CASE("corners on the frame are where they are when the frame is far enough away", "[kernel][property]") {
  check_random_meets<1>(true, 100);
  check_random_meets<2>(true, 50);
  check_random_meets<3>(true, 20);
}

TEST_CASE("points of doubles are on the side of the exact expression", "[kernel][property]") {
  int zeros = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    HyperplaneTable<3> table;
    std::array<RationalVector<3>, 3> corners;
    std::array<std::array<double, 3>, 3> doubles{};
    const int scale = random.once_in(3) ? random.between(-300, 300) : 0;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) {
        doubles[k][i] = std::ldexp(random.once_in(2) ? random.unit() : random.between(-2, 2), scale);
        corners[k][i] = to_rational(doubles[k][i]);
      }
    Rational area = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      area += abs((corners[1][i] - corners[0][i]) * (corners[2][j] - corners[0][j]) -
                  (corners[1][j] - corners[0][j]) * (corners[2][i] - corners[0][i]));
    }
    if (area == 0) continue;
    const OrientedHyperplane<3> plane = plane_through(corners[0], corners[1], corners[2]);
    const std::uint32_t h = table.add(plane.hyperplane);
    for (const auto& p : doubles) CHECK(table.side(h, p) == Sign::zero);
    std::array<double, 3> near = doubles[0];
    near[seed % 3] = std::nextafter(near[seed % 3], HUGE_VAL);
    const RationalVector<3> exact{to_rational(near[0]), to_rational(near[1]), to_rational(near[2])};
    CHECK(table.side(h, near) == table.side(h, exact));
    CHECK(table.side(h, HyperplaneTable<3>::given({7, 8, 9}, near)) == table.side(h, exact));
    zeros += table.side(h, near) == Sign::zero ? 1 : 0;
    const RationalVector<3> above{corners[0][0] + plane.hyperplane.exact()[0],
                                  corners[0][1] + plane.hyperplane.exact()[1],
                                  corners[0][2] + plane.hyperplane.exact()[2]};
    CHECK(table.side(h, above) == Sign::positive);
  }
  CHECK(zeros > 10);
}

TEST_CASE("a hyperplane is the same whichever way and however often it is given", "[kernel]") {
  HyperplaneTable<2> table;
  const RationalVector<2> p{0, 1}, q{2, Rational(1, 3)};
  const OrientedHyperplane<2> there = line_through(p, q), back = line_through(q, p);
  CHECK(there.is_reversed != back.is_reversed);
  CHECK(table.add(there.hyperplane) == table.add(back.hyperplane));
  CHECK(table.size() == 1);
  // Left of the way from p to q is above it.
  CHECK(table.side(0, RationalVector<2>{0, 2}) == (there.is_reversed ? Sign::negative : Sign::positive));
}

TEST_CASE("a plane looks to where its three points are seen counter-clockwise", "[kernel]") {
  const OrientedHyperplane<3> up = plane_through({0, 0, 5}, {1, 0, 5}, {0, 1, 5});
  const OrientedHyperplane<3> down = plane_through({0, 0, 5}, {0, 1, 5}, {1, 0, 5});
  CHECK_FALSE(up.is_reversed);
  CHECK(down.is_reversed);
  CHECK(up.hyperplane == down.hyperplane);
  CHECK(up.hyperplane == axis_hyperplane<3>(2, 5));
}

}  // namespace strata
