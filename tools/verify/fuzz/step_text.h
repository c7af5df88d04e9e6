#pragma once
#include <string>

#include "verify/steps.h"

namespace fuzz {

enum class Order { given, swapped };  ///< of the operands of |, & and ^

/// The expression of a value of the steps, in parentheses unless it is a name. Without complements.
[[nodiscard]] std::string step_text(const verify::Steps& steps, std::size_t value, Order order = Order::given);

}  // namespace fuzz
