#pragma once
/// Integers and fractions of any size: the numbers in which Strata states exact results.
///
/// Values are immutable in the sense of ordinary arithmetic types: copies are independent, reading is thread-safe. The
/// arithmetic is that of a library chosen when Strata is built (GMP, or Boost.Multiprecision's own integers); neither
/// is seen here. A program that uses a Strata built without GMP is compiled with STRATA_WITHOUT_GMP defined; the CMake
/// package and the pkg-config file see to it.
#include <array>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace strata {

namespace detail {
#ifdef STRATA_WITHOUT_GMP
inline constexpr std::size_t integer_bytes = 32, rational_bytes = 64, number_alignment = 16;
#else
inline constexpr std::size_t integer_bytes = 16, rational_bytes = 32, number_alignment = 8;
#endif
template <class T>
concept SmallInteger = std::integral<T> && sizeof(T) <= sizeof(std::int64_t);
struct Native;  // sees the number inside; lib/core/exact/big_integer.h
}  // namespace detail

/// A signed integer of any size.
/// Division truncates towards zero and the remainder has the sign of the dividend, as for built-in integers; division
/// by zero throws std::overflow_error. Running out of memory throws std::bad_alloc.
/// Complexity: sums O(n) and products at most O(n^1.59) for n digits.
class Integer {
 public:
  Integer() noexcept;
  template <detail::SmallInteger I>
  Integer(I x) {  // NOLINT(google-explicit-constructor): built-in integers are integers
    make(Small<I>(x));
  }
  /// The integer part of a finite double. Throws std::invalid_argument for what is not finite.
  explicit Integer(double x);
  /// Decimal digits with or without a sign. Throws std::invalid_argument for anything else.
  explicit Integer(std::string_view digits);
  Integer(const Integer& other);
  Integer(Integer&& other) noexcept;
  Integer& operator=(const Integer& other);
  Integer& operator=(Integer&& other) noexcept;
  ~Integer();

  Integer& operator+=(const Integer& b);
  Integer& operator-=(const Integer& b);
  Integer& operator*=(const Integer& b);
  Integer& operator/=(const Integer& b);
  Integer& operator%=(const Integer& b);
  Integer& operator<<=(std::size_t bits);  ///< times 2^bits
  Integer& operator>>=(std::size_t bits);  ///< divided by 2^bits, rounded down
  Integer& operator++() { return *this += 1; }
  Integer& operator--() { return *this -= 1; }
  [[nodiscard]] Integer operator-() const&;
  [[nodiscard]] Integer operator-() &&;

  [[nodiscard]] int sign() const noexcept;  ///< -1, 0 or 1
  [[nodiscard]] bool is_zero() const noexcept { return sign() == 0; }
  [[nodiscard]] std::strong_ordering compare(const Integer& b) const noexcept;
  [[nodiscard]] std::strong_ordering compare(std::int64_t b) const noexcept;
  [[nodiscard]] std::strong_ordering compare(std::uint64_t b) const noexcept;
  [[nodiscard]] std::string str() const;  ///< decimal digits, `-` first where negative
  /// The double nearest to it, ties to even; an infinity beyond the largest finite double.
  [[nodiscard]] double to_double() const;
  /// Its value as a built-in integer. Throws std::overflow_error where it does not fit.
  [[nodiscard]] std::int64_t to_int64() const;

  friend Integer operator+(const Integer& a, const Integer& b);
  friend Integer operator-(const Integer& a, const Integer& b);
  friend Integer operator*(const Integer& a, const Integer& b);
  friend Integer operator/(const Integer& a, const Integer& b);
  friend Integer operator%(const Integer& a, const Integer& b);
  friend Integer operator+(Integer&& a, const Integer& b) { return std::move(a += b); }
  friend Integer operator-(Integer&& a, const Integer& b) { return std::move(a -= b); }
  friend Integer operator*(Integer&& a, const Integer& b) { return std::move(a *= b); }
  friend Integer operator<<(Integer a, std::size_t bits) { return std::move(a <<= bits); }
  friend Integer operator>>(Integer a, std::size_t bits) { return std::move(a >>= bits); }
  friend bool operator==(const Integer& a, const Integer& b) noexcept { return a.compare(b) == 0; }
  friend std::strong_ordering operator<=>(const Integer& a, const Integer& b) noexcept { return a.compare(b); }
  template <detail::SmallInteger I>
  friend bool operator==(const Integer& a, I b) noexcept {
    return a.compare(Small<I>(b)) == 0;
  }
  template <detail::SmallInteger I>
  friend std::strong_ordering operator<=>(const Integer& a, I b) noexcept {
    return a.compare(Small<I>(b));
  }

 private:
  friend struct detail::Native;
  friend class Rational;
  template <class I>
  using Small = std::conditional_t<std::signed_integral<I>, std::int64_t, std::uint64_t>;
  void make(std::int64_t x);
  void make(std::uint64_t x);
  struct Uninitialised {};
  explicit Integer(Uninitialised) noexcept {}  // NOLINT: the storage is filled by who calls this

  alignas(detail::number_alignment) std::byte storage_[detail::integer_bytes];
};

[[nodiscard]] Integer abs(const Integer& x);
/// Not negative; gcd(x, 0) is |x|.
[[nodiscard]] Integer gcd(const Integer& a, const Integer& b);
[[nodiscard]] Integer lcm(const Integer& a, const Integer& b);
[[nodiscard]] Integer pow(const Integer& base, unsigned exponent);
/// The integer part of the square root. Throws std::domain_error for negative numbers.
[[nodiscard]] Integer sqrt(const Integer& x);
/// Quotient and remainder in one division. Throws std::overflow_error for b = 0.
[[nodiscard]] std::pair<Integer, Integer> divide(const Integer& a, const Integer& b);
/// The number of binary digits of |x|; 0 for 0.
[[nodiscard]] std::size_t bit_length(const Integer& x) noexcept;
/// How often 2 divides x; 0 for 0.
[[nodiscard]] std::size_t trailing_zeros(const Integer& x) noexcept;
std::ostream& operator<<(std::ostream& out, const Integer& x);

/// A fraction in lowest terms with a positive denominator.
/// Division by zero throws std::overflow_error. Every operation keeps lowest terms: it costs a gcd.
class Rational {
 public:
  Rational();
  template <detail::SmallInteger I>
  Rational(I x) : Rational(Integer(x)) {}  // NOLINT(google-explicit-constructor): integers are fractions
  Rational(const Integer& x);              // NOLINT(google-explicit-constructor)
  /// The exact value of a finite double. Throws std::invalid_argument for what is not finite.
  Rational(double x);  // NOLINT(google-explicit-constructor): every finite double is a fraction
  /// Throws std::overflow_error where the denominator is zero.
  Rational(const Integer& numerator, const Integer& denominator);
  /// "-7", "37/6". Throws std::invalid_argument for anything else, std::overflow_error for a denominator 0.
  explicit Rational(std::string_view text);
  Rational(const Rational& other);
  Rational(Rational&& other) noexcept;
  Rational& operator=(const Rational& other);
  Rational& operator=(Rational&& other) noexcept;
  ~Rational();

  Rational& operator+=(const Rational& b);
  Rational& operator-=(const Rational& b);
  Rational& operator*=(const Rational& b);
  Rational& operator/=(const Rational& b);
  [[nodiscard]] Rational operator-() const&;
  [[nodiscard]] Rational operator-() &&;

  [[nodiscard]] int sign() const noexcept;  ///< -1, 0 or 1
  [[nodiscard]] bool is_zero() const noexcept { return sign() == 0; }
  [[nodiscard]] std::strong_ordering compare(const Rational& b) const;
  [[nodiscard]] std::strong_ordering compare(std::int64_t b) const;
  [[nodiscard]] std::string str() const;  ///< "37/6"; without a denominator where this is 1

  friend Rational operator+(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a, const Rational& b);
  friend Rational operator*(const Rational& a, const Rational& b);
  friend Rational operator/(const Rational& a, const Rational& b);
  friend Rational operator+(Rational&& a, const Rational& b) { return std::move(a += b); }
  friend Rational operator-(Rational&& a, const Rational& b) { return std::move(a -= b); }
  friend Rational operator*(Rational&& a, const Rational& b) { return std::move(a *= b); }
  friend Rational operator/(Rational&& a, const Rational& b) { return std::move(a /= b); }
  friend bool operator==(const Rational& a, const Rational& b);
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) { return a.compare(b); }
  friend bool operator==(const Rational& a, int b) { return a.compare(std::int64_t{b}) == 0; }
  friend std::strong_ordering operator<=>(const Rational& a, int b) { return a.compare(std::int64_t{b}); }

 private:
  friend struct detail::Native;

  alignas(detail::number_alignment) std::byte storage_[detail::rational_bytes];
};

[[nodiscard]] Rational abs(const Rational& x);
[[nodiscard]] Integer numerator(const Rational& x);    ///< has the sign of x
[[nodiscard]] Integer denominator(const Rational& x);  ///< positive
std::ostream& operator<<(std::ostream& out, const Rational& x);

/// The value of decimal digits, with a sign or without; none for any other text. O(n^1.6) for n digits.
[[nodiscard]] std::optional<Integer> parse_integer(std::string_view text);

/// The value of "7", "-7" or "-7/6": an integer, or its quotient by digits that are not all 0; none for any other text.
/// What `str` writes comes back. O(n^1.6) for n digits, and a greatest common divisor.
[[nodiscard]] std::optional<Rational> parse_quotient(std::string_view text);

/// A point with rational coordinates.
using RationalPoint = std::array<Rational, 3>;

/// The double nearest to q; ties go to the even mantissa, subnormals included.
/// Values that round beyond the largest finite double give an infinity. O(size of q).
[[nodiscard]] double to_nearest_double(const Rational& q);

/// The float nearest to q, by the same rules.
[[nodiscard]] float to_nearest_float(const Rational& q);

/// The exact value of a finite double.
[[nodiscard]] inline Rational to_rational(double x) { return Rational(x); }

}  // namespace strata
