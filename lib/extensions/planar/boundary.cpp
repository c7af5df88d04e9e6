#include "extensions/planar/boundary.h"

#include <numeric>

namespace strata::planar {
namespace {

/// Components of the labelled faces: cycles united over edges with a label on both sides, and with the cycles of
/// components inside them.
class FaceSets {
 public:
  FaceSets(const Subdivision& s, const std::vector<std::uint8_t>& label) : name_(s.cycles) {
    std::iota(name_.begin(), name_.end(), 0u);
    for (std::uint32_t c = 0; c < s.chains.size(); ++c) {
      if (!s.is_edge(c)) continue;
      const std::uint32_t left = s.cycle_of[2 * c], right = s.cycle_of[2 * c + 1];
      if (label[left] && label[right]) unite(left, right);
    }
    for (const Subdivision::Component& c : s.components)
      if (c.container != none) unite(s.cycle_of[c.start], s.cycle_of[c.container]);
  }
  std::uint32_t find(std::uint32_t c) {
    while (name_[c] != c) c = name_[c] = name_[name_[c]];
    return c;
  }

 private:
  void unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    name_[std::max(a, b)] = std::min(a, b);
  }
  std::vector<std::uint32_t> name_;
};

class Linker {
 public:
  Linker(const Arrangement& a, const Subdivision& s, const std::vector<std::uint8_t>& label)
      : a_(a),
        s_(s),
        faces_(s, label),
        is_kept_(s.next.size()),
        next_(s.next.size(), none),
        place_on_path_(a.places.size(), none) {
    for (std::uint32_t h = 0; h < s.next.size(); ++h)
      is_kept_[h] = s.next[h] != none && label[s.cycle_of[h]] && !label[s.cycle_of[h ^ 1]];
  }

  BoundaryLoops link() {
    for (std::uint32_t h = 0; h < next_.size(); ++h)
      if (is_kept_[h] && next_[h] == none) next_[h] = successor(h);
    for (std::uint32_t h = 0; h < next_.size(); ++h)
      if (is_kept_[h]) walk(h);
    return std::move(loops_);
  }

 private:
  /// The kept half-edge after h: the first one clockwise from the reverse of h.
  [[nodiscard]] std::uint32_t successor(std::uint32_t h) const {
    std::uint32_t g = s_.next[h];
    while (!is_kept_[g]) g = s_.next[g ^ 1];
    return g;
  }
  /// Traverses the boundary from h. A part that returns to a node is a loop of its own.
  void walk(std::uint32_t start) {
    std::uint32_t h = start;
    do {
      const std::uint32_t node = origin(a_, s_, h);
      if (place_on_path_[node] != none) cut(place_on_path_[node]);
      place_on_path_[node] = static_cast<std::uint32_t>(path_.size());
      path_.push_back(h);
      is_kept_[h] = 0;
      h = next_[h];
    } while (h != start);
    if (!path_.empty()) cut(0);
  }
  void cut(std::uint32_t from) {
    for (std::uint32_t i = from; i < path_.size(); ++i) place_on_path_[origin(a_, s_, path_[i])] = none;
    loops_.half_edges.insert(loops_.half_edges.end(), path_.begin() + from, path_.end());
    loops_.first.push_back(static_cast<std::uint32_t>(loops_.half_edges.size()));
    loops_.component.push_back(faces_.find(s_.cycle_of[path_[from]]));
    path_.resize(from);
  }

  const Arrangement& a_;
  const Subdivision& s_;
  FaceSets faces_;
  std::vector<std::uint8_t> is_kept_;
  std::vector<std::uint32_t> next_;
  std::vector<std::uint32_t> place_on_path_;  ///< of every vertex, none if it is not on the path
  std::vector<std::uint32_t> path_;
  BoundaryLoops loops_;
};

}  // namespace

BoundaryLoops boundary_loops(const Arrangement& a, const Subdivision& s, const std::vector<std::uint8_t>& label) {
  return Linker(a, s, label).link();
}

}  // namespace strata::planar
