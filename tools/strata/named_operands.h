#pragma once
#include <string>
#include <vector>

/// An operand by its name in an expression.
struct NamedOperand {
  std::string name, path;
};

/// NAME=FILE, or FILE, which is called a, b, c, ... in the order of all. Throws UsageError: more than 26 without a
/// name, a name that is given twice.
[[nodiscard]] std::vector<NamedOperand> named_operands(const std::vector<std::string>& given);
