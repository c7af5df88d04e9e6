#include "core/kernel/hyperplane.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/exact/big_integer.h"
#include "core/exact/lattice.h"

namespace strata {
namespace {

/// |x| without its lowest bits.
struct Leading {
  unsigned __int128 bits = 0;
  int size = 0;  ///< bits of |x|
  int lost = 0;  ///< of them left out
};

Leading leading(const Integer& x) {
  constexpr int kept = 120;
  const std::span<const std::uint64_t> limbs = limbs_of(x);
  Leading r;
  r.size = static_cast<int>(bit_length(x));
  r.lost = std::max(0, r.size - kept);
  const int bit = r.lost % 64;
  for (int word = 2; word >= 0; --word) {
    const unsigned __int128 limb = limb_or_zero(limbs, static_cast<std::size_t>(r.lost / 64 + word));
    const int place = 64 * word - bit;
    if (place < 128) r.bits |= place < 0 ? limb >> -place : limb << place;
  }
  return r;
}

/// x * 2^exponent. The bound includes rounding and underflow.
DoubleDouble scaled(const Integer& x, int exponent) {
  constexpr int smallest = -900;
  const Leading top = leading(x);
  const double sign = x < 0 ? -1 : 1;
  const auto high = static_cast<double>(top.bits);
  const auto rest = static_cast<__int128>(top.bits - static_cast<unsigned __int128>(high));
  const auto low = static_cast<double>(rest);
  double error = rest == static_cast<__int128>(low) ? 0 : std::abs(low) * Bounded::rounding;
  if (top.lost != 0) error += 1;
  const double value = high + low;
  const int shift = top.lost + exponent;
  DoubleDouble r(std::ldexp(sign * value, shift), std::ldexp(sign * (low - (value - high)), shift),
                 std::ldexp(error, shift));
  if (!std::isfinite(r.value)) r.error = HUGE_VAL;
  if (x != 0 && top.size + exponent < smallest) r.error += Bounded::underflow;
  return r;
}

std::size_t trailing_zeros(const LongInt& x) { return static_cast<std::size_t>(x.trailing_zeros()); }
LongInt shifted_down(const LongInt& x, std::size_t bits) { return x >> static_cast<int>(bits); }
Integer shifted_down(const Integer& x, std::size_t bits) { return x >> bits; }

template <class Int>
bool is_zero(const Int& x) {
  return sign_of_integer(x) == Sign::zero;
}

/// Divided by all common factors. Powers of two first: coefficients that come from a lattice have many.
template <class Int, std::size_t N>
void make_coprime(std::array<Int, N>& x) {
  std::size_t zeros = std::numeric_limits<std::size_t>::max();
  for (const Int& k : x)
    if (!is_zero(k)) zeros = std::min(zeros, trailing_zeros(k));
  if (zeros != 0)
    for (Int& k : x) k = shifted_down(k, zeros);
  const Int one = 1;
  Int factor = 0;
  for (const Int& k : x) {
    factor = gcd(factor, k);
    if (is_zero<Int>(factor - one)) return;
  }
  for (Int& k : x) k = exact_quotient(k, factor);
}

template <int D, class Int>
bool looks_to_plus(const std::array<Int, D + 1>& coefficients) {
  for (std::size_t i = 0; i < D; ++i)
    if (const Sign sign = sign_of_integer(coefficients[i]); sign != Sign::zero) return sign == Sign::positive;
  return true;
}

template <int D, class Int>
void make_canonical(std::array<Int, D + 1>& coefficients) {
  make_coprime(coefficients);
  if (!looks_to_plus<D>(coefficients))
    for (Int& x : coefficients) x = -x;
}

template <std::size_t N>
std::array<Integer, N> integers(const std::array<Rational, N>& x) {
  Integer w = 1;
  for (const Rational& q : x) w = lcm(w, denominator(q));
  std::array<Integer, N> r;
  for (std::size_t i = 0; i < N; ++i) r[i] = numerator(x[i]) * (w / denominator(x[i]));
  return r;
}

}  // namespace

template <int D>
Hyperplane<D>::Hyperplane(Coefficients coefficients) : exact_(std::move(coefficients)) {
  make_canonical<D>(exact_);
  approximate();
}

template <int D>
Hyperplane<D>::Hyperplane(std::array<LongInt, D + 1> coefficients) {
  make_canonical<D>(coefficients);
  for (std::size_t i = 0; i <= D; ++i) exact_[i] = Integer(coefficients[i]);
  approximate();
}

template <int D>
void Hyperplane<D>::approximate() {
  int largest = 0;
  for (std::size_t i = 0; i < D; ++i) largest = std::max(largest, leading(exact_[i]).size);
  for (std::size_t i = 0; i <= D; ++i) {
    fine_[i] = scaled(exact_[i], -largest);
    bounded_[i] = fine_[i].bounded();
  }
}

template <int D>
std::size_t Hyperplane<D>::longest_axis() const {
  std::size_t axis = 0;
  for (std::size_t i = 1; i < D; ++i)
    if (std::abs(bounded_[i].value) > std::abs(bounded_[axis].value)) axis = i;
  return axis;
}

template <int D>
std::size_t Hyperplane<D>::hash() const {
  std::size_t h = 0;
  for (const Integer& x : exact_) {
    const std::size_t low = limb_or_zero(limbs_of(x), 0) + static_cast<std::size_t>(x.sign());
    h = (h ^ low) * 0x9e3779b97f4a7c15U;
    h ^= h >> 32U;
  }
  return h;
}

template <int D>
OrientedHyperplane<D> oriented_hyperplane(const std::array<Integer, D + 1>& coefficients) {
  return {Hyperplane<D>(coefficients), !looks_to_plus<D>(coefficients)};
}

template <int D>
OrientedHyperplane<D> oriented_hyperplane(const std::array<LongInt, D + 1>& coefficients) {
  return {Hyperplane<D>(coefficients), !looks_to_plus<D>(coefficients)};
}

template <int D>
OrientedHyperplane<D> oriented_hyperplane(const std::array<Rational, D + 1>& coefficients) {
  return oriented_hyperplane<D>(integers(coefficients));
}

OrientedHyperplane<3> plane_through(const RationalVector<3>& p, const RationalVector<3>& q,
                                    const RationalVector<3>& r) {
  const auto [x, y, z, ux, uy, uz, vx, vy, vz] =
      integers(std::array<Rational, 9>{p[0], p[1], p[2], q[0], q[1], q[2], r[0], r[1], r[2]});
  // On the lattice of all nine coordinates; the unit comes back with c.
  Integer unit = 1;
  for (const RationalVector<3>* v : {&p, &q, &r})
    for (const Rational& k : *v) unit = lcm(unit, denominator(k));
  const Integer ax = ux - x, ay = uy - y, az = uz - z, bx = vx - x, by = vy - y, bz = vz - z;
  const Integer a = ay * bz - az * by, b = az * bx - ax * bz, c = ax * by - ay * bx;
  return oriented_hyperplane<3>(std::array<Integer, 4>{a * unit, b * unit, c * unit, -(a * x + b * y + c * z)});
}

OrientedHyperplane<2> line_through(const RationalVector<2>& p, const RationalVector<2>& q) {
  const Rational a = p[1] - q[1], b = q[0] - p[0];
  return oriented_hyperplane<2>(std::array<Rational, 3>{a, b, -(a * p[0] + b * p[1])});
}

template <int D>
Hyperplane<D> axis_hyperplane(std::size_t axis, const Rational& value) {
  std::array<Integer, D + 1> coefficients{};
  coefficients[axis] = denominator(value);
  coefficients[D] = -numerator(value);
  return Hyperplane<D>(std::move(coefficients));
}

template class Hyperplane<1>;
template class Hyperplane<2>;
template class Hyperplane<3>;
#define STRATA_INSTANTIATE(D)                                                                \
  template OrientedHyperplane<D> oriented_hyperplane<D>(const std::array<Integer, D + 1>&);  \
  template OrientedHyperplane<D> oriented_hyperplane<D>(const std::array<LongInt, D + 1>&);  \
  template OrientedHyperplane<D> oriented_hyperplane<D>(const std::array<Rational, D + 1>&); \
  template Hyperplane<D> axis_hyperplane<D>(std::size_t, const Rational&);
STRATA_INSTANTIATE(1)
STRATA_INSTANTIATE(2)
STRATA_INSTANTIATE(3)
#undef STRATA_INSTANTIATE

}  // namespace strata
