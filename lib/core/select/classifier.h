#pragma once
#include "core/select/rule.h"
#include "core/winding/winding_oracle.h"

namespace strata {

/// The inputs of the decision which pieces of faces bound the result: the operation, and the winding numbers on either
/// side. The rule and the oracle must outlive it.
struct Classifier {
  const Rule& rule;
  const WindingOracle& oracle;
};

}  // namespace strata
