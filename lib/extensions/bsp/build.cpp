#include "extensions/bsp/build.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "extensions/bsp/for_some.h"
#include "strata/errors.h"

namespace strata::bsp {
namespace {

constexpr std::size_t most_candidates = 8;   ///< facets whose hyperplanes are tried
constexpr std::size_t most_asked = 64;       ///< facets that are tested for their side
constexpr std::size_t fewest_for_axes = 12;  ///< facets for which axis-parallel hyperplanes are tried

/// The sides of facets, counted for some of them.
struct Count {
  double minus = 0, plus = 0, both = 0;

  void add(Lie lie) {
    minus += lie == Lie::minus ? 1 : 0;
    plus += lie == Lie::plus ? 1 : 0;
    both += lie == Lie::both ? 1 : 0;
  }
  /// Each tested facet represents this number of facets.
  [[nodiscard]] double cost(double each) const {
    const auto work = [](double m) { return m * std::log2(m + 1); };
    return work(each * (minus + both)) + work(each * (plus + both));
  }
};

template <int D>
class Builder {
 public:
  Builder(HyperplaneTable<D>& table, const Monitor& monitor) : table_(table), monitor_(monitor) {}

  Tree build(std::vector<Facet<D>> facets) {
    if (facets.empty()) return {};
    const Link root = part(std::move(facets));
    return {std::move(nodes_), root, splits_};
  }

 private:
  using Facets = std::vector<Facet<D>>;

  /// Facets on either side of a hyperplane, and the side of the region if some lie in it.
  struct Sides {
    Facets minus, plus;
    std::optional<bool> faces_plus;
  };

  Link part(Facets facets) {
    monitor_.check();
    std::uint32_t cut = best_cut(facets);
    Sides sides = divide(facets, cut);
    if (!sides.faces_plus && (sides.minus.empty() || sides.plus.empty())) {  // this cut is redundant
      facets = std::move(sides.minus.empty() ? sides.plus : sides.minus);
      cut = facets.front().piece.hyperplane;
      sides = divide(facets, cut);
    }
    Facets().swap(facets);
    const auto child = [&](Facets& of_side, bool is_plus) {
      if (!of_side.empty()) return part(std::move(of_side));
      return leaf(*sides.faces_plus != is_plus);
    };
    const Link minus = child(sides.minus, false), plus = child(sides.plus, true);
    return divided(nodes_, cut, minus, plus);
  }

  /// Consumes the facets.
  Sides divide(Facets& facets, std::uint32_t cut) {
    Sides sides;
    for (Facet<D>& f : facets) {
      Split<D> pieces = split(table_, f.piece, cut);
      switch (pieces.lie) {
        case Lie::on:
          sides.faces_plus = f.faces_plus;
          break;
        case Lie::minus:
          sides.minus.push_back(std::move(f));
          break;
        case Lie::plus:
          sides.plus.push_back(std::move(f));
          break;
        case Lie::both:
          ++splits_;
          sides.minus.push_back({std::move(pieces.minus), f.faces_plus});
          sides.plus.push_back({std::move(pieces.plus), f.faces_plus});
          break;
      }
    }
    return sides;
  }

  std::uint32_t best_cut(const Facets& facets) {
    std::uint32_t best = facets.front().piece.hyperplane;
    if (facets.size() == 1) return best;
    const double each = static_cast<double>(facets.size()) / static_cast<double>(std::min(facets.size(), most_asked));
    double lowest = HUGE_VAL;
    for_some(facets.size(), most_candidates, [&](std::size_t k) {
      const std::uint32_t candidate = facets[k].piece.hyperplane;
      Count count;
      for_some(facets.size(), most_asked,
               [&](std::size_t i) { count.add(estimated_lie(table_, facets[i].piece, candidate)); });
      if (const double cost = count.cost(each); cost < lowest) {
        lowest = cost;
        best = candidate;
      }
    });
    if (facets.size() < fewest_for_axes) return best;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const double middle = median(facets, axis);
      const double cost = count_along(facets, axis, middle).cost(each);
      if (cost >= lowest || !std::isfinite(middle)) continue;
      lowest = cost;
      best = table_.add(axis_hyperplane<D>(axis, to_rational(middle)));
    }
    return best;
  }

  static double median(const Facets& facets, std::size_t axis) {
    std::vector<double> values;
    for_some(facets.size(), most_asked, [&](std::size_t i) {
      for (const HyperplaneMeet<D>& c : facets[i].piece.corners)
        if (!c.is_far) values.push_back(c.at[axis].value);
    });
    if (values.empty()) return HUGE_VAL;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }

  /// An estimate from rounded doubles.
  static Count count_along(const Facets& facets, std::size_t axis, double value) {
    Count count;
    for_some(facets.size(), most_asked, [&](std::size_t i) {
      bool minus = false, plus = false;
      for (const HyperplaneMeet<D>& c : facets[i].piece.corners) {
        const double x = c.at[axis].value;
        minus |= c.is_far ? x < 0 : x < value;
        plus |= c.is_far ? x > 0 : x > value;
      }
      count.add(lie_of(minus, plus));
    });
    return count;
  }

  HyperplaneTable<D>& table_;
  const Monitor& monitor_;
  std::vector<Node> nodes_;
  std::size_t splits_ = 0;
};

}  // namespace

template <int D>
Tree built(HyperplaneTable<D>& table, std::vector<Facet<D>> facets, const Monitor& monitor) {
  return Builder<D>(table, monitor).build(std::move(facets));
}

template Tree built(HyperplaneTable<1>&, std::vector<Facet<1>>, const Monitor&);
template Tree built(HyperplaneTable<2>&, std::vector<Facet<2>>, const Monitor&);
template Tree built(HyperplaneTable<3>&, std::vector<Facet<3>>, const Monitor&);

}  // namespace strata::bsp
