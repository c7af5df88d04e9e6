#include "verify/fuzz/step_text.h"

#include <fmt/format.h>

#include <utility>

namespace fuzz {

std::string step_text(const verify::Steps& steps, std::size_t value, Order order) {
  if (value < steps.names.size()) return steps.names[value];
  const verify::Step& step = steps.steps[value - steps.names.size()];
  std::string first = step_text(steps, step.first, order), second = step_text(steps, step.second, order);
  if (order == Order::swapped && step.operation != strata::Operation::difference) std::swap(first, second);
  return fmt::format("({} {} {})", first, sign(step.operation), second);
}

}  // namespace fuzz
