#include <algorithm>
#include <cmath>
#include <optional>

#include "core/cells/walk.h"
#include "extensions/scene/closed_face.h"
#include "extensions/scene/dominance.h"
#include "extensions/scene/layer_decomposition_data.h"
#include "extensions/scene/location.h"
#include "extensions/scene/scene_data.h"

namespace strata {

const Scene& LayerDecomposition::scene() const { return data_->covering.scene(); }
const Origin& LayerDecomposition::origin() const { return data_->covering.origin(); }
std::uint32_t LayerDecomposition::layer_count() const { return data_->order.layer_count; }
std::uint32_t LayerDecomposition::piece_count() const { return data_->pieces.count(); }
std::uint32_t LayerDecomposition::layer(std::uint32_t piece) const { return data_->order.layer[piece]; }
bool LayerDecomposition::is_replaced(std::uint32_t piece) const { return data_->pieces.is_replaced(piece); }
std::uint32_t LayerDecomposition::face_of(std::uint32_t piece) const { return data_->pieces.face_of(piece); }
int LayerDecomposition::sign(std::uint32_t piece) const { return -to_int(data_->covering.orientation(face_of(piece))); }
WindingNumbers LayerDecomposition::windings_of_origin() const {
  return numbers_of(data_->covering.windings_of_origin());
}
std::span<const std::uint32_t> LayerDecomposition::back_to_front() const { return data_->sorted; }
std::uint32_t LayerDecomposition::cuts_at_crossings() const { return data_->order.cuts_at_crossings; }
std::uint32_t LayerDecomposition::cuts_of_cycles() const { return data_->order.cuts_of_cycles; }
std::uint64_t LayerDecomposition::domination_count() const { return data_->order.dominators.size(); }
std::uint64_t LayerDecomposition::pairs_tested() const { return data_->pairs_tested; }

LayerDecomposition::LayerDecomposition(Scene scene, const Origin& origin, const Monitor& monitor)
    : data_(Shared<Data>::make(std::move(scene), origin, monitor)) {}

LayerDecomposition::Data::Data(Scene scene, const Origin& origin, const Monitor& monitor)
    : covering(std::move(scene), origin, true, monitor), pieces(covering.scene()) {
  monitor.report(0.3);
  const Sight sight(input_complex_of(covering.scene()), origin);
  Dominance dominance = find_dominance(sight, covering.index(), covering.orientations(), monitor);
  covering.index().forget_footprints();
  pairs_tested = dominance.pairs_tested;
  monitor.report(0.7);
  std::vector<Sign> orientations = covering.orientations();
  order = order_in_layers(pieces, origin, std::move(dominance), orientations, monitor);
  monitor.report(0.9);
  first.assign(order.layer_count + 2, 0);
  for (const std::uint32_t l : order.layer) first[l + 1] += l != 0;
  for (std::uint32_t l = 1; l <= order.layer_count; ++l) first[l + 1] += first[l];
  sorted.resize(first[order.layer_count + 1]);
  std::vector<std::uint32_t> next = first;
  for (std::uint32_t p = 0; p < order.layer.size(); ++p)
    if (order.layer[p] != 0) sorted[next[order.layer[p]]++] = p;
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
  return data_->covering.bytes() +
         sizeof(std::uint32_t) * (o.layer.size() + o.first.size() + o.dominators.size() + data_->sorted.size());
}

namespace {

/// Winding numbers at q by a walk from infinity past all faces; nullopt if q lies on the surface.
std::optional<Windings> walk_past_all(const Scene& scene, const Vertex& q) {
  const InputComplex& input = input_complex_of(scene);
  const Point point = Point::free(q);
  Windings windings;
  for (std::uint32_t f = 0; f < scene.face_count(); ++f) {
    if (is_on_closed_face(input, f, point)) return std::nullopt;
    windings.add(input.operand_of_face(f), crossing_from_infinity(input, f, {3, -7, 11}, point));
  }
  return windings;
}

/// Doubles distributed over the scene by a fixed sequence (Weyl's).
Vertex sample_point(const Scene& scene, std::size_t n) {
  constexpr std::array<double, 3> step{0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
  const auto& input = input_complex_of(scene);
  Vertex q{};
  for (std::size_t i = 0; i < 3; ++i) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (std::uint32_t s = 0; s < scene.solid_count(); ++s)
      for (const Vertex& v : input.points(s)) {
        low = std::min(low, v[i]);
        high = std::max(high, v[i]);
      }
    const double t = std::fmod(static_cast<double>(n + 1) * step[i], 1.0);
    q[i] = low * (1 - t) + high * t;
  }
  return q;
}

}  // namespace

std::vector<std::string> LayerDecomposition::validate(std::size_t samples) const {
  std::vector<std::string> wrong;
  const auto piece_name = [](std::uint32_t p) { return "piece " + std::to_string(p); };
  for (std::uint32_t p = 0; p < piece_count(); ++p) {
    std::uint32_t last = 0;
    for (const std::uint32_t d : dominators(p)) {
      if (layer(d) >= layer(p)) wrong.push_back(piece_name(p) + " is not after its dominator " + std::to_string(d));
      last = std::max(last, layer(d));
    }
    const bool has_layer = sign(p) != 0 && !is_replaced(p);
    if (has_layer != (layer(p) != 0))
      wrong.push_back(piece_name(p) + (has_layer ? " is in no layer" : " is in a layer"));
    if (has_layer && last + 1 != layer(p)) wrong.push_back(piece_name(p) + " is not right after its last dominator");
  }
  for (std::uint32_t l = 1; l <= layer_count(); ++l)
    for (const std::uint32_t p : layer_pieces(l))
      if (layer(p) != l) wrong.push_back(piece_name(p) + " is listed in the wrong layer");
  for (std::size_t n = 0; n < samples && scene().face_count() != 0; ++n) {
    const Vertex q = sample_point(scene(), n);
    const auto windings = walk_past_all(scene(), q);
    if (windings && !(data_->covering.locate(q).windings == numbers_of(*windings)))
      wrong.push_back("the covering does not sum to the winding numbers at sample " + std::to_string(n));
  }
  return wrong;
}

}  // namespace strata
