#pragma once
#include <cstddef>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "strata/errors.h"

namespace strata {

/// Invariants that do not hold, one sentence each. The functions `validate` of the modules make such lists.
class Violations {
 public:
  /// Appends a sentence made of these parts. Only the first ones are kept.
  template <class... Parts>
  void add(const Parts&... parts) {
    if (list_.size() >= most_listed) return;
    std::ostringstream text;
    text.precision(17);
    (text << ... << parts);
    list_.push_back(text.str());
  }
  [[nodiscard]] std::vector<std::string> list() && { return std::move(list_); }
  [[nodiscard]] bool empty() const { return list_.empty(); }

 private:
  static constexpr std::size_t most_listed = 16;
  std::vector<std::string> list_;
};

/// True in builds with STRATA_CHECKED.
#ifdef STRATA_CHECKED
inline constexpr bool is_checked_build = true;
#else
inline constexpr bool is_checked_build = false;
#endif

/// In checked builds: throws LogicError with the violations that `find` lists, if any. `stage`: whose invariants they
/// are.
template <class Find>
void ensure(std::string_view stage, const Find& find) {
  if constexpr (is_checked_build) {
    const std::vector<std::string> violations = find();
    if (violations.empty()) return;
    std::string text = "invariants do not hold after " + std::string(stage);
    for (const std::string& v : violations) text += "\n  " + v;
    throw LogicError(text);
  }
}

/// Visits 0 to count - 1 if these are at most `most`, else that many of them at about equal distances, the same each
/// time.
template <class Visit>
void for_sample(std::size_t count, std::size_t most, const Visit& visit) {
  if (count <= most) {
    for (std::size_t i = 0; i < count; ++i) visit(i);
  } else {
    const double step = static_cast<double>(count) / static_cast<double>(most);
    for (std::size_t i = 0; i < most; ++i) visit(static_cast<std::size_t>(static_cast<double>(i) * step));
  }
}

}  // namespace strata
