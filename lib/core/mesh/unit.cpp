#include "strata/unit.h"

#include <array>

namespace strata {
namespace {

struct Known {
  Unit unit;
  std::string_view name, short_name;
  std::uint32_t micrometers;
};

constexpr std::array<Known, 6> known_units{Known{Unit::micron, "micron", "um", 1},
                                           Known{Unit::millimeter, "millimeter", "mm", 1000},
                                           Known{Unit::centimeter, "centimeter", "cm", 10'000},
                                           Known{Unit::inch, "inch", "in", 25'400},
                                           Known{Unit::foot, "foot", "ft", 304'800},
                                           Known{Unit::meter, "meter", "m", 1'000'000}};

}  // namespace

std::uint32_t micrometers(Unit unit) {
  for (const Known& k : known_units)
    if (k.unit == unit) return k.micrometers;
  return 0;
}

Rational ratio(Unit from, Unit to) { return Rational(micrometers(from)) / Rational(micrometers(to)); }

std::string_view name(Unit unit) {
  for (const Known& k : known_units)
    if (k.unit == unit) return k.name;
  return {};
}

std::optional<Unit> unit_named(std::string_view text) {
  for (const Known& k : known_units)
    if (text == k.name || text == k.short_name) return k.unit;
  return std::nullopt;
}

}  // namespace strata
