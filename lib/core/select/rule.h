#pragma once
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "core/cells/windings.h"
#include "strata/formula.h"
#include "strata/options.h"

namespace strata {

/// Decides from the winding numbers at a point whether it is in the result. A point is in an operand where its winding
/// number is positive; of a single operand, other rules are possible.
class Rule {
 public:
  Rule(Operation operation, std::uint32_t operands) : operation_(operation), operands_(operands) {}
  /// Requires that the formula is closed.
  explicit Rule(Formula formula) : operands_(formula.operands()), formula_(std::move(formula)) {}
  /// Every piece is kept, whatever the winding numbers are: of coincident pieces one, and none where they have both
  /// orientations.
  [[nodiscard]] static Rule every_sheet() {
    Rule rule(Operation::symmetric_difference, 1);
    rule.looks_around_ = false;
    return rule;
  }
  /// Every piece is kept as it is, also where coincident ones have both orientations, with the list of those
  /// (`covers`).
  [[nodiscard]] static Rule every_wall() {
    Rule rule = every_sheet();
    rule.keeps_covers_ = true;
    return rule;
  }

  /// The same rule. Of coincident pieces, that of the first operand that keeps it represents all (`FaceSplitter`), not
  /// that of the lowest face.
  [[nodiscard]] Rule by_first_keeper() const {
    Rule rule = *this;
    rule.asks_for_keepers_ = operands_ > 1 && looks_around_;
    return rule;
  }

  [[nodiscard]] std::uint32_t operands() const { return operands_; }
  [[nodiscard]] bool asks_for_keepers() const { return asks_for_keepers_; }
  /// False when winding numbers do not matter.
  [[nodiscard]] bool looks_around() const { return looks_around_; }
  /// True when pieces are not merged, and the faces that cover them are listed.
  [[nodiscard]] bool keeps_covers() const { return keeps_covers_; }

  /// One operand, and another rule than that its winding number is positive.
  [[nodiscard]] static Rule of_one(Inside inside) {
    Rule rule(Operation::union_, 1);
    rule.inside_ = inside;
    return rule;
  }

  /// True when this winding number of one operand alone decides the rule, whatever the others are.
  [[nodiscard]] bool settles(std::uint32_t operand, std::int32_t winding) const {
    if (inside_ != Inside::winding) return false;
    if (formula_) return formula_->settles(operand, winding > 0);
    switch (operation_) {
      case Operation::union_:
        return winding > 0;
      case Operation::intersection:
        return winding <= 0;
      case Operation::difference:
        return (winding > 0) != (operand == 0);
      case Operation::symmetric_difference:
        return false;
    }
    return false;
  }

  /// The value of the rule where this winding number of one operand alone decides it.
  [[nodiscard]] std::optional<bool> settled(std::uint32_t operand, std::int32_t winding) const {
    if (!settles(operand, winding)) return std::nullopt;
    if (!formula_) return operation_ == Operation::union_;
    Windings alone;
    alone.add(operand, winding);
    return formula_->holds(alone);
  }

  /// Lists of operands whose union alone matters to the rule: each list may be replaced by its union.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> unions() const {
    if (formula_) return formula_->unions();
    switch (operation_) {
      case Operation::union_:
        return operands_from(0);
      case Operation::difference:
        return operands_from(1);
      case Operation::intersection:
      case Operation::symmetric_difference:
        return {};
    }
    return {};
  }

  [[nodiscard]] bool inside(const Windings& windings) const {
    if (inside_ == Inside::even_odd) return windings[0] % 2 != 0;
    if (inside_ == Inside::outer) return windings[0] != 0;
    if (formula_) return formula_->holds(windings);
    std::uint32_t in = 0;
    bool in_first = false;
    for (const auto& [operand, w] : windings) {
      if (w <= 0) continue;
      ++in;
      in_first = in_first || operand == 0;
    }
    switch (operation_) {
      case Operation::union_:
        return in > 0;
      case Operation::intersection:
        return in == operands_;
      case Operation::difference:
        return in_first && in == 1;
      case Operation::symmetric_difference:
        return in % 2 == 1;
    }
    return false;
  }

 private:
  /// The list of all operands from this one on, if there are two or more.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> operands_from(std::uint32_t first) const {
    if (operands_ < first + 2) return {};
    std::vector<std::uint32_t> list(operands_ - first);
    std::iota(list.begin(), list.end(), first);
    return {list};
  }

  Operation operation_{};
  std::uint32_t operands_;
  std::optional<Formula> formula_;  ///< instead of the operation
  bool looks_around_ = true;
  bool keeps_covers_ = false;
  bool asks_for_keepers_ = false;
  Inside inside_ = Inside::winding;  ///< `outer`: where the winding number is not 0
};

/// The decision about a piece of surface.
enum class Verdict : std::uint8_t {
  drop,
  keep,          ///< the result is behind it, as the operand was
  keep_reversed  ///< the result is in front of it
};

[[nodiscard]] inline Verdict verdict(bool inside_above, bool inside_below) {
  if (inside_above == inside_below) return Verdict::drop;
  return inside_below ? Verdict::keep : Verdict::keep_reversed;
}

}  // namespace strata
