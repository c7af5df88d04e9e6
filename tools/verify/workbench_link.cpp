#include "verify/workbench_link.h"

#include <strata/io.h>

#include <string_view>

namespace verify {
namespace {

constexpr std::size_t most_characters = 30000;

/// As forms encode texts: letters and digits are themselves, a space is a plus.
std::string encoded(std::string_view text) {
  constexpr const char* digits = "0123456789ABCDEF";
  std::string out;
  for (const char c : text) {
    const bool is_plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    if (is_plain || c == '.' || c == '-' || c == '_') {
      out += c;
    } else if (c == ' ') {
      out += '+';
    } else {
      const auto byte = static_cast<unsigned char>(c);
      out += {'%', digits[byte >> 4], digits[byte & 15]};
    }
  }
  return out;
}

}  // namespace

std::string workbench_fragment(const Case& c) {
  std::string fragment = "expression=" + encoded(c.expression);
  if (c.input != strata::InputClass::solid) fragment += "&input=" + encoded(strata::name(c.input));
  for (const CaseOperand& operand : c.operands) {
    // Longer texts than what they may become are not even made.
    if (operand.mesh.mesh.triangles.size() > most_characters / 10) return {};
    const bool has_doubles = operand.mesh.exact.empty();
    const auto format = has_doubles ? strata::Format::off : strata::Format::xoff;
    fragment += "&" + encoded(operand.name) + "." + std::string(strata::name(format)) + "=" +
                encoded(strata::to_string(operand.mesh, format));
    if (fragment.size() > most_characters) return {};
  }
  return fragment;
}

}  // namespace verify
