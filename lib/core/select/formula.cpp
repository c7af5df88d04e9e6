#include "strata/formula.h"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <functional>

#include "core/cells/windings.h"

namespace strata {

Formula::Term Formula::operand(std::uint32_t number) const { return {number, true, false}; }

Formula::Term Formula::join(Join join, std::span<const Term> terms) {
  const auto number = static_cast<std::uint32_t>(joints_.size());
  Joint joint{join, static_cast<std::uint32_t>(terms.size()), 0, {}};
  for (const Term& t : terms) {
    const Place place{number, t.negated_};
    bool holds = false;
    if (t.is_operand_) {
      occurrences_[t.number_].push_back(place);
    } else {
      Joint& term = joints_[t.number_];
      term.in = place;
      term.absorbed = absorbs(join, term, t.negated_);
      if (term.absorbed) {
        joint.terms += term.terms - 1;
        joint.held += t.negated_ ? term.terms - term.held : term.held;
        continue;
      }
      holds = value(term, term.held);
    }
    joint.held += holds != t.negated_;
  }
  joints_.push_back(joint);
  return {number, false, false};
}

bool Formula::absorbs(Join join, const Joint& term, bool negated) {
  if (!negated) return term.join == join;
  return (join == Join::any && term.join == Join::all) || (join == Join::all && term.join == Join::any);
}

/// Requires that the nodes after the position's own are resolved.
Formula::Place Formula::resolve(Place place) const {
  if (place.joint == none || !joints_[place.joint].absorbed) return place;
  const Place& by = joints_[place.joint].in;
  return {by.joint, place.negated != by.negated};
}

void Formula::close(const Term& whole) {
  join(Join::any, {&whole, 1});
  for (auto j = joints_.rbegin(); j != joints_.rend(); ++j) j->in = resolve(j->in);
  for (auto& places : occurrences_)
    for (Place& p : places) p = resolve(p);
  settles_.resize(2 * occurrences_.size());
  for (std::uint32_t o = 0; o < operands(); ++o)
    for (const bool in : {false, true}) settles_[2 * std::size_t{o} + (in ? 1 : 0)] = find_settled(o, in);
}

bool Formula::value(const Joint& joint, std::uint32_t held) {
  switch (joint.join) {
    case Join::any:
      return held > 0;
    case Join::all:
      return held == joint.terms;
    case Join::odd:
      return held % 2 == 1;
  }
  return false;
}

namespace {

/// Nodes to process, each with the changes of its terms: first those that are terms of others.
template <class News>
class Agenda {
 public:
  void add(std::uint32_t joint, const News& news) {
    entries_.emplace_back(joint, news);
    std::push_heap(entries_.begin(), entries_.end(), later);
  }
  [[nodiscard]] bool empty() const { return entries_.empty(); }
  /// Visits all changes of the first node and removes them.
  template <class Visit>
  std::uint32_t take(const Visit& visit) {
    const std::uint32_t joint = entries_.front().first;
    while (!entries_.empty() && entries_.front().first == joint) {
      std::pop_heap(entries_.begin(), entries_.end(), later);
      visit(entries_.back().second);
      entries_.pop_back();
    }
    return joint;
  }

 private:
  using Entry = std::pair<std::uint32_t, News>;
  static bool later(const Entry& a, const Entry& b) { return a.first > b.first; }
  boost::container::small_vector<Entry, 16> entries_;
};

}  // namespace

bool Formula::holds(const Windings& windings) const {
  Agenda<int> changes;  // of the number of terms that hold
  for (const auto& [operand, w] : windings)
    if (w > 0)
      for (const Place& p : occurrences_[operand]) changes.add(p.joint, p.negated ? -1 : 1);
  while (!changes.empty()) {
    int change = 0;
    const Joint& joint = joints_[changes.take([&](int c) { change += c; })];
    const bool now = value(joint, joint.held + static_cast<std::uint32_t>(change));
    if (&joint == &joints_.back()) return now;
    if (now != value(joint, joint.held) && joint.in.joint != none)
      changes.add(joint.in.joint, now != joint.in.negated ? 1 : -1);
  }
  return value(joints_.back(), joints_.back().held);
}

/// Kleene's logic of three values: all other operands are unknown.
bool Formula::find_settled(std::uint32_t operand, bool in) const {
  Agenda<bool> known;  // values of terms
  for (const Place& p : occurrences_[operand]) known.add(p.joint, in != p.negated);
  while (!known.empty()) {
    std::uint32_t terms = 0, held = 0;
    const std::uint32_t number = known.take([&](bool holds) {
      ++terms;
      held += holds;
    });
    const Joint& joint = joints_[number];
    const bool decided =
        terms == joint.terms || (joint.join == Join::any && held > 0) || (joint.join == Join::all && held < terms);
    if (!decided) continue;
    if (number + 1 == joints_.size()) return true;
    const bool holds = joint.join == Join::all ? held == terms : value(joint, held);
    if (joint.in.joint != none) known.add(joint.in.joint, holds != joint.in.negated);
  }
  return false;
}

/// Terms of one node: of `any` as they are; by De Morgan, of `all` negated.
std::vector<std::vector<std::uint32_t>> Formula::unions() const {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> terms;  // node, operand
  for (std::uint32_t o = 0; o < operands(); ++o) {
    if (occurrences_[o].size() != 1) continue;
    const Place& p = occurrences_[o].front();
    const Join join = joints_[p.joint].join;
    if ((join == Join::any && !p.negated) || (join == Join::all && p.negated)) terms.emplace_back(p.joint, o);
  }
  std::sort(terms.begin(), terms.end());
  std::vector<std::vector<std::uint32_t>> all;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    if (i == 0 || terms[i].first != terms[i - 1].first) all.emplace_back();
    all.back().push_back(terms[i].second);
  }
  std::erase_if(all, [](const auto& list) { return list.size() < 2; });
  return all;
}

}  // namespace strata
