#include "named_operands.h"

#include <fmt/format.h>

#include "settings.h"

std::vector<NamedOperand> named_operands(const std::vector<std::string>& given) {
  std::vector<NamedOperand> operands;
  for (const std::string& one : given) {
    const std::size_t equals = one.find('=');
    if (equals == 0 || equals + 1 == one.size())
      throw UsageError(fmt::format("expected FILE or NAME=FILE, found '{}'", one));
    if (equals != std::string::npos) {
      operands.push_back({one.substr(0, equals), one.substr(equals + 1)});
    } else {
      if (operands.size() >= 26) throw UsageError("more than 26 operands need names: NAME=FILE");
      operands.push_back({std::string(1, static_cast<char>('a' + operands.size())), one});
    }
  }
  for (std::size_t i = 0; i < operands.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (operands[i].name == operands[j].name) throw UsageError(fmt::format("'{}' is given twice", operands[i].name));
  return operands;
}
