#pragma once
#include <array>
#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <utility>

#include "core/overlap/constraint.h"
#include "core/overlap/filtered_face.h"
#include "core/overlap/meeting.h"
#include "extensions/contact/parts.h"
#include "strata/monitor.h"

namespace strata::contact {

/// The faces of a leaf that are near a box, with the data for filters in doubles.
class LeafFaces {
 public:
  LeafFaces(const InputComplex& input, std::uint32_t part, const BoxTree& tree, BoxTree::Branch leaf, const Box& near) {
    for (const std::uint32_t f : tree.items(leaf))
      if (const Box box = box_of_face(input, part, f); box.overlaps(near)) list_.push_back({box, {}, f, false});
    input_ = &input;
    part_ = part;
  }
  [[nodiscard]] std::size_t size() const { return list_.size(); }
  [[nodiscard]] const Box& box(std::size_t i) const { return list_[i].box; }
  [[nodiscard]] std::uint32_t number(std::size_t i) const { return list_[i].number; }
  [[nodiscard]] const FilteredFace& face(std::size_t i) {
    if (!list_[i].is_known) list_[i].face = FilteredFace(*input_, part_, list_[i].number);
    list_[i].is_known = true;
    return list_[i].face;
  }

 private:
  struct Entry {
    Box box;
    FilteredFace face;
    std::uint32_t number = 0;
    bool is_known = false;
  };
  const InputComplex* input_ = nullptr;
  std::uint32_t part_ = 0;
  boost::container::small_vector<Entry, BoxTree::leaf_size> list_;
};

/// Calls `visit(f, g, intersections)` for all faces f of part a and g of part b that share a point, but for those of
/// which `skip(f, g)` holds, with what `meet_faces` says about them alone; ends, and returns false, when `visit` does.
/// Always in the same order. Throws Cancelled.
template <class Skip, class Visit>
bool for_each_meeting(const Parts& parts, std::uint32_t a, std::uint32_t b, const Monitor& monitor, const Skip& skip,
                      const Visit& visit) {
  const InputComplex& input = parts.input();
  const BoxTree &tree_a = parts.tree(a), &tree_b = parts.tree(b);
  PairIntersections intersections;
  return for_each_near_leaves(tree_a, tree_b, [&](BoxTree::Branch m, BoxTree::Branch n) {
    monitor.check();
    LeafFaces of_a(input, a, tree_a, m, tree_b.box(n));
    if (of_a.size() == 0) return true;
    LeafFaces of_b(input, b, tree_b, n, tree_a.box(m));
    for (std::size_t i = 0; i < of_a.size(); ++i)
      for (std::size_t k = 0; k < of_b.size(); ++k) {
        if (!of_a.box(i).overlaps(of_b.box(k)) || skip(of_a.number(i), of_b.number(k))) continue;
        intersections.constraints.clear();
        intersections.constructed.clear();
        intersections.equal.clear();
        if (meet_faces(input, of_a.face(i), of_b.face(k), intersections) &&
            !visit(of_a.face(i), of_b.face(k), std::as_const(intersections)))
          return false;
      }
    return true;
  });
}

/// The same for all faces that share a point.
template <class Visit>
bool for_each_meeting(const Parts& parts, std::uint32_t a, std::uint32_t b, const Monitor& monitor,
                      const Visit& visit) {
  return for_each_meeting(
      parts, a, b, monitor, [](std::uint32_t, std::uint32_t) { return false; }, visit);
}

}  // namespace strata::contact
