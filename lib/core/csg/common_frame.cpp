#include "core/csg/common_frame.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace strata {
namespace {

/// Maps of one linear part.
struct Family {
  const Transform* first;
  std::size_t vertices, length;
};

/// The binary digits of all coefficients but the translation.
std::size_t length_of(const Transform& map) {
  std::size_t bits = 0;
  for (const Transform::Row& row : map.rows())
    for (std::size_t j = 0; j < 3; ++j) bits += bit_length(numerator(row[j])) + bit_length(denominator(row[j]));
  return bits;
}

std::optional<std::vector<Family>> families_of(std::span<const PlacedVertices> placed) {
  constexpr std::size_t most = 64;
  std::map<std::array<Rational, 9>, Family> by_linear_part;
  for (const PlacedVertices& p : placed) {
    std::array<Rational, 9> linear;
    for (std::size_t i = 0; i < 3; ++i) std::copy_n(p.map->rows()[i].begin(), 3, linear.begin() + 3 * i);
    by_linear_part.try_emplace(std::move(linear), Family{p.map, 0, length_of(*p.map)}).first->second.vertices +=
        p.count;
    if (by_linear_part.size() > most) return std::nullopt;
  }
  std::vector<Family> families;
  for (const auto& [linear, family] : by_linear_part) families.push_back(family);
  return families;
}

}  // namespace

std::optional<Transform> common_frame(std::span<const PlacedVertices> placed) {
  auto families = families_of(placed);
  if (!families) return std::nullopt;
  const auto cost_without = [](const Family& f) { return f.vertices * f.length; };
  std::stable_sort(families->begin(), families->end(),
                   [&](const Family& a, const Family& b) { return cost_without(a) > cost_without(b); });
  constexpr std::size_t most_tried = 3, least_gain = 2;
  std::size_t least_cost = 0;
  for (const Family& f : *families) least_cost += cost_without(f);
  least_cost /= least_gain;
  std::optional<Transform> frame;
  for (std::size_t i = 0; i < std::min(most_tried, families->size()); ++i) {
    const Transform back = (*families)[i].first->inverse();
    std::size_t cost = 0;
    for (const Family& f : *families) cost += f.vertices * length_of(back * *f.first);
    if (cost >= least_cost) continue;
    least_cost = cost;
    frame = *(*families)[i].first;
  }
  return frame;
}

}  // namespace strata
