#include "extensions/bsp/cells.h"

#include <algorithm>

namespace strata::bsp {
namespace {

template <int D>
class CellVisitor {
 public:
  using Visit = std::function<void(const std::vector<Facet<D>>& facets)>;

  CellVisitor(const Partition<D>& region, const Visit& visit) : region_(region), visit_(visit) {}

  void go(Link link) {
    if (link == leaf_in) visit_(facets());
    if (is_leaf(link)) return;
    const Node& node = region_.tree().nodes[link];
    path_.push_back({node.hyperplane, Sign::negative});
    go(node.minus);
    path_.back().side = Sign::positive;
    go(node.plus);
    path_.pop_back();
  }

 private:
  /// Half-spaces further up may have become superfluous.
  [[nodiscard]] std::vector<Facet<D>> facets() const {
    std::vector<Facet<D>> facets;
    for (const HalfSpace& wall : path_) {
      Piece<D> piece = whole(region_.table(), wall.hyperplane);
      const bool is_wall = std::all_of(path_.rbegin(), path_.rend(), [&](const HalfSpace& h) {
        return h.hyperplane == wall.hyperplane || clip(region_.table(), piece, h);
      });
      if (is_wall) facets.push_back({std::move(piece), wall.side == Sign::negative});
    }
    return facets;
  }

  const Partition<D>& region_;
  const Visit& visit_;
  Path path_;
};

}  // namespace

template <int D>
void for_each_cell(const Partition<D>& region, const std::function<void(const std::vector<Facet<D>>& facets)>& visit) {
  CellVisitor<D>(region, visit).go(region.tree().root);
}

#define STRATA_INSTANTIATE(D) \
  template void for_each_cell(const Partition<D>&, const std::function<void(const std::vector<Facet<D>>&)>&);
STRATA_INSTANTIATE(1)
STRATA_INSTANTIATE(2)
STRATA_INSTANTIATE(3)
#undef STRATA_INSTANTIATE

}  // namespace strata::bsp
