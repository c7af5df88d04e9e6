#pragma once
#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "strata/formula.h"

namespace strata {

/// Boolean functions as reduced ordered decision diagrams (Bryant 1986). Equal functions have equal numbers, so the
/// variables on which a function depends can be read off. Beyond a size it gives up, because diagrams can be
/// exponentially large.
class DecisionDiagram {
 public:
  using Function = std::uint32_t;

  DecisionDiagram();
  Function variable(std::uint32_t number);
  Function negate(Function f) { return choose(f, never, always); }
  Function join(Formula::Join join, std::span<const Function> terms);

  /// True once functions are no longer right, because the limit was exceeded.
  [[nodiscard]] bool is_too_large() const { return nodes_.size() > most; }
  /// For each variable, whether a function depends on it.
  [[nodiscard]] std::vector<bool> support(Function f, std::size_t variables) const;

 private:
  static constexpr Function never = 0, always = 1;
  static constexpr std::size_t most = 1 << 16;
  struct Node {
    std::uint32_t variable = 0xffffffffu;  ///< of the two constants: after all others
    Function low = 0, high = 0;

    friend auto operator<=>(const Node&, const Node&) = default;
  };
  Function make(const Node& node);
  Function choose(Function condition, Function then, Function otherwise);

  std::vector<Node> nodes_;
  std::map<Node, Function> known_nodes_;
  std::map<std::array<Function, 3>, Function> known_choices_;
};

}  // namespace strata
