#include "core/csg/overlapping_operands.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/containers/box_sweep.h"
#include "core/kernel/box.h"

namespace strata {
namespace {

/// Operands that overlap fewer others, or less than half of them, are faster to evaluate together.
constexpr std::size_t crowd = 16;
constexpr std::size_t most_in_group = 13;
constexpr std::size_t most_operands = 2000;

std::vector<OperandBox> crowded(std::span<const OperandBox> all) {
  std::vector<Box> boxes;
  for (const OperandBox& b : all) boxes.push_back(b.box);
  std::vector<std::size_t> others(all.size(), 0);  // that overlap an operand
  for_each_overlapping_pair(boxes, [&](std::uint32_t a, std::uint32_t b) {
    ++others[a];
    ++others[b];
  });
  std::vector<OperandBox> found;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (others[i] >= crowd && 2 * others[i] >= all.size()) found.push_back(all[i]);
  return found;
}

std::size_t longest_axis(std::span<const OperandBox> group) {
  Box middles;
  for (const OperandBox& b : group) middles.include(std::array{b.middle(0), b.middle(1), b.middle(2)});
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (middles.upper[i] - middles.lower[i] > middles.upper[axis] - middles.lower[axis]) axis = i;
  return axis;
}

/// Divides a group into halves along the axis along which the boxes extend most.
void divide(std::span<OperandBox> group, std::vector<std::vector<std::uint32_t>>& groups) {
  if (group.size() > most_in_group) {
    const std::size_t axis = longest_axis(group);
    std::sort(group.begin(), group.end(), [&](const OperandBox& a, const OperandBox& b) {
      return std::pair(a.middle(axis), a.operand) < std::pair(b.middle(axis), b.operand);
    });
    divide(group.first(group.size() / 2), groups);
    divide(group.subspan(group.size() / 2), groups);
    return;
  }
  std::vector<std::uint32_t> members;
  for (const OperandBox& b : group) members.push_back(b.operand);
  std::sort(members.begin(), members.end());
  groups.push_back(std::move(members));
}

}  // namespace

std::vector<std::vector<std::uint32_t>> groups_of_overlapping_operands(std::span<const OperandBox> united) {
  if (united.size() <= crowd || united.size() > most_operands) return {};
  std::vector<OperandBox> found = crowded(united);
  std::vector<std::vector<std::uint32_t>> groups;
  if (found.size() > crowd) divide(found, groups);
  return groups;
}

}  // namespace strata
