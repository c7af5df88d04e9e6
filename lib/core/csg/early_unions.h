#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/select/rule.h"
#include "strata/combine.h"

namespace strata {

/// Some operands of unions are united first: where they have walls in common or crowd one another, what the result does
/// not have need not be met by anything else. Speed alone depends on it, not the point set.
class EarlyUnions {
 public:
  using Evaluate = std::function<BooleanResult(const Rule&, std::span<const Operand>, const Options&)>;

  /// Unites what `rule` unites. The operands given must outlive this.
  EarlyUnions(const Rule& rule, std::span<const Operand> given, const Options& options, const Evaluate& evaluate);

  /// As many as were given: unions in the places of their first members, and nothing in those of the others.
  [[nodiscard]] std::span<const Operand> operands() const { return operands_; }
  /// Sources of a result of these operands become those of the operands given; notes of the unions are added.
  void restore(BooleanResult& result) const;

 private:
  static constexpr std::size_t none = ~std::size_t{0};

  void unite(const Options& options, const Evaluate& evaluate);
  [[nodiscard]] BooleanResult united(const std::vector<std::uint32_t>& group, const Options& options,
                                     const Evaluate& evaluate) const;

  std::span<const Operand> given_;
  std::vector<Operand> operands_;
  std::vector<std::vector<std::uint32_t>> groups_;
  std::vector<BooleanResult> unions_;  ///< per group
  std::vector<std::size_t> group_of_;  ///< per operand: whose union is in its place
};

}  // namespace strata
