#include <algorithm>

#include "extensions/bsp/partition_data.h"

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
    const Node& node = tree_of(region_).nodes[link];
    path_.push_back({node.hyperplane, Sign::negative});
    go(node.minus);
    path_.back().side = Sign::positive;
    go(node.plus);
    path_.pop_back();
  }

 private:
  /// Half-spaces further up may have become redundant.
  [[nodiscard]] std::vector<Facet<D>> facets() const {
    std::vector<Facet<D>> facets;
    for (const HalfSpace& wall : path_) {
      Piece<D> piece = whole(table_of(region_), wall.hyperplane);
      const bool is_wall = std::all_of(path_.rbegin(), path_.rend(), [&](const HalfSpace& h) {
        return h.hyperplane == wall.hyperplane || clip(table_of(region_), piece, h);
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
void for_each_inside_leaf(const Partition<D>& region,
                          const std::function<void(const std::vector<Facet<D>>& facets)>& visit) {
  CellVisitor<D>(region, visit).go(tree_of(region).root);
}

template <int D>
void for_each_cell(const Partition<D>& region, FunctionRef<void(const std::vector<AffineForm<D>>& cell)> visit) {
  for_each_inside_leaf<D>(region, [&](const std::vector<Facet<D>>& facets) {
    std::vector<AffineForm<D>> cell;
    for (const Facet<D>& f : facets) cell.push_back(form_of(table_of(region)[f.piece.hyperplane], f.faces_plus));
    visit(cell);
  });
}

template <int D>
void for_each_bounded_cell(const Partition<D>& region,
                           FunctionRef<void(const std::vector<BoundaryFacet<D>>& facets)> visit) {
  for_each_inside_leaf<D>(region, [&](const std::vector<Facet<D>>& facets) {
    std::vector<BoundaryFacet<D>> cell;
    for (const Facet<D>& f : facets) cell.push_back(boundary_facet(table_of(region), f));
    visit(cell);
  });
}

#define STRATA_INSTANTIATE(D)                                                                                \
  template void for_each_inside_leaf<D>(const Partition<D>&,                                                 \
                                        const std::function<void(const std::vector<Facet<D>>&)>&);           \
  template void for_each_cell<D>(const Partition<D>&, FunctionRef<void(const std::vector<AffineForm<D>>&)>); \
  template void for_each_bounded_cell<D>(const Partition<D>&, FunctionRef<void(const std::vector<BoundaryFacet<D>>&)>);
STRATA_INSTANTIATE(1)
STRATA_INSTANTIATE(2)
STRATA_INSTANTIATE(3)
#undef STRATA_INSTANTIATE

}  // namespace strata::bsp
