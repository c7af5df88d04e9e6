#include "verify/json_number.h"

#include <fmt/format.h>

namespace verify {

double number(const JsonLocation& place) {
  if (!place.value().is_number()) place.fail_expected("a number");
  return place.value().get<double>();
}

std::int64_t integer(const JsonLocation& place, std::int64_t least, std::int64_t most) {
  if (!place.value().is_number_integer()) place.fail_expected("an integer");
  // What is not negative has an unsigned type, and may be beyond the signed one.
  const bool is_too_large = place.value().is_number_unsigned() && place.value().get<std::uint64_t>() > INT64_MAX;
  const auto value = is_too_large ? INT64_MAX : place.value().get<std::int64_t>();
  if (is_too_large || value < least || value > most)
    place.fail_expected(fmt::format("an integer from {} to {}", least, most));
  return value;
}

std::vector<double> numbers(const JsonLocation& place, std::size_t count) {
  std::vector<double> list;
  for (const JsonLocation& item : place.items()) list.push_back(number(item));
  if (list.size() != count) place.fail(fmt::format("expected {} numbers, found {}", count, list.size()));
  return list;
}

std::array<double, 3> point(const JsonLocation& place) {
  const std::vector<double> list = numbers(place, 3);
  return {list[0], list[1], list[2]};
}

}  // namespace verify
