#include "strata/complex.h"

namespace strata::complex {

SelectiveComplex evaluate(const Expression& expression, std::span<const SelectiveComplex> primitives,
                          const Monitor& monitor) {
  return combine(expression.formula(), primitives, monitor);
}

bool contains(const Expression::Products& products, std::span<const SelectiveComplex> primitives, const Vertex& p) {
  return is_in_products(products, [&](std::uint32_t k) { return contains(primitives[k], p); });
}

}  // namespace strata::complex
