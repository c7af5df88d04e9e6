#pragma once
/// Units of length of the coordinates in mesh files.
#include <cstdint>
#include <optional>
#include <string_view>

#include "strata/rational.h"

namespace strata {

/// A unit of length; `none` where nobody said one.
enum class Unit { none, micron, millimeter, centimeter, inch, foot, meter };

/// A unit in micrometres; all are whole numbers. Requires a unit.
[[nodiscard]] std::uint32_t micrometers(Unit unit);

/// How many `to` one `from` is: inches in millimetres are 127/5. Requires two units.
[[nodiscard]] Rational ratio(Unit from, Unit to);

/// "micron", "millimeter", "centimeter", "inch", "foot" or "meter", as 3MF has them; empty for none.
[[nodiscard]] std::string_view name(Unit unit);

/// The unit of such a name, or of a short one: "um", "mm", "cm", "in", "ft", "m". No value for other text.
[[nodiscard]] std::optional<Unit> unit_named(std::string_view text);

}  // namespace strata
