#pragma once
#include "core/select/rule.h"
#include "core/select/sheet_windings.h"
#include "core/winding/winding_oracle.h"

namespace strata {

/// The inputs of the decision which pieces of faces bound the result: the operation, and the winding numbers on either
/// side. All that it refers to must outlive it.
struct Classifier {
  const Rule& rule;
  const WindingOracle& oracle;
  const SheetWindings* sheets = nullptr;  ///< of one mesh that crosses itself, if known
};

}  // namespace strata
