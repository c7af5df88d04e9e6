#pragma once
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <type_traits>

#include "core/exact/big_integer.h"
#include "strata/rational.h"

namespace strata::oracle {

using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;

// CGAL chooses its exact rationals by what is installed: GMP's own class or Boost's.
using CgalRational = std::decay_t<decltype(CGAL::exact(ExactKernel::FT()))>;

inline ExactKernel::FT to_cgal(const Rational& q) { return {CgalRational(native(q).backend().data())}; }

inline ExactKernel::Point_3 to_cgal(const RationalPoint& p) { return {to_cgal(p[0]), to_cgal(p[1]), to_cgal(p[2])}; }

template <typename Number>
Rational to_strata(const Number& x) {
  Rational r;
  if constexpr (requires { x.get_mpq_t(); }) {
    mpq_set(native(r).backend().data(), x.get_mpq_t());
  } else {
    mpq_set(native(r).backend().data(), x.backend().data());
  }
  return r;
}

inline Rational from_cgal(const ExactKernel::FT& x) { return to_strata(CGAL::exact(x)); }

inline RationalPoint from_cgal(const ExactKernel::Point_3& p) {
  return {from_cgal(p.x()), from_cgal(p.y()), from_cgal(p.z())};
}

}  // namespace strata::oracle
