#pragma once
#include <cstdint>
#include <deque>
#include <span>
#include <unordered_map>
#include <vector>

#include "extensions/scene/dominance.h"
#include "extensions/scene/lists.h"
#include "extensions/scene/pieces.h"
#include "extensions/scene/subordination.h"

namespace strata {

/// Dominance and crossings among pieces, updated while pieces are cut. Replaced pieces are in no list.
class Relation {
 public:
  /// `turns` gets the orientations of parts.
  Relation(Pieces& pieces, const Origin& origin, Dominance dominance, std::vector<Sign>& orientations);

  [[nodiscard]] std::vector<std::uint32_t> dominators(std::uint32_t p) const {
    return live(dominators_.of(p), later_dominators_, p);
  }
  [[nodiscard]] std::vector<std::uint32_t> dominated(std::uint32_t p) const {
    return live(dominated_.of(p), later_dominated_, p);
  }
  [[nodiscard]] TetrahedraOverlap overlap(std::uint32_t s, std::uint32_t t) const {
    return overlap_of(sight_, seen(s), seen(t));
  }

  /// Cuts p and relates the parts to all pieces to which p was related. False if the plane does not cut p.
  bool cut(std::uint32_t p, const RationalPlane& plane);

  /// Would a cut of p separate its rays to t from those that come from s? The cut is undone.
  [[nodiscard]] bool would_part(std::uint32_t p, const RationalPlane& plane, std::uint32_t s, std::uint32_t t);

  /// Pairs that cross, some of which may have been cut since.
  [[nodiscard]] bool has_open_crossings() const { return !open_crossings_.empty(); }
  [[nodiscard]] Domination next_crossing();

  /// All remaining dominations, those of whole faces sorted.
  [[nodiscard]] const std::vector<Domination>& pairs();

 private:
  using Later = std::unordered_map<std::uint32_t, std::vector<std::uint32_t>>;

  [[nodiscard]] SeenTriangle seen(std::uint32_t p) const { return {pieces_.corners(p), orientations_[p]}; }
  void relate(std::uint32_t p, std::uint32_t q);
  void add_pair(std::uint32_t s, std::uint32_t t);
  void add_crossing(std::uint32_t s, std::uint32_t t);
  [[nodiscard]] std::vector<std::uint32_t> live(std::span<const std::uint32_t> from_start, const Later& later,
                                                std::uint32_t p) const;

  Pieces& pieces_;
  Sight sight_;
  std::vector<Sign>& orientations_;
  std::vector<Domination> pairs_;
  Lists dominators_, dominated_;  ///< among whole faces
  Later later_dominators_, later_dominated_, crossing_;
  std::deque<Domination> open_crossings_;
};

}  // namespace strata
