#include "core/select/hidden_faces.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <compare>

#include "core/kernel/disjoint_sets.h"
#include "core/kernel/predicates.h"
#include "core/select/covering.h"

namespace strata {
namespace {

/// The faces that meet coplanar faces only, by number, with these.
class CoveredFaces {
 public:
  CoveredFaces(const InputComplex& input, std::span<const PairIntersections> met) : input_(input) {
    const std::vector<Pair> pairs = pairs_by_face(met, faces_met_otherwise(met));
    others_.reserve(pairs.size());
    for (const Pair& p : pairs) {
      if (faces_.empty() || faces_.back() != p.face) {
        faces_.push_back(p.face);
        first_.push_back(others_.size());
      }
      others_.push_back(p.other);
    }
    first_.push_back(others_.size());
  }

  [[nodiscard]] std::size_t count() const { return faces_.size(); }
  [[nodiscard]] std::uint32_t face(std::size_t i) const { return faces_[i]; }
  [[nodiscard]] std::span<const std::uint32_t> coplanar(std::size_t i) const {
    return std::span(others_).subspan(first_[i], first_[i + 1] - first_[i]);
  }

  /// Per face one that the same faces cover: theory.md, "Covered faces".
  [[nodiscard]] std::vector<std::uint32_t> representatives() const {
    std::vector<Edge> edges = edges_by_ends();
    DisjointSets<std::uint32_t> alike(count());
    for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
      while (end < edges.size() && edges[end].u == edges[i].u && edges[end].v == edges[i].v) ++end;
      if (end == i + 2 && are_alike(edges[i], edges[i + 1])) alike.unite(edges[i].index, edges[i + 1].index);
    }
    std::vector<std::uint32_t> representatives(count());
    for (std::uint32_t i = 0; i < count(); ++i) representatives[i] = alike.find(i);
    return representatives;
  }

 private:
  /// A face, and one that is coplanar with it.
  struct Pair {
    std::uint32_t face = 0, other = 0;
    friend auto operator<=>(const Pair&, const Pair&) = default;
  };
  /// An edge of a face, its ends in order.
  struct Edge {
    std::uint32_t u = 0, v = 0;
    std::uint32_t index = 0;  ///< of the face
    bool forward = false;     ///< the face runs from u to v
    friend auto operator<=>(const Edge&, const Edge&) = default;
  };

  [[nodiscard]] std::vector<bool> faces_met_otherwise(std::span<const PairIntersections> met) const {
    std::vector<bool> otherwise(input_.face_count(), false);
    for (const PairIntersections& part : met)
      for (const Constraint& c : part.constraints)
        if (c.kind != ConstraintKind::coplanar) otherwise[c.face] = true;
    return otherwise;
  }

  /// Each pair twice.
  static std::vector<Pair> pairs_by_face(std::span<const PairIntersections> met, const std::vector<bool>& left_out) {
    std::vector<Pair> pairs;
    const auto add = [&](std::uint32_t face, std::uint32_t other) {
      if (!left_out[face]) pairs.push_back({face, other});
    };
    for (const PairIntersections& part : met) {
      for (const auto& [f, g] : part.coplanar) {
        add(f, g);
        add(g, f);
      }
      for (const Constraint& c : part.constraints)
        if (c.kind == ConstraintKind::coplanar) add(c.face, c.other);
    }
    tbb::parallel_sort(pairs.begin(), pairs.end());
    return pairs;
  }

  [[nodiscard]] std::vector<Edge> edges_by_ends() const {
    std::vector<Edge> edges;
    edges.reserve(3 * count());
    for (std::uint32_t i = 0; i < count(); ++i) {
      const auto v = input_.face(face(i));
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = v[k], b = v[(k + 1) % 3];
        edges.push_back({std::min(a, b), std::max(a, b), i, a < b});
      }
    }
    tbb::parallel_sort(edges.begin(), edges.end());
    return edges;
  }

  /// Do the same faces cover two faces on one edge? Faces in two planes are not covered at all, so either answer is
  /// right. Two faces in one place, which a solid does not have, are not alike.
  [[nodiscard]] bool are_alike(const Edge& a, const Edge& b) const {
    return a.forward != b.forward && !(input_.is_shared(a.u) && input_.is_shared(a.v)) &&
           same_orientation(input_, face(a.index), face(b.index)) == Sign::positive;
  }

  const InputComplex& input_;
  std::vector<std::uint32_t> faces_, others_;
  std::vector<std::size_t> first_;  ///< of `others_`, per face
};

}  // namespace

std::vector<std::uint32_t> find_hidden_faces(const InputComplex& input, std::span<const PairIntersections> met,
                                             const Rule& rule, const Monitor& monitor) {
  const auto has_coplanar = [](const PairIntersections& part) { return !part.coplanar.empty(); };
  if (std::none_of(met.begin(), met.end(), has_coplanar)) return {};
  const CoveredFaces covered(input, met);
  const std::vector<std::uint32_t> representatives = covered.representatives();
  std::vector<std::uint8_t> is_hidden(covered.count(), 0);
  tbb::enumerable_thread_specific<Covering> coverings([&] { return Covering(input, rule); });
  tbb::parallel_for(std::size_t{0}, covered.count(), [&](std::size_t i) {
    if (representatives[i] != i) return;
    monitor.check();
    is_hidden[i] = coverings.local().hides(covered.face(i), covered.coplanar(i)) ? 1 : 0;
  });
  std::vector<std::uint32_t> hidden;
  for (std::size_t i = 0; i < covered.count(); ++i)
    if (is_hidden[representatives[i]] != 0) hidden.push_back(covered.face(i));
  return hidden;
}

}  // namespace strata
