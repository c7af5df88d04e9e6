#include <numeric>

#include "core/exact/big_integer.h"
#include "core/exact/pairwise_sum.h"
#include "core/mesh/product_sum.h"
#include "strata/planar.h"

namespace strata::planar {

void Loops::add(std::span<const PlanePoint> loop) {
  const std::uint32_t first = places.size();
  places.place.insert(places.place.end(), loop.begin(), loop.end());
  vertices.resize(vertices.size() + loop.size());
  std::iota(vertices.end() - static_cast<std::ptrdiff_t>(loop.size()), vertices.end(), first);
  edge_line.resize(vertices.size(), none);
  first_vertex.push_back(static_cast<std::uint32_t>(vertices.size()));
}

void LoopsBuilder::add_vertex(const PlanePoint& p) {
  vertices_.push_back({0, static_cast<std::uint32_t>(doubles_.size())});
  doubles_.push_back(p);
}

void LoopsBuilder::add_vertex(RationalPlace p) {
  const std::uint32_t number = rationals_.add(std::move(p));
  if (rationals_.error.back() == PlanePoint{0, 0}) {
    add_vertex(rationals_.place.back());
    rationals_.place.pop_back();
    rationals_.error.pop_back();
    rationals_.rationals.pop_back();
    return;
  }
  vertices_.push_back({1, number});
}

void LoopsBuilder::end_loop() { first_vertex_.push_back(static_cast<std::uint32_t>(vertices_.size())); }

Loops LoopsBuilder::finish() {
  Loops loops;
  loops.places = std::move(rationals_);
  loops.places.place.insert(loops.places.place.begin(), doubles_.begin(), doubles_.end());
  for (const auto& [kind, number] : vertices_)
    loops.vertices.push_back(number + (kind == 0 ? 0 : static_cast<std::uint32_t>(doubles_.size())));
  loops.edge_line.assign(loops.vertices.size(), none);
  loops.first_vertex = std::move(first_vertex_);
  *this = {};
  return loops;
}

Loops loops_of(std::span<const std::vector<PlanePoint>> loops) {
  Loops all;
  for (const std::vector<PlanePoint>& loop : loops) all.add(loop);
  return all;
}

namespace {

/// The sum over edges, with edges between doubles summed separately.
class AreaSum {
 public:
  explicit AreaSum(const Places& places) : places_(places) {}
  void add(std::span<const std::uint32_t> loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) add_edge(loop[i], loop[i + 1 < loop.size() ? i + 1 : 0]);
  }
  [[nodiscard]] Rational value() const { return doubles_.value() + others_.value(); }

 private:
  void add_edge(std::uint32_t p, std::uint32_t q) {
    if (places_.is_double(p) && places_.is_double(q)) {
      const PlanePoint &a = places_.place[p], &b = places_.place[q];
      doubles_.add(a[0], b[1], 1);
      doubles_.add(-a[1], b[0], 1);
    } else {
      const RationalPlacement a = exact_position(places_, p), b = exact_position(places_, q);
      others_.add(a[0] * b[1] - a[1] * b[0]);
    }
  }

  const Places& places_;
  ProductSum doubles_;
  PairwiseSum others_;
};

}  // namespace

Rational twice_area(const Loops& loops, std::span<const std::uint32_t> loop) {
  AreaSum sum(loops.places);
  sum.add(loop);
  return sum.value();
}

Rational twice_area(const Loops& loops) {
  AreaSum sum(loops.places);
  for (std::uint32_t i = 0; i < loops.size(); ++i) sum.add(loops.loop(i));
  return sum.value();
}

}  // namespace strata::planar
