#include "plane_option.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "common/usage_error.h"
#include "core/system/decimal.h"

namespace {

std::optional<strata::Rational> number(std::string_view text) {
  if (text.find('/') != std::string_view::npos) {
    try {
      return strata::Rational(text);
    } catch (const std::invalid_argument&) {
    } catch (const std::overflow_error&) {
    }
    return std::nullopt;
  }
  double x = 0;
  const auto [end, error] = strata::system::from_chars(text.data(), text.data() + text.size(), x);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(x)) return std::nullopt;
  return strata::Rational(x);
}

}  // namespace

strata::Plane parse_plane(const std::string& text) {
  const auto refuse = [&](const char* why) { throw UsageError(fmt::format("--plane {}: {}", text, why)); };
  std::array<strata::Rational, 4> values;
  std::string_view rest = text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t comma = rest.find(',');
    if ((comma == std::string_view::npos) != (i + 1 == values.size())) refuse("expected a,b,c,d");
    const auto value = number(rest.substr(0, comma));
    if (!value) refuse("expected numbers or fractions");
    values[i] = *value;
    if (comma != std::string_view::npos) rest.remove_prefix(comma + 1);
  }
  if (values[0] == 0 && values[1] == 0 && values[2] == 0) refuse("a plane needs a normal other than 0,0,0");
  return {{values[0], values[1], values[2]}, values[3]};
}
