#pragma once
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>

#include <stdexcept>

#include "strata/options.h"

namespace strata::oracle {

using Nef = CGAL::Nef_polyhedron_3<CGAL::Exact_predicates_exact_constructions_kernel>;

/// A Boolean by CGAL. Not regularized: may miss or have points of a nowhere dense set.
[[nodiscard]] inline Nef combine(Operation operation, const Nef& a, const Nef& b) {
  switch (operation) {
    case Operation::union_:
      return a + b;
    case Operation::intersection:
      return a * b;
    case Operation::difference:
      return a - b;
    case Operation::symmetric_difference:
      return a ^ b;
  }
  throw std::invalid_argument("unknown operation");
}

}  // namespace strata::oracle
