#include "json_matrix.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

using strata::Integer;
using strata::Rational;

namespace {

constexpr const char* coefficient = "a number or a string with an integer or a quotient of integers, like \"-1/3\"";

Rational read_quotient(const JsonLocation& place) {
  const std::string text = place.text();
  if (const auto value = strata::parse_quotient(text)) return *value;
  const std::size_t slash = text.find('/');
  if (slash != text.npos && strata::parse_integer(text.substr(slash + 1)) == Integer(0))
    place.fail("the denominator is 0");
  place.fail_expected(coefficient);
}

Rational read_coefficient(const JsonLocation& place) {
  const Json& value = place.value();
  if (value.is_number_unsigned()) return Rational(Integer(value.get<std::uint64_t>()));
  if (value.is_number_integer()) return Rational(Integer(value.get<std::int64_t>()));
  if (value.is_number_float()) return strata::to_rational(value.get<double>());
  if (!value.is_string()) place.fail_expected(coefficient);
  return read_quotient(place);
}

strata::Transform::Row read_row(const JsonLocation& place) {
  const std::vector<JsonLocation> items = place.items();
  if (items.size() != 4)
    place.fail("a row of a matrix has 4 coefficients, this one has " + std::to_string(items.size()));
  strata::Transform::Row row;
  std::transform(items.begin(), items.end(), row.begin(), read_coefficient);
  return row;
}

}  // namespace

strata::Transform read_matrix(const JsonLocation& place) {
  const std::vector<JsonLocation> items = place.items();
  if (items.size() != 4) place.fail("a matrix has 4 rows, this one has " + std::to_string(items.size()));
  std::array<strata::Transform::Row, 3> rows;
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = read_row(items[i]);
  const strata::Transform::Row last = read_row(items[3]);
  if (last[0] != 0 || last[1] != 0 || last[2] != 0 || last[3] == 0)
    items[3].fail("the last row of a transform is 0 0 0 1 or a multiple of it");
  for (strata::Transform::Row& row : rows)
    for (Rational& x : row) x /= last[3];
  try {
    return strata::Transform(std::move(rows));
  } catch (const std::invalid_argument& error) {
    place.fail(error.what());
  }
}
