#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/select/rule.h"
#include "strata/combine.h"

namespace strata {

/// Unites some operands of unions first: those with coincident facets, and mutually overlapping ones. The parts of them
/// that are not in the result are then not intersected with the other operands. This affects the speed, not the point
/// set of the result.
class EarlyUnions {
 public:
  using Evaluate = std::function<BooleanResult(const Rule&, std::span<const Operand>, const Options&)>;

  /// Unites operands that `rule` unites. The given operands must outlive this. If any has attributes, only operands
  /// that follow one another are united, so that the first of those with coincident faces remains the first.
  EarlyUnions(const Rule& rule, std::span<const Operand> given, const Options& options, const Evaluate& evaluate);

  /// As many as were given: each union replaces its first member, and the other members are empty.
  [[nodiscard]] std::span<const Operand> operands() const { return operands_; }
  [[nodiscard]] bool is_replaced(std::size_t operand) const {
    return operands_[operand].mesh.triangles.data() != given_[operand].mesh.triangles.data();
  }
  /// Maps the sources of a result of these operands to the given operands, and adds the notes of the unions.
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
  std::vector<std::size_t> group_of_;  ///< per operand: the group whose union replaces it
};

}  // namespace strata
