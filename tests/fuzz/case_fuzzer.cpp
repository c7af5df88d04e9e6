// case.json: generator lines, expressions as steps, what is known. Files of operands are not there.
#include <cmath>
#include <vector>

#include "fuzz.h"
#include "io_error_law.h"
#include "truth.h"
#include "verify/case.h"

namespace strata::fuzz {
namespace {

constexpr const char* folder = "/dev/null/case";

Truth apply(Operation operation, Truth a, Truth b) {
  switch (operation) {
    case Operation::union_:
      return a | b;
    case Operation::intersection:
      return a & b;
    case Operation::difference:
      return a - b;
    case Operation::symmetric_difference:
      return a ^ b;
  }
  return {};
}

void check_steps(const verify::Case& c) {
  std::vector<Truth> values;
  for (const std::string& name : c.steps.names) values.push_back(truth_of_name(name));
  for (const verify::Step& step : c.steps.steps) {
    require(step.first < values.size() && step.second < values.size(), "steps use earlier values");
    values.push_back(apply(step.operation, values[step.first], values[step.second]));
  }
  require(c.steps.result < values.size(), "the result is a value");
  require(values[c.steps.result] == truth_of(c.expression), "steps mean what the expression means");
}

void check(std::string_view text) {
  try {
    const verify::Case c = verify::parse_case(text, folder);
    require(c.operands.size() == c.steps.names.size(), "every operand is used, every name is an operand");
    for (const verify::CaseOperand& operand : c.operands)
      for (const Triangle& t : operand.mesh.mesh.triangles)
        for (const std::uint32_t v : t) require(v < operand.mesh.mesh.vertices.size(), "indices are in range");
    check_steps(c);
  } catch (const IoError& error) {
    check_error(error, std::string(folder) + "/case.json");
  }
}

}  // namespace
}  // namespace strata::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return strata::fuzz::run(data, size, [](std::string_view text) { strata::fuzz::check(text); });
}
