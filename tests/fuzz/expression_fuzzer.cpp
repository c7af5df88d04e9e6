// Expressions: text -> expression -> text says the same, and is a fixed point.
#include <optional>
#include <string>

#include "fuzz.h"
#include "truth.h"

namespace strata::fuzz {
namespace {

Expression parse(std::string_view text) {
  const Solid nothing;
  return parse_expression(text, [&nothing](const std::string&) { return nothing; });
}

std::optional<Expression> parse_or_refuse(std::string_view text) {
  try {
    return parse(text);
  } catch (const ParseError& error) {
    require(error.position() <= text.size(), "errors are in the text");
    return std::nullopt;
  }
}

void check(std::string_view text) {
  const std::optional<Expression> expression = parse_or_refuse(text);
  if (!expression) return;
  require(expression->size() > 0 && expression->size() <= text.size(), "solids have names in the text");
  const std::string written = expression->text();
  require(truth_of(written) == truth_of(text), "a text and what is written for it mean the same");
  require(parse(written).text() == written, "what was written is written again");
}

}  // namespace
}  // namespace strata::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return strata::fuzz::run(data, size, strata::fuzz::check);
}
