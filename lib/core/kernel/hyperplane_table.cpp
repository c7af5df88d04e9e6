#include "core/kernel/hyperplane_table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

#include "core/exact/big_integer.h"
#include "core/kernel/homogeneous.h"
#include "core/kernel/nearest.h"

namespace strata {
namespace {

/// The vector orthogonal to all rows: the point where D hyperplanes meet, in homogeneous coordinates, w last.
template <class Number>
std::array<Number, 2> meet_of_rows(const std::array<std::array<Number, 2>, 1>& r) {
  return {Number(-r[0][1]), r[0][0]};
}

template <class Number>
std::array<Number, 3> meet_of_rows(const std::array<std::array<Number, 3>, 2>& r) {
  const auto minor = [&](std::size_t i, std::size_t j) { return Number(r[0][i] * r[1][j] - r[0][j] * r[1][i]); };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

template <class Number>
std::array<Number, 4> meet_of_rows(const std::array<std::array<Number, 4>, 3>& r) {
  const auto cross = [&](std::size_t p, std::size_t q) {
    const auto minor = [&](std::size_t i, std::size_t j) { return Number(r[p][i] * r[q][j] - r[p][j] * r[q][i]); };
    return std::array<Number, 3>{minor(1, 2), minor(2, 0), minor(0, 1)};
  };
  const std::array<std::array<Number, 3>, 3> across{cross(1, 2), cross(2, 0), cross(0, 1)};
  std::array<Number, 4> x;
  for (std::size_t i = 0; i < 3; ++i)
    x[i] = -(r[0][3] * across[0][i] + r[1][3] * across[1][i] + r[2][3] * across[2][i]);
  x[3] = r[0][0] * across[0][0] + r[0][1] * across[0][1] + r[0][2] * across[0][2];
  return x;
}

/// n . x, of the first D numbers of either.
template <int D, class Number>
Number linear(const Number* form, const Number* x) {
  Number sum = form[0] * x[0];
  for (int i = 1; i < D; ++i) sum = sum + form[i] * x[i];
  return sum;
}

template <class Number>
constexpr bool is_integer = std::is_same_v<Number, Integer> || std::is_same_v<Number, LongInt>;

/// Nullopt where the integer did not fit.
template <class Int>
std::optional<Sign> exact_sign(const Int& x) {
  if (is_lost(x)) return std::nullopt;
  return sign_of_integer(x);
}

/// n . p + c times a power of two.
template <class Int, int D>
Int value_at(const Hyperplane<D>& plane, const std::array<double, D>& p) {
  int unit = 0;
  for (const double x : p) unit = std::min(unit, DoubleParts(x).exponent);
  Int sum = Int(plane.exact()[D]) << -unit;
  for (std::size_t i = 0; i < D; ++i) {
    const DoubleParts x(p[i]);
    const Int term = Int(plane.exact()[i]) * Int(static_cast<std::int64_t>(x.magnitude)) << x.exponent - unit;
    sum = x.negative ? Int(sum - term) : Int(sum + term);
  }
  return sum;
}

/// The sign of n / w - x; nullopt where integers do not fit.
std::optional<Sign> compared(const LongInt& n, const LongInt& w, double x) {
  const DoubleParts parts(x);
  LongInt product = w * LongInt::shifted(parts.magnitude, std::max(0, parts.exponent), parts.negative);
  const auto difference = exact_sign((n << std::max(0, -parts.exponent)) - product), weight = exact_sign(w);
  if (!difference || !weight) return std::nullopt;
  return *difference * *weight;
}

/// The quotients, or nullopt where they are not known to some forty bits.
template <class Number, std::size_t D>
std::optional<std::array<Bounded, D>> quotients(const std::array<Number, D + 1>& x) {
  std::array<Bounded, D> r;
  double size = 0;
  for (std::size_t i = 0; i < D; ++i) {
    const Number q = x[i] / x[D];
    if constexpr (std::is_same_v<Number, DoubleDouble>) {
      r[i] = q.bounded();
    } else {
      r[i] = q;
    }
    size = std::max(size, std::abs(r[i].value));
  }
  for (const Bounded& q : r)
    if (!(std::isfinite(q.value) && q.error <= size * 0x1p-40)) return std::nullopt;
  return r;
}

/// A sum of products of coefficients, computed without running errors, and the sum of the magnitudes of all terms, from
/// which its bound is computed at the end. theory.md, "Hyperplanes".
struct Sized {
  double value = 0, size = 0;

  Sized() = default;
  explicit Sized(double x) : value(x), size(std::abs(x) <= 0x1p100 ? std::abs(x) : HUGE_VAL) {}
  Sized(double v, double s) : value(v), size(s) {}

  friend Sized operator+(Sized a, Sized b) { return {a.value + b.value, a.size + b.size}; }
  friend Sized operator-(Sized a, Sized b) { return {a.value - b.value, a.size + b.size}; }
  friend Sized operator*(Sized a, Sized b) { return {a.value * b.value, a.size * b.size}; }
  Sized operator-() const { return {-value, size}; }

  [[nodiscard]] Bounded bounded() const { return {value, size * 0x1p-48 + 0x1p-880}; }
};

template <std::size_t N>
std::array<Bounded, N> bounded(const std::array<Sized, N>& x) {
  std::array<Bounded, N> r;
  for (std::size_t i = 0; i < N; ++i) r[i] = x[i].bounded();
  return r;
}

/// theory.md, "Hyperplanes".
constexpr double bound_of_value(double size, double reach, double error) {
  return size * 0x1p-48 + reach * 0x1p-110 + error * Bounded::slack + 0x1p-990;
}

/// The side of a point, zero where doubles do not decide.
template <int D, class Number>
Sign side_in_doubles(const std::array<double, D + 1>& form, const std::array<Number, D>& p) {
  double value = form[D], size = std::abs(value), reach = 0, error = 0;
  for (std::size_t i = 0; i < D; ++i) {
    const Bounded x = p[i];
    const double product = form[i] * x.value;
    value += product;
    size += std::abs(product);
    reach += std::abs(x.value);
    error += x.error;
  }
  const double bound = bound_of_value(size, reach, error);
  return value > bound ? Sign::positive : -value > bound ? Sign::negative : Sign::zero;
}

Bounded nearest(const Rational& x) { return nearest_double_double(x).bounded(); }

Rational quotient(const Integer& x, const Integer& w) { return w < 0 ? Rational(-x, -w) : Rational(x, w); }

std::optional<Sign> sign_of_bounded(const DoubleDouble& x) { return x.bounded().sign(); }

}  // namespace

template <int D>
std::uint32_t HyperplaneTable<D>::add_shared(Shared hyperplane) {
  if (const auto known = find(*hyperplane)) return *known;
  const std::uint32_t number = size();
  numbers_.emplace(hyperplane->hash(), number);
  std::array<double, D + 1>& form = forms_.emplace_back();
  for (std::size_t i = 0; i <= D; ++i) form[i] = hyperplane->bounded()[i].value;
  hyperplanes_.push_back(std::move(hyperplane));
  noted_.emplace_back();
  return number;
}

template <int D>
std::uint32_t HyperplaneTable<D>::adopt(const HyperplaneTable& other, std::uint32_t h) {
  const std::uint32_t number = add_shared(other.hyperplanes_[h]);
  for (const Point& p : other.noted_[h]) note(number, p);
  return number;
}

template <int D>
void HyperplaneTable<D>::note(std::uint32_t h, const Point& p) {
  if (noted_[h].size() < most_noted && !is_noted(h, p)) noted_[h].push_back(p);
}

template <int D>
bool HyperplaneTable<D>::is_noted(std::uint32_t h, const Point& p) const {
  return std::find(noted_[h].begin(), noted_[h].end(), p) != noted_[h].end();
}

template <int D>
auto HyperplaneTable<D>::noted_on_all(const std::array<std::uint32_t, D>& names) const -> std::optional<Point> {
  if (std::any_of(names.begin(), names.end(), is_frame)) return std::nullopt;
  for (const Point& p : noted_[names.back()])
    if (std::all_of(names.begin(), names.end() - 1, [&](std::uint32_t h) { return is_noted(h, p); })) return p;
  return std::nullopt;
}

template <int D>
bool HyperplaneTable<D>::lies_in(std::uint32_t h, const HyperplaneMeet<D>& corner) const {
  if (corner.is_given()) {
    Point p;
    for (std::size_t i = 0; i < D; ++i) p[i] = corner.at[i].value;
    return is_noted(h, p);
  }
  if constexpr (D == 3) {  // two points on the line of two of its planes
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t i = corner.names[(k + 1) % 3], j = corner.names[(k + 2) % 3];
      const auto count = std::count_if(noted_[h].begin(), noted_[h].end(),
                                       [&](const Point& p) { return is_noted(i, p) && is_noted(j, p); });
      if (count > 1) return true;
    }
  }
  return false;
}

template <int D>
std::optional<std::uint32_t> HyperplaneTable<D>::find(const Hyperplane<D>& hyperplane) const {
  const auto [first, last] = numbers_.equal_range(hyperplane.hash());
  for (auto at = first; at != last; ++at)
    if (*hyperplanes_[at->second] == hyperplane) return at->second;
  return std::nullopt;
}

/// The linear form of a hyperplane for the near part of a meet, where the frame contains 0, or for the far part, where
/// all other hyperplanes contain 0 and the frame is at distance 1.
template <int D>
template <class Number>
std::array<Number, D + 1> HyperplaneTable<D>::row(std::uint32_t h, bool is_far) const {
  std::array<Number, D + 1> r{};
  if (is_frame(h)) {
    const std::uint32_t k = h - first_of_frame;
    r[k / 2] = Number(k % 2 == 1 ? 1 : -1);
    r[D] = Number(is_far ? -1 : 0);
    return r;
  }
  const Hyperplane<D>& plane = *hyperplanes_[h];
  for (std::size_t i = 0; i <= D; ++i) {
    if constexpr (is_integer<Number>) {
      r[i] = Number(plane.exact()[i]);
    } else if constexpr (std::is_same_v<Number, DoubleDouble>) {
      r[i] = plane.fine()[i];
    } else {
      r[i] = Sized(forms_[h][i]);
    }
  }
  if (is_far) r[D] = Number(0);
  return r;
}

template <int D>
template <class Number>
std::array<Number, D + 1> HyperplaneTable<D>::part(const std::array<std::uint32_t, D>& names, bool is_far) const {
  std::array<std::array<Number, D + 1>, D> rows;
  for (std::size_t i = 0; i < D; ++i) rows[i] = row<Number>(names[i], is_far);
  return meet_of_rows(rows);
}

template <int D>
HyperplaneMeet<D> HyperplaneTable<D>::meet(const std::array<std::uint32_t, D>& names) const {
  if (const auto p = noted_on_all(names)) return given(names, *p);
  HyperplaneMeet<D> corner{names, std::any_of(names.begin(), names.end(), is_frame), {}};
  auto at = quotients<Bounded, D>(bounded(part<Sized>(names, corner.is_far)));
  if (!at) at = quotients<DoubleDouble, D>(part<DoubleDouble>(names, corner.is_far));
  if (at) {
    corner.at = *at;
    return corner;
  }
  const std::array<Integer, D + 1> exact = part<Integer>(names, corner.is_far);
  for (std::size_t i = 0; i < D; ++i) corner.at[i] = nearest(quotient(exact[i], exact[D]));
  return corner;
}

template <int D>
HyperplaneMeet<D> HyperplaneTable<D>::given(const std::array<std::uint32_t, D>& names, const Point& place) {
  HyperplaneMeet<D> corner{names, false, {}};
  for (std::size_t i = 0; i < D; ++i) corner.at[i] = place[i];
  return corner;
}

template <int D>
Sign HyperplaneTable<D>::side(std::uint32_t h, const HyperplaneMeet<D>& corner) const {
  if (std::find(corner.names.begin(), corner.names.end(), h) != corner.names.end()) return Sign::zero;
  if (!corner.is_far)
    if (const Sign sign = side_in_doubles<D>(forms_[h], corner.at); sign != Sign::zero) return sign;
  return side_beyond_doubles(h, corner);
}

template <int D>
auto HyperplaneTable<D>::form_within(std::uint32_t h, const std::array<Bounded, D>& largest) const -> FormWithin {
  const std::array<double, D + 1>& form = forms_[h];
  double size = std::abs(form[D]), reach = 0, error = 0;
  for (std::size_t i = 0; i < D; ++i) {
    size += std::abs(form[i]) * std::abs(largest[i].value);
    reach += std::abs(largest[i].value);
    error += largest[i].error;
  }
  return {form, bound_of_value(size, reach, error)};
}

template <int D>
Sign HyperplaneTable<D>::side_beyond_doubles(std::uint32_t h, const HyperplaneMeet<D>& corner) const {
  const Hyperplane<D>& plane = *hyperplanes_[h];
  if (corner.is_far) {
    if (const auto sign = linear<D>(plane.bounded().data(), corner.at.data()).sign(); sign && *sign != Sign::zero)
      return *sign;
    return exact_side(h, corner);
  }
  if (lies_in(h, corner)) return Sign::zero;
  if (!corner.is_given()) {
    const std::array<DoubleDouble, D + 1> fine = part<DoubleDouble>(corner.names, false);
    const auto value = sign_of_bounded(linear<D>(plane.fine().data(), fine.data()) + plane.fine()[D] * fine[D]);
    const auto weight = sign_of_bounded(fine[D]);
    if (value && weight && *weight != Sign::zero) return *value * *weight;
  }
  return exact_side(h, corner);
}

template <int D>
Sign HyperplaneTable<D>::side(std::uint32_t h, const Point& p) const {
  if (const Sign sign = side_in_doubles<D>(forms_[h], p); sign != Sign::zero) return sign;
  std::array<DoubleDouble, D> x;
  std::copy(p.begin(), p.end(), x.begin());
  const auto& fine = hyperplanes_[h]->fine();
  if (const auto sign = sign_of_bounded(linear<D>(fine.data(), x.data()) + fine[D])) return *sign;
  return exact_side(h, p);
}

template <int D>
Sign HyperplaneTable<D>::side(std::uint32_t h, const RationalVector<D>& p) const {
  const auto& plane = hyperplanes_[h]->exact();
  Rational sum = plane[D];
  for (std::size_t i = 0; i < D; ++i) sum += plane[i] * p[i];
  return sign_of(sum);
}

template <int D>
Sign HyperplaneTable<D>::exact_side(std::uint32_t h, const Point& p) const {
  if (const auto sign = exact_sign(value_at<LongInt, D>(*hyperplanes_[h], p))) return *sign;
  return *exact_sign(value_at<Integer, D>(*hyperplanes_[h], p));
}

template <int D>
Sign HyperplaneTable<D>::exact_side(std::uint32_t h, const HyperplaneMeet<D>& corner) const {
  if (corner.is_given()) {
    Point p;
    for (std::size_t i = 0; i < D; ++i) p[i] = corner.at[i].value;
    return exact_side(h, p);
  }
  if (const auto sign = exact_side_of_meet<LongInt>(h, corner)) return *sign;
  return *exact_side_of_meet<Integer>(h, corner);
}

template <int D>
template <class Int>
std::optional<Sign> HyperplaneTable<D>::exact_side_of_meet(std::uint32_t h, const HyperplaneMeet<D>& corner) const {
  const std::array<Int, D + 1> plane = row<Int>(h, false);
  const auto sign_at = [&](bool is_far) -> std::optional<Sign> {
    const std::array<Int, D + 1> x = part<Int>(corner.names, is_far);
    Int value = linear<D>(plane.data(), x.data());
    if (!is_far) value = value + plane[D] * x[D];
    const auto sign = exact_sign(value), weight = exact_sign(x[D]);
    if (!sign || !weight) return std::nullopt;
    return *sign * *weight;
  };
  if (corner.is_far)
    if (const auto sign = sign_at(true); sign != Sign::zero) return sign;
  return sign_at(false);
}

template <int D>
RationalVector<D> HyperplaneTable<D>::position(const HyperplaneMeet<D>& corner) const {
  if (!corner.is_given()) return position(corner.names);
  RationalVector<D> r;
  for (std::size_t i = 0; i < D; ++i) r[i] = to_rational(corner.at[i].value);
  return r;
}

template <int D>
RationalVector<D> HyperplaneTable<D>::position(const std::array<std::uint32_t, D>& names) const {
  const std::array<Integer, D + 1> place = part<Integer>(names, false);
  RationalVector<D> r;
  for (std::size_t i = 0; i < D; ++i) r[i] = quotient(place[i], place[D]);
  return r;
}

template <int D>
RoundedPoint<D> HyperplaneTable<D>::rounded(const HyperplaneMeet<D>& corner) const {
  RoundedPoint<D> place;
  if (corner.is_given()) {
    for (std::size_t i = 0; i < D; ++i) place.nearest[i] = corner.at[i].value + 0.0;  // -0 is 0
    return place;
  }
  const std::array<DoubleDouble, D + 1> fine = part<DoubleDouble>(corner.names, false);
  std::optional<std::array<LongInt, D + 1>> exact;
  for (std::size_t i = 0; i < D; ++i) {
    const DoubleDouble q = fine[i] / fine[D];
    const bool is_nearest = std::isfinite(q.value) && q.rounds_to_value();
    place.nearest[i] = is_nearest ? q.value + 0.0 : 0.0;
    if (is_nearest && std::abs(q.low) > q.error) {
      place.rest[i] = q.low > 0 ? Sign::positive : Sign::negative;
      continue;
    }
    if (!exact) exact = part<LongInt>(corner.names, false);
    const auto rest = compared((*exact)[i], (*exact)[D], place.nearest[i]);
    if (rest && (is_nearest || *rest == Sign::zero)) {
      place.rest[i] = *rest;
      continue;
    }
    const std::array<Integer, D + 1> any_size = part<Integer>(corner.names, false);
    const Rational x = quotient(any_size[i], any_size[D]);
    place.nearest[i] = to_nearest_double(x) + 0.0;
    place.rest[i] = sign_of(Rational(x - to_rational(place.nearest[i])));
  }
  return place;
}

template <int D>
std::size_t HyperplaneTable<D>::bytes() const {
  std::size_t sum = 0;
  for (const Shared& plane : hyperplanes_) {
    sum += sizeof *plane + 64;  // its entry in the hash table
    for (const Integer& x : plane->exact()) sum += 8 * limbs_of(x).size();
  }
  for (const Points& points : noted_)
    sum += sizeof points + (points.size() > Points::static_capacity ? points.capacity() * sizeof(Point) : 0);
  return sum;
}

template class HyperplaneTable<1>;
template class HyperplaneTable<2>;
template class HyperplaneTable<3>;

}  // namespace strata
