#include <array>
#include <cmath>
#include <vector>

#include "core/exact/pairwise_sum.h"
#include "extensions/bsp/partition_data.h"

namespace strata::bsp {
namespace {

/// A facet of a hyperplane n . x + c = 0, projected along the axis k in which n is longest. It is |n| / |n_k| times as
/// large as its projection. With the origin it spans a pyramid of 1 / D times -c / |n_k| times the projection, positive
/// where the region is on the origin's side.
template <int D>
class View {
 public:
  View(const HyperplaneTable<D>& table, const Facet<D>& facet) : form_(table[facet.piece.hyperplane]) {
    axis_ = form_.longest_axis();
    const Rational height(-form_.exact()[D], abs(form_.exact()[axis_]));
    height_ = facet.faces_plus ? height : -height;
    for (const HyperplaneMeet<D>& c : facet.piece.corners) corners_.push_back(table.position(c));
  }

  [[nodiscard]] const Rational& height() const { return height_; }
  [[nodiscard]] double stretch() const {
    double squares = 0;
    for (std::size_t i = 0; i < D; ++i) squares += form_.bounded()[i].value * form_.bounded()[i].value;
    return std::sqrt(squares) / std::abs(form_.bounded()[axis_].value);
  }

  /// Size of the projection.
  [[nodiscard]] Rational size() const {
    Rational sum = 0;
    for_each_simplex([&](const Rational& part, const RationalVector<D>&) { sum += part; });
    return sum;
  }

  /// Calls visit(size of its projection, sum of its D corners) for the simplices of the facet.
  template <class Visit>
  void for_each_simplex(const Visit& visit) const {
    if constexpr (D == 1) {
      visit(Rational(1), corners_[0]);
    } else if constexpr (D == 2) {
      visit(abs(along(1, 1)), sum_of({0, 1}));
    } else {
      for (std::size_t i = 2; i < corners_.size(); ++i) {
        const Rational twice = along(i - 1, 1) * along(i, 2) - along(i - 1, 2) * along(i, 1);
        visit(Rational(abs(twice) / 2), sum_of({0, i - 1, i}));
      }
    }
  }

 private:
  /// The vector from the first corner to another, along an axis of the projection.
  [[nodiscard]] Rational along(std::size_t corner, std::size_t axis) const {
    const std::size_t i = (axis_ + axis) % D;
    return corners_[corner][i] - corners_[0][i];
  }
  [[nodiscard]] RationalVector<D> sum_of(const std::array<std::size_t, D>& corners) const {
    RationalVector<D> sum{};
    for (const std::size_t k : corners)
      for (std::size_t i = 0; i < D; ++i) sum[i] += corners_[k][i];
    return sum;
  }

  const Hyperplane<D>& form_;
  std::size_t axis_ = 0;
  Rational height_;
  std::vector<RationalVector<D>> corners_;
};

}  // namespace

template <int D>
std::optional<Rational> size(const Partition<D>& region) {
  if (!region.is_bounded()) return std::nullopt;
  PairwiseSum sum;
  for (const Facet<D>& f : facets_of(region)) {
    const View<D> view(table_of(region), f);
    sum.add(view.height() * view.size());
  }
  return sum.value() / D;
}

template <int D>
std::optional<RationalVector<D>> barycentre(const Partition<D>& region) {
  if (region.is_empty() || !region.is_bounded()) return std::nullopt;
  PairwiseSum total;
  std::array<PairwiseSum, D> sums;
  for (const Facet<D>& f : facets_of(region)) {
    const View<D> view(table_of(region), f);
    view.for_each_simplex([&](const Rational& part, const RationalVector<D>& corners) {
      const Rational weight = view.height() * part;
      total.add(weight);
      for (std::size_t i = 0; i < D; ++i) sums[i].add(weight * corners[i]);
    });
  }
  RationalVector<D> result;
  for (std::size_t i = 0; i < D; ++i)  // the origin is one more corner of each simplex
    result[i] = sums[i].value() / (total.value() * (D + 1));
  return result;
}

template <int D>
double boundary_size(const Partition<D>& region) {
  double sum = 0;
  for (const Facet<D>& f : facets_of(region)) {
    if (!f.piece.is_bounded()) return HUGE_VAL;
    const View<D> view(table_of(region), f);
    sum += view.stretch() * to_nearest_double(view.size());
  }
  return sum;
}

#define STRATA_INSTANTIATE(D)                                                   \
  template std::optional<Rational> size(const Partition<D>&);                   \
  template std::optional<RationalVector<D>> barycentre<D>(const Partition<D>&); \
  template double boundary_size(const Partition<D>&);
STRATA_INSTANTIATE(1)
STRATA_INSTANTIATE(2)
STRATA_INSTANTIATE(3)
#undef STRATA_INSTANTIATE

}  // namespace strata::bsp
