#pragma once
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "strata/mesh.h"
#include "verify/engine.h"

namespace fuzz {

/// A check that does not hold.
class Broken : public std::runtime_error {
 public:
  Broken(std::string check, const std::string& what) : std::runtime_error(what), check_(std::move(check)) {}
  [[nodiscard]] const std::string& check() const { return check_; }

 private:
  std::string check_;
};

/// The question does not apply: operands that are no solids, rationals for an engine of doubles, an engine that says
/// that it has no result.
class NoQuestion : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Gives the solids of expressions; one and the same engine in all its answers.
class Evaluator {
 public:
  virtual ~Evaluator() = default;
  /// Results are exact: laws hold as equalities of point sets. Else they hold within the yardstick, for volumes.
  [[nodiscard]] virtual bool is_exact() const = 0;
  [[nodiscard]] virtual double unit_roundoff() const { return 0; }
  /// Throws Broken ("error", "crash", "hang", "closed") and NoQuestion.
  [[nodiscard]] virtual strata::ExactMesh value(const std::string& expression,
                                                const std::vector<verify::CaseOperand>& operands) const = 0;
};

/// This library, in this process, in one arrangement. Throws as Evaluator::value does.
[[nodiscard]] strata::ExactMesh value_by_library(const std::string& expression,
                                                 const std::vector<verify::CaseOperand>& operands, unsigned threads);

/// The same on one thread.
[[nodiscard]] std::unique_ptr<Evaluator> library_evaluator();

/// An engine in processes of its own. `limits` are for one expression.
[[nodiscard]] std::unique_ptr<Evaluator> engine_evaluator(const std::string& engine,
                                                          const verify::EngineFolders& folders,
                                                          const verify::Limits& limits);

}  // namespace fuzz
