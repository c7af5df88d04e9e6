#include "extensions/scene/relation.h"

#include <utility>

namespace strata {

Relation::Relation(Pieces& pieces, const Origin& origin, Dominance dominance, std::vector<Sign>& orientations)
    : pieces_(pieces),
      sight_(pieces.input(), origin),
      orientations_(orientations),
      pairs_(std::move(dominance.dominations)),
      dominators_(dominators_of(pieces.face_count(), pairs_)),
      dominated_(dominated_by(pieces.face_count(), pairs_)) {
  for (const Domination& d : dominance.crossings) add_crossing(d.s, d.t);
}

bool Relation::cut(std::uint32_t p, const RationalPlane& plane) {
  const std::uint32_t before = pieces_.count();
  const auto above = dominators(p), below = dominated(p), across = live({}, crossing_, p);
  if (!pieces_.cut(p, plane)) return false;
  for (std::uint32_t part = before; part < pieces_.count(); ++part) {
    orientations_.push_back(orientations_[p]);
    for (const auto& list : {above, below, across})
      for (const std::uint32_t q : list) relate(part, q);
  }
  return true;
}

bool Relation::would_part(std::uint32_t p, const RationalPlane& plane, std::uint32_t s, std::uint32_t t) {
  const Pieces::Mark mark = pieces_.mark();
  const std::uint32_t before = pieces_.count();
  if (!pieces_.cut(p, plane)) return false;
  bool parted = true;
  for (std::uint32_t part = before; part < pieces_.count(); ++part) {
    orientations_.push_back(orientations_[p]);
    parted =
        parted && !(overlap(part, t) == TetrahedraOverlap::before && overlap(part, s) == TetrahedraOverlap::behind);
  }
  orientations_.resize(before);
  pieces_.undo(p, mark);
  return parted;
}

Domination Relation::next_crossing() {
  const Domination d = open_crossings_.front();
  open_crossings_.pop_front();
  return d;
}

const std::vector<Domination>& Relation::pairs() {
  std::erase_if(pairs_, [&](const Domination& d) { return pieces_.is_replaced(d.s) || pieces_.is_replaced(d.t); });
  return pairs_;
}

void Relation::relate(std::uint32_t p, std::uint32_t q) {
  switch (overlap(p, q)) {
    case TetrahedraOverlap::before:
      add_pair(p, q);
      return;
    case TetrahedraOverlap::behind:
      add_pair(q, p);
      return;
    case TetrahedraOverlap::crossing:
      add_crossing(p, q);
      return;
    case TetrahedraOverlap::apart:
    case TetrahedraOverlap::touching:
    case TetrahedraOverlap::coplanar:
      return;
  }
}

void Relation::add_pair(std::uint32_t s, std::uint32_t t) {
  pairs_.push_back({s, t});
  later_dominators_[s].push_back(t);
  later_dominated_[t].push_back(s);
}

void Relation::add_crossing(std::uint32_t s, std::uint32_t t) {
  open_crossings_.push_back({s, t});
  crossing_[s].push_back(t);
  crossing_[t].push_back(s);
}

std::vector<std::uint32_t> Relation::live(std::span<const std::uint32_t> from_start, const Later& later,
                                          std::uint32_t p) const {
  std::vector<std::uint32_t> list(from_start.begin(), from_start.end());
  if (const auto more = later.find(p); more != later.end())
    list.insert(list.end(), more->second.begin(), more->second.end());
  std::erase_if(list, [&](std::uint32_t q) { return pieces_.is_replaced(q); });
  return list;
}

}  // namespace strata
