#include "core/attributes/interpolate.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <type_traits>

namespace strata {
namespace {

using Place = FaceFrame::Place;
constexpr std::size_t most_components = 4;

template <class T>
bool have_equal_bits(T a, T b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

/// Integers are rounded to nearest, ties to even, as are floats.
template <class T>
T rounded(double x) {
  if constexpr (std::is_integral_v<T>)
    return static_cast<T>(std::nearbyint(x));
  else
    return static_cast<T>(x);
}

template <class T>
T rounded(const Rational& x) {
  if constexpr (std::is_same_v<T, double>) {
    return to_nearest_double(x);
  } else if constexpr (std::is_same_v<T, float>) {
    return to_nearest_float(x);
  } else {
    const Rational doubled = 2 * x + 1;  // not negative: integers here are bytes
    const Integer twice = 2 * denominator(doubled);
    auto [quotient, remainder] = divide(numerator(doubled), twice);
    if (remainder.is_zero() && !(quotient % Integer(2)).is_zero()) quotient -= 1;
    return static_cast<T>(quotient.to_int64());
  }
}

/// The nearest T, if all numbers within the error have the same one.
template <class T>
std::optional<T> rounded(const DoubleDouble& x) {
  if constexpr (std::is_same_v<T, double>) {
    return x.rounds_to_value() ? std::optional(x.value) : std::nullopt;
  } else {
    if (!std::isfinite(x.value) || !(x.error < HUGE_VAL)) return std::nullopt;
    const double e = x.error * Bounded::slack;
    const double lower = std::nextafter(x.value + (x.low - e), -HUGE_VAL);
    const double upper = std::nextafter(x.value + (x.low + e), HUGE_VAL);
    const T r = rounded<T>(lower);
    return r == rounded<T>(upper) ? std::optional<T>(static_cast<T>(r + T{})) : std::nullopt;  // no -0
  }
}

using Numbers = std::array<double, 3>;  // per corner

bool are_finite(const Numbers& v) {
  return std::all_of(v.begin(), v.end(), [](double x) { return std::isfinite(x); });
}

DoubleDouble fine_sum(const Place& place, const Numbers& v) {
  const DoubleDouble first(v[0]);
  return first + place.second() * (DoubleDouble(v[1]) - first) + place.third() * (DoubleDouble(v[2]) - first);
}

Rational exact_sum(const Place& place, const Numbers& v) {
  const FaceFrame::Weights& w = place.exact();
  return w[0] * to_rational(v[0]) + w[1] * to_rational(v[1]) + w[2] * to_rational(v[2]);
}

/// Of a place off the face, or of numbers that are not all finite.
double rough_sum(const Place& place, const Numbers& v) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double w = place.is_inside() ? to_nearest_double(place.exact()[k]) : place.clamped()[k];
    const bool has_part = place.is_inside() ? place.exact()[k] != 0 : w != 0;
    if (has_part) sum += w * v[k];
  }
  return sum;
}

template <class T>
T linear(const Place& place, const std::array<T, 3>& values) {
  if (have_equal_bits(values[0], values[1]) && have_equal_bits(values[0], values[2])) return values[0];
  const Numbers v{static_cast<double>(values[0]), static_cast<double>(values[1]), static_cast<double>(values[2])};
  if (!place.is_inside() || !are_finite(v)) return rounded<T>(rough_sum(place, v));
  if (const auto r = rounded<T>(fine_sum(place, v))) return *r;
  return rounded<T>(exact_sum(place, v));
}

template <class T>
std::array<T, 3> component(const CornerValues<T>& values, std::size_t c) {
  return {values[0][c], values[1][c], values[2][c]};
}

template <class T>
void copy_corner(const CornerValues<T>& values, std::size_t k, std::span<T> out) {
  std::copy(values[k].begin(), values[k].end(), out.begin());
}

/// The square root by one step of Newton's iteration from the nearest double, with a bound: the error of r is
/// (x - r^2) / (r + sqrt(x)), which that of the step is the square of, over 2 r.
DoubleDouble root(const DoubleDouble& x) {
  const DoubleDouble r(std::sqrt(x.value));
  const DoubleDouble step = (x - r * r) / (r + r);
  DoubleDouble refined = r + step;
  refined.error += step.value * step.value / r.value;
  return refined;
}

/// Directions in doubles, of which nothing more is asked.
template <class T>
bool normalise_roughly(const Place& place, const CornerValues<T>& values, std::span<T> out) {
  std::array<double, most_components> sum{};
  double size = 0;
  for (std::size_t c = 0; c < out.size(); ++c) {
    const auto v = component(values, c);
    sum[c] = rough_sum(place, {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])});
    size = std::max(size, std::abs(sum[c]));
  }
  if (size == 0) return false;
  double square = 0;
  for (double& x : sum) {
    x /= size;
    square += x * x;
  }
  for (std::size_t c = 0; c < out.size(); ++c) out[c] = rounded<T>(sum[c] / std::sqrt(square));
  return true;
}

template <class T>
bool normalise_finely(const Place& place, const CornerValues<T>& values, std::span<T> out) {
  std::array<DoubleDouble, most_components> sum;
  DoubleDouble square(0.0);
  for (std::size_t c = 0; c < out.size(); ++c) {
    const auto v = component(values, c);
    const Numbers numbers{static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
    // Where the sum is 0 at all corners there is no error, which the bound would not show.
    if (numbers != Numbers{0, 0, 0}) sum[c] = fine_sum(place, numbers);
    square = square + sum[c] * sum[c];
  }
  constexpr double least = 0x1p-400;  // below, the bounds of errors by underflow are too large
  if (!(square.value > least) || !(square.error < square.value * 0x1p-40)) return false;
  const DoubleDouble length = root(square);
  for (std::size_t c = 0; c < out.size(); ++c) {
    if (sum[c].value == 0 && sum[c].error == 0) {
      out[c] = T{};
      continue;
    }
    const auto r = rounded<T>(sum[c] / length);
    if (!r) return false;
    out[c] = *r;
  }
  return true;
}

template <class T>
bool normalise_exactly(const Place& place, const CornerValues<T>& values, std::span<T> out) {
  std::array<Rational, most_components> sum;
  Rational square = 0;
  for (std::size_t c = 0; c < out.size(); ++c) {
    const auto v = component(values, c);
    sum[c] = exact_sum(place, {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])});
    square += sum[c] * sum[c];
  }
  if (square == 0) return false;
  for (std::size_t c = 0; c < out.size(); ++c) out[c] = quotient_by_root<T>(sum[c], square);
  return true;
}

template <class T>
void spherical(const Place& place, const CornerValues<T>& values, std::span<T> out) {
  bool is_finite = true;
  for (const auto& corner : values)
    for (const T x : corner) is_finite = is_finite && std::isfinite(x);
  bool is_direction = false;
  if (!place.is_inside() || !is_finite)
    is_direction = normalise_roughly(place, values, out);
  else
    is_direction = normalise_finely(place, values, out) || normalise_exactly(place, values, out);
  if (!is_direction) copy_corner(values, place.nearest_corner(), out);
}

}  // namespace

template <class T>
T quotient_by_root(const Rational& x, const Rational& square) {
  if (x == 0) return T{};
  const Rational size = abs(x);
  const auto is_more_than = [&](const Rational& m) { return size * size > m * m * square; };
  const auto is_less_than = [&](const Rational& m) { return size * size < m * m * square; };
  const auto middle = [](T a, T b) {
    return (Rational(static_cast<double>(a)) + Rational(static_cast<double>(b))) / 2;
  };
  const auto is_even = [](T a) {
    using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    return (std::bit_cast<Bits>(a) & 1U) == 0;
  };
  // An approximation, from a quotient of the size of 1 (times 4^-half).
  const Rational inverse = square / (size * size);
  const auto half = static_cast<int>(
      (static_cast<long>(bit_length(numerator(inverse))) - static_cast<long>(bit_length(denominator(inverse)))) / 2);
  const Rational unit = pow(Integer(2), static_cast<unsigned>(std::abs(half)));
  const Rational scaled = half < 0 ? inverse * unit * unit : inverse / (unit * unit);
  T r = static_cast<T>(std::ldexp(1 / std::sqrt(to_nearest_double(scaled)), -half));
  for (;;) {
    const T above = std::nextafter(r, static_cast<T>(2)), below = std::nextafter(r, T{});
    const Rational upper = middle(r, above);
    if (is_more_than(upper) || (!is_less_than(upper) && !is_even(r))) {
      r = above;
    } else if (r > 0 && (is_less_than(middle(below, r)) || (!is_more_than(middle(below, r)) && !is_even(r)))) {
      r = below;
    } else {
      break;
    }
  }
  return x < 0 ? -r : r;
}

template <class T>
void interpolate(const Place& place, Interpolation rule, const CornerValues<T>& values, std::span<T> out) {
  switch (rule) {
    case Interpolation::linear:
      for (std::size_t c = 0; c < out.size(); ++c) out[c] = linear(place, component(values, c));
      return;
    case Interpolation::spherical:
      if constexpr (std::is_floating_point_v<T>) {
        spherical(place, values, out);
        return;
      }
      [[fallthrough]];  // refused before
    case Interpolation::nearest:
      copy_corner(values, place.nearest_corner(), out);
      return;
  }
}

template void interpolate(const Place&, Interpolation, const CornerValues<float>&, std::span<float>);
template void interpolate(const Place&, Interpolation, const CornerValues<double>&, std::span<double>);
template void interpolate(const Place&, Interpolation, const CornerValues<std::uint8_t>&, std::span<std::uint8_t>);
template void interpolate(const Place&, Interpolation, const CornerValues<std::int32_t>&, std::span<std::int32_t>);
template float quotient_by_root<float>(const Rational&, const Rational&);
template double quotient_by_root<double>(const Rational&, const Rational&);

}  // namespace strata
