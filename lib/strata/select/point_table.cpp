#include "strata/select/point_table.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <limits>
#include <numeric>
#include <utility>

namespace strata {
namespace {

using Index = std::uint32_t;
constexpr Index none = std::numeric_limits<Index>::max();
constexpr std::size_t grain = 1 << 12;

template <class Body>
void for_each_index(std::size_t count, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
  });
}

std::uint64_t hash_of(const PointName& name) {
  std::uint64_t h = static_cast<std::uint64_t>(name.kind) * 0x9e3779b97f4a7c15u;
  for (const std::uint32_t id : name.id) h = (h ^ id) * 0xff51afd7ed558ccdu + (h >> 29);
  return h ^ h >> 32;
}

/// Finds the first occurrence of every name in a list. Threads insert at the same time: a slot, once taken, stays with
/// its name and is lowered to the least index seen, so what it ends up with does not depend on their order.
class FirstOccurrences {
 public:
  explicit FirstOccurrences(std::span<const PointName> names)
      : names_(names), mask_(std::bit_ceil(2 * names.size() + 1) - 1), slots_(mask_ + 1, none) {
    for_each_index(names.size(), [&](std::size_t i) { insert(static_cast<Index>(i)); });
  }

  [[nodiscard]] Index of(std::size_t i) const {
    for (std::size_t s = hash_of(names_[i]);; ++s)
      if (const Index first = slots_[s & mask_]; names_[first] == names_[i]) return first;
  }

 private:
  void insert(Index i) {
    for (std::size_t s = hash_of(names_[i]);; ++s) {
      const std::atomic_ref<Index> slot(slots_[s & mask_]);
      Index known = slot.load(std::memory_order_relaxed);
      if (known == none && slot.compare_exchange_strong(known, i, std::memory_order_relaxed)) return;
      if (!(names_[known] == names_[i])) continue;
      while (i < known && !slot.compare_exchange_weak(known, i, std::memory_order_relaxed)) {
      }
      return;
    }
  }

  std::span<const PointName> names_;
  std::size_t mask_;
  std::vector<Index> slots_;
};

/// Classes of equal points; one of each class stands for all.
class Classes {
 public:
  explicit Classes(std::span<const PointName> names) : names_(names), parent_(names.size()) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }
  [[nodiscard]] Index root(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(Index a, Index b) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    if (precedes(b, a)) std::swap(a, b);
    parent_[b] = a;
  }

 private:
  [[nodiscard]] bool precedes(Index a, Index b) const {
    const bool input_a = names_[a].kind == PointName::Kind::input, input_b = names_[b].kind == PointName::Kind::input;
    if (input_a != input_b) return input_a;
    return input_a ? names_[a].id[0] < names_[b].id[0] : a < b;
  }

  std::span<const PointName> names_;
  std::vector<Index> parent_;
};

}  // namespace

PointTable::PointTable(SplitFaces& split, std::span<const EqualVertices> equal) {
  // All occurrences in one list: the faces' points, then both sides of each equality.
  std::vector<std::size_t> first(split.faces.size() + 1, 0);
  for (std::size_t f = 0; f < split.faces.size(); ++f) first[f + 1] = first[f] + split.faces[f].points.size();
  std::vector<PointName> occurrences(first.back());
  tbb::parallel_for(std::size_t{0}, split.faces.size(), [&](std::size_t f) {
    std::copy(split.faces[f].points.begin(), split.faces[f].points.end(),
              occurrences.begin() + static_cast<std::ptrdiff_t>(first[f]));
  });
  for (const auto& [a, b] : split.equal) occurrences.insert(occurrences.end(), {a, b});
  for (const EqualVertices& e : equal)
    occurrences.insert(occurrences.end(), {PointName::input(e.a), PointName::input(e.b)});

  const FirstOccurrences firsts(occurrences);
  std::vector<Index> first_of(occurrences.size()), number(occurrences.size());
  for_each_index(first_of.size(), [&](std::size_t i) { first_of[i] = firsts.of(i); });
  for (std::size_t i = 0; i < first_of.size(); ++i)
    if (first_of[i] == i) {
      number[i] = static_cast<Index>(names_.size());
      names_.push_back(occurrences[i]);
    }
  Classes classes(names_);
  std::vector<Index> representative;
  for (std::size_t i = first.back(); i < occurrences.size(); i += 2)
    classes.join(number[first_of[i]], number[first_of[i + 1]]);
  for (std::size_t i = 0; i < names_.size(); ++i) {
    representative.push_back(classes.root(static_cast<Index>(i)));
    if (names_[i].kind == PointName::Kind::input && representative[i] != i)
      replaced_.push_back({names_[i].id[0], names_[representative[i]].id[0]});
  }
  tbb::parallel_for(std::size_t{0}, split.faces.size(), [&](std::size_t f) {
    SplitFace& face = split.faces[f];
    face.ids.resize(face.points.size());
    for (std::size_t k = 0; k < face.ids.size(); ++k) face.ids[k] = representative[number[first_of[first[f] + k]]];
  });
}

}  // namespace strata
