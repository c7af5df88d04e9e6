// Convex hulls, convex pieces and Minkowski sums; polygons in the plane.
#include <array>
#include <utility>

#include "call.h"
#include "handle.h"
#include "strata/convex.h"
#include "strata/planar.h"

using namespace strata;
using namespace strata::web;

STRATA_WEB(hull) unsigned strata_hull(const double* coordinates, std::size_t vertices) {
  return guarded([&] {
    const Mesh points = mesh_of(coordinates, vertices, nullptr, 0);
    return keep(convex::solid_of(convex::convex_hull(points.vertices)));
  });
}

/// The answer has a solid for each piece, which carries what the whole does.
STRATA_WEB(decompose) unsigned strata_decompose(Handle handle) {
  return guarded([&] {
    const Solid& whole = web::solid_of(handle);
    const convex::Decomposition parts = convex::decompose(whole);
    if (!whole.attributes().empty()) {
      for (Solid& piece : convex::pieces_of(whole, parts, watched())) answer().ints.push_back(keep(std::move(piece)));
    } else {
      for (std::uint32_t piece = 0; piece < parts.pieces.size(); ++piece)
        answer().ints.push_back(keep(convex::solid_of(parts.polytope(piece))));
    }
    return 1U;
  });
}

STRATA_WEB(minkowski_sum) unsigned strata_minkowski_sum(Handle a, Handle b) {
  return guarded([&] { return keep(convex::minkowski_sum(web::solid_of(a), web::solid_of(b), watched())); });
}

/// The union, intersection, difference or symmetric difference of two texts of polygons, as a text of the same format.
STRATA_WEB(planar)
unsigned strata_planar(unsigned operation, unsigned fill, const char* word, std::size_t word_size, const char* a,
                       std::size_t a_size, const char* b, std::size_t b_size) {
  return guarded([&] {
    const std::optional<planar::PlanarFormat> format = planar::planar_format_named({word, word_size});
    if (!format) throw std::invalid_argument("unknown format '" + std::string(word, word_size) + "'");
    const auto rule = static_cast<planar::FillRule>(fill);
    const planar::Loops first = planar::read_planar(std::string_view(a, a_size), *format, "a").loops;
    const planar::Loops second = planar::read_planar(std::string_view(b, b_size), *format, "b").loops;
    const std::array<planar::Operand, 2> operands{planar::Operand(first, rule), planar::Operand(second, rule)};
    answer().bytes = planar::to_text(planar::combine(operands, all_operations.at(operation)), *format);
    return 1U;
  });
}
