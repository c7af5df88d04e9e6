#pragma once
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "strata/expression.h"

namespace strata {

struct Expression::Node {
  enum class Kind : std::uint8_t { solid, any, all, odd, complement, moved };
  using Pointer = Shared<Node>;

  Kind kind = Kind::solid;
  Solid solid;
  std::string name;
  Transform map;
  Placement placement = Placement::exact;
  mutable std::vector<Pointer> terms;  ///< changed only by the destructor
  std::size_t size = 1;                ///< solids, counted as often as they occur; the largest number for more

  Node(Kind k, std::vector<Pointer> t) : kind(k), terms(std::move(t)), size(0) {
    for (const Pointer& p : terms) size += std::min(p->size, std::numeric_limits<std::size_t>::max() - size);
  }
  /// The image of another one.
  Node(Pointer image_of, const Transform& m, Placement p) : Node(Kind::moved, {std::move(image_of)}) {
    map = m;
    placement = p;
  }
  Node(Solid s, std::string n) : solid(std::move(s)), name(std::move(n)) {}
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  /// Terms that no other node owns are destroyed one after the other: chains are too deep for recursion.
  ~Node() {
    std::vector<Pointer> parts = std::move(terms);
    while (!parts.empty()) {
      const Pointer part = std::move(parts.back());
      parts.pop_back();
      if (!part.is_only()) continue;
      parts.insert(parts.end(), std::make_move_iterator(part->terms.begin()),
                   std::make_move_iterator(part->terms.end()));
      part->terms.clear();
    }
  }

  static Pointer join(Kind kind, std::vector<Pointer> terms) { return Pointer::make(kind, std::move(terms)); }
  static Pointer complement_of(Pointer term) { return join(Kind::complement, {std::move(term)}); }
};

/// An occurrence of a solid.
struct Occurrence {
  const Expression::Node* leaf = nullptr;
  Transform map;  ///< the product of all transforms above it
  Placement placement = Placement::exact;
  /// With symmetric differences written out, the solid occurs as it is, as its complement, or both.
  bool positive = true, negative = false;
};

/// Evaluates an expression bottom-up, without recursion: `leaf(Occurrence)`, `complement(value)`, `join(Kind, values)`.
/// O(size).
template <class Value, class Leaf, class Complement, class Join>
Value fold(const Expression::Node& root, const Leaf& leaf, const Complement& complement, const Join& join) {
  using Kind = Expression::Node::Kind;
  struct Frame {
    const Expression::Node* node;
    Occurrence place;
    std::vector<Value> values;
  };
  std::vector<Frame> frames;
  const auto enter = [&](const Expression::Node& node, Occurrence place) {
    if (node.kind == Kind::moved) {
      place.map = place.map * node.map;
      // A transform that is rounded anywhere above is rounded.
      if (node.placement == Placement::rounded) place.placement = Placement::rounded;
    }
    if (node.kind == Kind::complement) std::swap(place.positive, place.negative);
    if (node.kind == Kind::odd && node.terms.size() > 1) place.positive = place.negative = true;
    if (node.kind == Kind::solid) place.leaf = &node;
    frames.push_back({&node, std::move(place), {}});
  };
  enter(root, {});
  while (true) {
    Frame& top = frames.back();
    const Expression::Node& node = *top.node;
    if (top.values.size() < node.terms.size()) {
      enter(*node.terms[top.values.size()], Occurrence(top.place));
      continue;
    }
    Value value = [&] {
      switch (node.kind) {
        case Kind::solid:
          return leaf(top.place);
        case Kind::complement:
          return complement(std::move(top.values.front()));
        case Kind::moved:
          return std::move(top.values.front());
        case Kind::any:
        case Kind::all:
        case Kind::odd:
          break;
      }
      return join(node.kind, std::move(top.values));
    }();
    frames.pop_back();
    if (frames.empty()) return value;
    frames.back().values.push_back(std::move(value));
  }
}

/// Solids by identity and transform, numbered by first occurrence.
class NumberedSolids {
 public:
  explicit NumberedSolids(const Expression::Node& root) {
    fold<char>(
        root,
        [&](const Occurrence& o) {
          const auto [at, is_new] = numbers_.try_emplace(key_of(o), static_cast<std::uint32_t>(occurrences_.size()));
          if (is_new) occurrences_.push_back(o);
          occurrences_[at->second].positive |= o.positive;
          occurrences_[at->second].negative |= o.negative;
          return '\0';
        },
        [](char c) { return c; }, [](Expression::Node::Kind, const std::vector<char>&) { return '\0'; });
  }

  [[nodiscard]] std::uint32_t number_of(const Occurrence& o) const { return numbers_.at(key_of(o)); }
  [[nodiscard]] const std::vector<Occurrence>& occurrences() const { return occurrences_; }

 private:
  using Key = std::tuple<const ExactMesh*, Placement, std::array<Transform::Row, 3>>;
  static Key key_of(const Occurrence& o) { return {&o.leaf->solid.exact_mesh(), o.placement, o.map.rows()}; }

  std::map<Key, std::uint32_t> numbers_;
  std::vector<Occurrence> occurrences_;
};

}  // namespace strata
