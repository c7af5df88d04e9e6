#include "core/overlap/candidates.h"

#include <utility>

#include "core/overlap/coincidences.h"

namespace strata {

// Which vertices are compared depends on the cells; the cells do not depend on the numbers of vertices.
Candidates::Candidates(std::unique_ptr<InputComplex> input, const Monitor& monitor)
    : input_(std::move(input)), cells_(*input_, {.self = input_->may_self_intersect(), .monitor = monitor}) {
  input_->identify(find_coincidences(*input_, cells_, monitor));
}

Candidates find_candidates(InputComplex input, const Monitor& monitor) {
  return {std::make_unique<InputComplex>(std::move(input)), monitor};
}

}  // namespace strata
