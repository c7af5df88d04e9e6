#include "core/csg/broken_operands.h"

#include <utility>
#include <vector>

#include "strata/check.h"

namespace strata {

void refuse_broken_operands(std::span<const Operand> operands, const Options& options) {
  if (options.input != InputClass::solid) return;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    std::vector<Defect> defects = check(ExactMeshView(operands[i].mesh, operands[i].exact), options);
    std::erase_if(defects, [](const Defect& d) { return d.severity != Severity::error; });
    if (!defects.empty()) throw InputError(std::move(defects), i);
  }
}

}  // namespace strata
