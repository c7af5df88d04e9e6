#pragma once
#include <algorithm>
#include <string>
#include <vector>

namespace strata::test {

/// True when one of the violations contains this text.
inline bool reports(const std::vector<std::string>& violations, const std::string& text) {
  return std::any_of(violations.begin(), violations.end(),
                     [&](const std::string& v) { return v.find(text) != std::string::npos; });
}

}  // namespace strata::test
