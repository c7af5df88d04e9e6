#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "extensions/planar/gather.h"
#include "extensions/planar/subdivision.h"

namespace strata::planar {

/// Evaluates a combination in every face of a subdivision.
///
/// Winding numbers are propagated from face to face: crossing a chain from its left to its right subtracts 1 for its
/// operand. A depth-first traversal of all faces undoes its changes on the way back, so one vector of winding numbers
/// suffices, whatever the number of operands. From a face it also visits the components that lie in it.
class Labels {
 public:
  Labels(const Gathered& gathered, const Subdivision& s, std::span<const Operand> operands);

  /// For every cycle, whether the combination holds in the face that it bounds. `holds(const Inside&)`.
  template <class Holds>
  [[nodiscard]] std::vector<std::uint8_t> evaluate(const Holds& holds) {
    std::vector<std::uint8_t> label(subdivision_.cycles, 2);
    for (const Subdivision::Component& c : subdivision_.components)
      if (c.container == none) walk(c.start, holds, label);
    return label;
  }

 private:
  struct Step {
    std::uint32_t entry = none;   ///< half-edge of the cycle
    std::uint32_t at = none;      ///< the one to cross next
    std::uint32_t inside = none;  ///< the next component to visit in the face that the cycle bounds
    bool is_crossing = true;      ///< the cycle was entered over `entry`; else it was in the same face
  };

  template <class Holds>
  void walk(std::uint32_t start, const Holds& holds, std::vector<std::uint8_t>& label) {
    const auto& cycle_of = subdivision_.cycle_of;
    const auto enter = [&](std::uint32_t h, bool is_crossing) {
      label[cycle_of[h]] = holds(inside_) ? 1 : 0;
      path_.push_back({h, h, first_inside_.empty() ? none : first_inside_[cycle_of[h]], is_crossing});
    };
    enter(start, false);
    while (!path_.empty()) {
      Step& step = path_.back();
      if (step.inside != none) {
        const std::uint32_t component = std::exchange(step.inside, next_inside_[step.inside]);
        enter(subdivision_.components[component].start, false);
      } else if (step.at != none) {
        const std::uint32_t h = step.at, other = h ^ 1, next = subdivision_.next[h];
        step.at = next == step.entry ? none : next;
        if (label[cycle_of[other]] != 2) continue;
        cross(h);
        enter(other, true);
      } else {  // all around: back
        if (step.is_crossing) cross(step.entry);
        path_.pop_back();
      }
    }
  }

  /// Crosses from the left of a half-edge to its right.
  void cross(std::uint32_t half_edge) {
    for (std::uint32_t c = half_edge >> 1; c != none; c = same_edge_[c]) {
      const bool against = ((half_edge & 1) != 0) != (subdivision_.is_opposite[c] != 0);
      add(operand_of_chain_[c], against ? 1 : -1);
    }
  }

  void add(std::uint32_t operand, std::int32_t change) {
    std::int32_t& winding = winding_[operand];
    winding += change;
    const auto is_in = static_cast<std::uint8_t>(is_filled(fill_[operand], winding));
    inside_.count += static_cast<std::uint32_t>(is_in) - inside_.is_in[operand];
    inside_.is_in[operand] = is_in;
  }

  const Subdivision& subdivision_;
  std::vector<FillRule> fill_;
  std::vector<std::uint32_t> same_edge_;  ///< the next chain that coincides with a chain
  std::vector<std::uint32_t> operand_of_chain_;
  std::vector<std::uint32_t> first_inside_,
      next_inside_;  ///< components in the face of a cycle; of none, if there is one component
  std::vector<std::int32_t> winding_;
  Inside inside_;
  std::vector<Step> path_;
};

}  // namespace strata::planar
