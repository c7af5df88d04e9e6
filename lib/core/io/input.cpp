#include "core/io/input.h"

#include <algorithm>

namespace strata::io {

std::uint64_t Input::line_of(std::size_t offset) const {
  std::uint64_t line = 1;
  for (std::size_t i = 0; i < std::min(offset, data.size()); ++i)
    line += data[i] == '\n' || (data[i] == '\r' && (i + 1 == data.size() || data[i + 1] != '\n'));
  return line;
}

IoError Input::error(const Malformed& malformed) const {
  IoError::Place place;
  if (malformed.unit == Malformed::Unit::line) place.line = line_of(malformed.offset);
  if (malformed.unit == Malformed::Unit::byte) place.byte = malformed.offset;
  return {name, place, malformed.reason};
}

std::string quoted(std::string_view word) {
  constexpr std::size_t longest = 32;
  return "'" + std::string(word.substr(0, longest)) + "'";
}

}  // namespace strata::io
