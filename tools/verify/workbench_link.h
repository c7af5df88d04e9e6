#pragma once
#include <string>

#include "verify/case.h"

namespace verify {

/// What the workbench is asked by a link, behind the #: the case's operands and its expression. Empty where it would be
/// longer than 30,000 characters.
[[nodiscard]] std::string workbench_fragment(const Case& c);

}  // namespace verify
