#include "verify/steps.h"

#include <map>
#include <stdexcept>

#include "core/csg/expression_grammar.h"

namespace verify {
namespace {

using strata::Operation;

/// A value while the text is read: it notes its steps instead of doing them.
struct Value {
  Steps* steps;
  std::size_t number;
  bool is_complement;

  [[nodiscard]] Value step(Operation operation, std::size_t first, std::size_t second, bool complement) const {
    steps->steps.push_back({operation, first, second});
    return {steps, steps->steps.size() - 1, complement};
  }
};

// Results of steps are numbered behind the names, whose count is known in the end only: until then they are marked.
constexpr std::size_t is_name = std::size_t{1} << 62;

Value operator~(const Value& a) { return {a.steps, a.number, !a.is_complement}; }

Value operator&(const Value& a, const Value& b) {
  if (a.is_complement && b.is_complement) return a.step(Operation::union_, a.number, b.number, true);
  if (b.is_complement) return a.step(Operation::difference, a.number, b.number, false);
  if (a.is_complement) return a.step(Operation::difference, b.number, a.number, false);
  return a.step(Operation::intersection, a.number, b.number, false);
}

Value operator|(const Value& a, const Value& b) { return ~(~a & ~b); }
Value operator-(const Value& a, const Value& b) { return a & ~b; }
Value operator^(const Value& a, const Value& b) {
  return a.step(Operation::symmetric_difference, a.number, b.number, a.is_complement != b.is_complement);
}

}  // namespace

Steps steps_of(std::string_view expression) {
  Steps steps;
  std::map<std::string, std::size_t> numbers;
  const auto leaf = [&steps, &numbers](const std::string& name) {
    const auto [at, is_new] = numbers.try_emplace(name, steps.names.size());
    if (is_new) steps.names.push_back(name);
    return Value{&steps, at->second | is_name, false};
  };
  const Value result = strata::ExpressionGrammar<Value, decltype(leaf)>(expression, leaf).parse();
  if (result.is_complement) throw std::invalid_argument("the expression is not bounded");
  const auto final_number = [&steps](std::size_t n) {
    return (n & is_name) != 0 ? n ^ is_name : n + steps.names.size();
  };
  for (Step& step : steps.steps) {
    step.first = final_number(step.first);
    step.second = final_number(step.second);
  }
  steps.result = final_number(result.number);
  return steps;
}

}  // namespace verify
