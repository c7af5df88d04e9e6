#pragma once
#include <CGAL/assertions_behaviour.h>

#include <exception>

#include "oracle/cgal_numbers.h"
#include "oracle/combine_nef.h"
#include "oracle/nef.h"

// What is read from CGAL's Nef polyhedra, and how CGAL is asked. Needs CGAL.
namespace strata::oracle {

inline std::vector<RationalPoint> loop_points(Nef::SHalfedge_const_handle start) {
  std::vector<RationalPoint> loop;
  Nef::SHalfedge_around_facet_const_circulator side(start);
  const Nef::SHalfedge_around_facet_const_circulator end(side);
  do {
    loop.push_back(from_cgal(side->source()->center_vertex()->point()));
  } while (++side != end);
  return loop;
}

/// The loops of a facet, without its isolated vertices.
inline ExactFacet facet_of(const Nef::Halffacet_const_handle& f) {
  ExactFacet facet;
  for (auto cycle = f->facet_cycles_begin(); cycle != f->facet_cycles_end(); ++cycle)
    if (cycle.is_shalfedge()) facet.push_back(loop_points(Nef::SHalfedge_const_handle(cycle)));
  return facet;
}

/// Runs `work` with every complaint of CGAL turned into OracleFailed.
template <typename Work>
auto guarded(Work work) {
  const auto errors = CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
  const auto error_handler = CGAL::set_error_handler([](auto...) {});
  const auto warning_handler = CGAL::set_warning_handler([](auto...) {});
  const auto restore = [&] {
    CGAL::set_error_behaviour(errors);
    CGAL::set_error_handler(error_handler);
    CGAL::set_warning_handler(warning_handler);
  };
  try {
    auto result = work();
    restore();
    return result;
  } catch (const OracleFailed&) {
    restore();
    throw;
  } catch (const std::exception& e) {
    restore();
    throw OracleFailed(e.what());
  }
}

}  // namespace strata::oracle
