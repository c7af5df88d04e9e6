#include "core/io/vertex_welder.h"

namespace strata::io {

template <class Scalar>
void VertexWelder<Scalar>::grow() {
  slots_.assign(2 * slots_.size(), 0);
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    std::size_t at = hash_of(points_[i]) & mask;
    while (slots_[at] != 0) at = (at + 1) & mask;
    slots_[at] = static_cast<std::uint32_t>(i + 1);
  }
}

template class VertexWelder<float>;
template class VertexWelder<double>;

}  // namespace strata::io
