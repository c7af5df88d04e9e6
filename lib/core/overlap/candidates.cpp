#include "core/overlap/candidates.h"

#include <utility>

#include "core/cells/validate.h"
#include "core/exact/invariants.h"
#include "core/kernel/validate.h"
#include "core/overlap/coincidences.h"

namespace strata {

// Which vertices are compared depends on the cells; the cells do not depend on the numbers of vertices.
Candidates::Candidates(std::unique_ptr<InputComplex> input, const Monitor& monitor)
    : input_(std::move(input)), cells_(*input_, {.self = input_->may_self_intersect(), .monitor = monitor}) {
  input_->identify(find_coincidences(*input_, cells_, monitor));
  ensure("find_candidates", [&] { return validate(*input_); });
  ensure("find_candidates", [&] { return validate(*input_, cells_); });
}

Candidates find_candidates(InputComplex input, const Monitor& monitor) {
  return {std::make_unique<InputComplex>(std::move(input)), monitor};
}

}  // namespace strata
