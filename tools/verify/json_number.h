#pragma once
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "common/json_location.h"

/// Numbers of a JSON document; whatever is no such number is a strata::IoError that names the place.
namespace verify {

/// A number, as the nearest double.
[[nodiscard]] double number(const JsonLocation& place);
[[nodiscard]] std::int64_t integer(const JsonLocation& place, std::int64_t least, std::int64_t most);
/// An array of three numbers.
[[nodiscard]] std::array<double, 3> point(const JsonLocation& place);
/// An array of numbers of this length.
[[nodiscard]] std::vector<double> numbers(const JsonLocation& place, std::size_t count);

}  // namespace verify
