#include "strata/layers/layer_decomposition.h"

#include "strata/layers/dominance.h"

namespace strata {

LayerDecomposition::LayerDecomposition(Scene scene, const Origin& origin, const Monitor& monitor) {
  const auto data = std::make_shared<Data>(SignedCovering(std::move(scene), origin, true));
  SignedCovering& covering = data->covering;
  monitor.report(0.3);
  const Sight sight(covering.scene().carriers(), origin);
  Dominance dominance = find_dominance(sight, covering.index(), covering.turns(), monitor);
  covering.index().forget_footprints();
  data->pairs_tested = dominance.pairs_tested;
  monitor.report(0.7);
  std::vector<Sign> turns = covering.turns();
  data->order = order_in_layers(data->pieces, origin, std::move(dominance), turns, monitor);
  monitor.report(0.9);
  const LayerOrder& order = data->order;
  data->first.assign(order.layer_count + 2, 0);
  for (const std::uint32_t l : order.layer) data->first[l + 1] += l != 0;
  for (std::uint32_t l = 1; l <= order.layer_count; ++l) data->first[l + 1] += data->first[l];
  data->sorted.resize(data->first[order.layer_count + 1]);
  std::vector<std::uint32_t> next = data->first;
  for (std::uint32_t p = 0; p < order.layer.size(); ++p)
    if (order.layer[p] != 0) data->sorted[next[order.layer[p]]++] = p;
  data_ = data;
}

std::array<RationalPoint, 3> LayerDecomposition::triangle(std::uint32_t piece) const {
  const Corners v = data_->pieces.corners(piece);
  return {data_->pieces.position(v[0]), data_->pieces.position(v[1]), data_->pieces.position(v[2])};
}

std::span<const std::uint32_t> LayerDecomposition::layer_pieces(std::uint32_t layer) const {
  const auto& first = data_->first;
  return std::span(data_->sorted).subspan(first[layer], first[layer + 1] - first[layer]);
}

std::span<const std::uint32_t> LayerDecomposition::dominators(std::uint32_t piece) const {
  const auto& first = data_->order.first;
  return std::span(data_->order.dominators).subspan(first[piece], first[piece + 1] - first[piece]);
}

std::size_t LayerDecomposition::bytes() const {
  const LayerOrder& o = data_->order;
  return covering().index().bytes() + 2 * covering().turns().size() +
         sizeof(std::uint32_t) * (o.layer.size() + o.first.size() + o.dominators.size() + data_->sorted.size());
}

std::vector<std::string> LayerDecomposition::validate(std::size_t) const {
  std::vector<std::string> wrong;
  for (std::uint32_t p = 0; p < piece_count(); ++p) {
    std::uint32_t last = 0;
    for (const std::uint32_t d : dominators(p)) {
      if (layer(d) >= layer(p))
        wrong.push_back("piece " + std::to_string(p) + " is not after its dominator " + std::to_string(d));
      last = std::max(last, layer(d));
    }
    if (layer(p) > 1 && last + 1 != layer(p))
      wrong.push_back("piece " + std::to_string(p) + " is not right after its last dominator");
  }
  return wrong;
}

}  // namespace strata
