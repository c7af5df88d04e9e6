#pragma once
/// Exact numbers between Python and the library: int and Integer, fractions.Fraction and Rational.
#include <nanobind/nanobind.h>
#include <strata/rational.h>

#include <array>
#include <new>

namespace strata::python {

namespace nb = nanobind;

[[nodiscard]] nb::object to_python(const Integer& x);        ///< an int
[[nodiscard]] nb::object to_python(const Rational& x);       ///< a Fraction
[[nodiscard]] nb::object to_python(const RationalPoint& p);  ///< a tuple of three Fractions
[[nodiscard]] nb::object to_python(const std::array<Rational, 2>& p);

/// Of an int, a float (also of NumPy), or anything with integer numerator and denominator or as_integer_ratio, as
/// Fraction and Decimal have. `role` names the argument in errors. Throws TypeError, and ValueError for what is not
/// finite.
[[nodiscard]] Rational to_rational(nb::handle number, const char* role);
[[nodiscard]] Integer to_integer(nb::handle integer);

/// A number of a signature: converted when the function is called.
struct Number {
  nb::object object;
  [[nodiscard]] Rational value(const char* role) const { return to_rational(object, role); }
  [[nodiscard]] double as_double(const char* role) const;  ///< throws ValueError where it is no double
};

/// A sequence of three numbers.
struct Point {
  nb::object object;
  [[nodiscard]] RationalPoint value(const char* role) const;
  [[nodiscard]] std::array<double, 3> doubles(
      const char* role) const;  ///< throws ValueError where it is not three doubles
};

}  // namespace strata::python

namespace nanobind::detail {

/// Any object, under a name that says in signatures what it must be.
#define STRATA_ARGUMENT(Type, text)                                                   \
  template <>                                                                         \
  struct type_caster<Type> {                                                          \
    NB_TYPE_CASTER(Type, const_name(text))                                            \
    bool from_python(handle source, std::uint32_t, cleanup_list*) noexcept {          \
      value.object = borrow<object>(source);                                          \
      return true;                                                                    \
    }                                                                                 \
    static handle from_cpp(const Type& argument, rv_policy, cleanup_list*) noexcept { \
      return argument.object.inc_ref();                                               \
    }                                                                                 \
  }

STRATA_ARGUMENT(strata::python::Number, "Number");
STRATA_ARGUMENT(strata::python::Point, "PointLike");

/// Results that are rationals.
template <>
struct type_caster<strata::Rational> {
  NB_TYPE_CASTER(strata::Rational, const_name("fractions.Fraction"))
  bool from_python(handle, std::uint32_t, cleanup_list*) noexcept { return false; }
  static handle from_cpp(const strata::Rational& x, rv_policy, cleanup_list*) noexcept {
    try {
      return strata::python::to_python(x).release();
    } catch (python_error& error) {  // a signal's handler, or no memory
      error.restore();
    } catch (const std::bad_alloc&) {
      PyErr_NoMemory();
    }
    return {};
  }
};

}  // namespace nanobind::detail
