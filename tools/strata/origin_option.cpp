#include "origin_option.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

#include "core/system/decimal.h"

namespace {

/// Three finite numbers with commas between them, or nothing.
std::optional<strata::Vertex> three_numbers(std::string_view text) {
  strata::Vertex x{};
  const char *at = text.data(), *const end = at + text.size();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [last, error] = strata::system::from_chars(at, end, x[axis]);
    const bool is_last = axis == 2;
    if (error != std::errc{} || !std::isfinite(x[axis]) || (last == end) != is_last) return {};
    if (!is_last && *last != ',') return {};
    at = is_last ? last : last + 1;
  }
  return x;
}

}  // namespace

std::optional<strata::Origin> parse_origin(const std::string& text) {
  constexpr std::string_view towards = "direction:";
  if (text == "auto") return {};
  const bool is_direction = text.rfind(towards, 0) == 0;
  const auto x = three_numbers(std::string_view(text).substr(is_direction ? towards.size() : 0));
  if (!x) throw UsageError(fmt::format("expected x,y,z, direction:x,y,z or auto for --origin, found '{}'", text));
  if (!is_direction) return strata::Origin::point(*x);
  if (*x == strata::Vertex{}) throw UsageError("the direction of --origin is zero");
  return strata::Origin::direction(*x);
}

Json to_json(const strata::Origin& origin) {
  return {{"kind", origin.is_point() ? "point" : "direction"}, {"at", origin.at}};
}
