#include "core/io/finite_values.h"

#include <cmath>
#include <concepts>
#include <variant>

#include "core/io/holds_for_all.h"

namespace strata::io {
namespace {

/// True when all values are finite as numbers of the type Narrow, if they are floating-point at all.
template <class Narrow>
bool are_finite(const ChannelValues& values) {
  return std::visit(
      []<class T>(const std::vector<T>& numbers) {
        if constexpr (std::floating_point<T>)
          return holds_for_all(numbers.size(),
                               [&](std::size_t i) { return std::isfinite(static_cast<Narrow>(numbers[i])); });
        else
          return true;
      },
      values);
}

}  // namespace

bool has_finite_floats(const Channel& channel) { return are_finite<float>(channel.values); }
bool has_finite_values(const Channel& channel) { return are_finite<double>(channel.values); }

void note_not_finite(std::vector<std::string>& notes, std::span<const Channel* const> channels, const char* format) {
  if (channels.empty()) return;
  std::string names;
  for (const Channel* const c : channels) names += (names.empty() ? "" : ", ") + c->name;
  notes.push_back((channels.size() == 1 ? "channel " : "channels ") + names + " left out: there are numbers that " +
                  format + " cannot keep, infinite, too large or not a number");
}

}  // namespace strata::io
