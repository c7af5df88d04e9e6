#include "numbers.h"

#include <nanobind/stl/string.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace strata::python {

namespace {

/// Hexadecimal digits of x >= 0, appended; `bits`, a multiple of 4, is at least its length. Halves are divided until
/// they are built-in integers: decimal digits would take longer, and Python limits their number.
void append_hex(std::string& text, const Integer& x, std::size_t bits) {
  constexpr std::size_t few = 60;
  if (bits <= few) {
    auto value = static_cast<std::uint64_t>(x.to_int64());
    const std::size_t begin = text.size();
    text.resize(begin + bits / 4);
    for (std::size_t i = text.size(); i-- > begin; value >>= 4) text[i] = "0123456789abcdef"[value & 15];
    return;
  }
  const std::size_t lower_bits = bits / 8 * 4;
  Integer upper = x;
  upper >>= lower_bits;
  append_hex(text, upper, bits - lower_bits);
  append_hex(text, x - (std::move(upper) << lower_bits), lower_bits);
}

/// The value of big-endian 32-bit words.
Integer from_words(const std::uint32_t* words, std::size_t count) {
  if (count == 0) return 0;
  if (count == 1) return Integer(words[0]);
  const std::size_t upper = count / 2;
  return (from_words(words, upper) << (32 * (count - upper))) + from_words(words + upper, count - upper);
}

Integer from_hex(std::string digits) {
  digits.insert(0, (8 - digits.size() % 8) % 8, '0');
  std::vector<std::uint32_t> words;
  for (std::size_t i = 0; i < digits.size(); i += 8)
    words.push_back(static_cast<std::uint32_t>(std::stoul(digits.substr(i, 8), nullptr, 16)));
  return from_words(words.data(), words.size());
}

[[noreturn]] void throw_type_error(const std::string& message) { throw nb::type_error(message.c_str()); }

}  // namespace

nb::object to_python(const Integer& x) {
  constexpr std::size_t most_bits_of_int64 = 63;
  const std::size_t bits = bit_length(x);
  if (bits <= most_bits_of_int64) return nb::steal(PyLong_FromLongLong(x.to_int64()));
  std::string text = x.sign() < 0 ? "-" : "";
  append_hex(text, abs(x), (bits + 3) / 4 * 4);
  return nb::steal(PyLong_FromString(text.c_str(), nullptr, 16));
}

nb::object to_python(const Rational& x) {
  return nb::module_::import_("fractions").attr("Fraction")(to_python(numerator(x)), to_python(denominator(x)));
}

nb::object to_python(const RationalPoint& p) {
  return nb::make_tuple(to_python(p[0]), to_python(p[1]), to_python(p[2]));
}

nb::object to_python(const std::array<Rational, 2>& p) { return nb::make_tuple(to_python(p[0]), to_python(p[1])); }

Integer to_integer(nb::handle integer) {
  const nb::object index = nb::steal(PyNumber_Index(integer.ptr()));
  if (!index.is_valid()) throw nb::python_error();
  int overflow = 0;
  const long long value = PyLong_AsLongLongAndOverflow(index.ptr(), &overflow);
  if (overflow == 0) return Integer(static_cast<std::int64_t>(value));
  const std::string text = nb::cast<std::string>(nb::object(index.attr("__format__")("x")));
  return text.front() == '-' ? -from_hex(text.substr(1)) : from_hex(text);
}

Rational to_rational(nb::handle number, const char* role) {
  if (PyFloat_Check(number.ptr())) {  // also numpy.float64
    const double value = PyFloat_AsDouble(number.ptr());
    if (!std::isfinite(value))
      throw nb::value_error((std::string(role) + ": expected a finite number, found " + std::to_string(value)).c_str());
    return Rational(value);
  }
  if (PyLong_Check(number.ptr())) return Rational(to_integer(number));
  const std::string expected = ": expected an int, a float or a Fraction, found ";
  if (nb::hasattr(number, "numerator") && nb::hasattr(number, "denominator")) {
    const nb::object above = nb::getattr(number, "numerator"), below = nb::getattr(number, "denominator");
    if (PyIndex_Check(above.ptr()) && PyIndex_Check(below.ptr())) return Rational(to_integer(above), to_integer(below));
  }
  if (PyIndex_Check(number.ptr())) return Rational(to_integer(number));
  if (nb::hasattr(number, "as_integer_ratio")) {  // Decimal, and other floats of NumPy
    try {
      const nb::object ratio = number.attr("as_integer_ratio")();
      return Rational(to_integer(ratio[0]), to_integer(ratio[1]));
    } catch (nb::python_error& error) {
      if (!error.matches(PyExc_ValueError) && !error.matches(PyExc_OverflowError)) throw;
      throw nb::value_error(
          (std::string(role) + ": expected a finite number, found " + nb::cast<std::string>(nb::repr(number))).c_str());
    }
  }
  throw_type_error(role + expected + nb::cast<std::string>(nb::repr(number)));
}

namespace {

/// The three members of a sequence.
std::array<nb::object, 3> members(nb::handle sequence, const char* role) {
  std::array<nb::object, 3> entries;
  std::size_t count = 0;
  if (PyIter_Check(sequence.ptr()) || nb::hasattr(sequence, "__len__"))
    for (const nb::handle entry : sequence) {
      if (count < entries.size()) entries[count] = nb::borrow(entry);
      if (++count > entries.size()) break;
    }
  if (count != entries.size())
    throw_type_error(std::string(role) + ": expected three numbers, found " +
                     nb::cast<std::string>(nb::repr(sequence)));
  return entries;
}

}  // namespace

RationalPoint Point::value(const char* role) const {
  const auto entries = members(object, role);
  return {to_rational(entries[0], role), to_rational(entries[1], role), to_rational(entries[2], role)};
}

double Number::as_double(const char* role) const {
  const Rational exact = value(role);
  const double nearest = to_nearest_double(exact);
  if (!std::isfinite(nearest) || Rational(nearest) != exact)
    throw nb::value_error((std::string(role) + ": expected a number that is a double, found " + exact.str()).c_str());
  return nearest;
}

std::array<double, 3> Point::doubles(const char* role) const {
  const auto entries = members(object, role);
  return {Number{entries[0]}.as_double(role), Number{entries[1]}.as_double(role), Number{entries[2]}.as_double(role)};
}

}  // namespace strata::python
