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
    case Operation::unite:
      return a + b;
    case Operation::intersect:
      return a * b;
    case Operation::subtract:
      return a - b;
    case Operation::exclude:
      return a ^ b;
  }
  throw std::invalid_argument("unknown operation");
}

}  // namespace strata::oracle
