#pragma once
#include <span>
#include <string>
#include <vector>

#include "strata/attributes.h"

namespace strata::io {

/// True when all values of a channel are finite numbers, and stay so as floats. Formats whose readers refuse other
/// numbers leave such channels out.
[[nodiscard]] bool has_finite_floats(const Channel& channel);
/// The same without the floats.
[[nodiscard]] bool has_finite_values(const Channel& channel);

/// Notes channels that are left out because of their values, if there are any; `format` names the format.
void note_not_finite(std::vector<std::string>& notes, std::span<const Channel* const> channels, const char* format);

}  // namespace strata::io
