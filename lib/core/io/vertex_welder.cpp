#include "core/io/vertex_welder.h"

namespace strata::io {

template <class Scalar>
void VertexWelder<Scalar>::keep(const Point& p) {
  points_.push_back(p);
  if (points_.size() < table_.room()) return;
  table_.grow(2 * table_.room(), static_cast<std::uint32_t>(points_.size()),
              [&](std::uint32_t n) { return hash_of(points_[n]); });
}

template class VertexWelder<float>;
template class VertexWelder<double>;

}  // namespace strata::io
