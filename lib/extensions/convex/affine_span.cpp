#include "extensions/convex/affine_span.h"

#include "core/kernel/filters.h"

namespace strata::convex {
namespace {

constexpr std::uint32_t none = 0xffffffff;

bool are_collinear(const PointCloud& cloud, std::uint32_t p, std::uint32_t q, std::uint32_t r) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (cloud.orientation(p, q, r, axis) != Sign::zero) return false;
  return true;
}

/// The point of the largest size if it is suitable, otherwise the first suitable one, otherwise nullopt. Sizes affect
/// the choice; `serves` decides suitability.
template <class Size, class Serves>
std::uint32_t largest(const PointCloud& cloud, const Size& size, const Serves& serves) {
  std::uint32_t best = 0;
  double best_size = 0;
  for (std::uint32_t p = 0; p < cloud.size(); ++p) {
    const double s = size(cloud.at(p));
    if (!(s > best_size)) continue;
    best = p;
    best_size = s;
  }
  if (serves(best)) return best;
  for (std::uint32_t p = 0; p < cloud.size(); ++p)
    if (serves(p)) return p;
  return none;
}

}  // namespace

std::vector<std::uint32_t> affine_span(const PointCloud& cloud) {
  if (cloud.size() == 0) return {};
  std::uint32_t first = 0, last = 0;
  for (std::uint32_t p = 1; p < cloud.size(); ++p) {
    if (cloud.compare(p, first) == Sign::negative) first = p;
    if (cloud.compare(p, last) == Sign::positive) last = p;
  }
  if (cloud.compare(first, last) == Sign::zero) return {first};

  const Vertex& from = cloud.at(first);
  const Vertex along = cloud.at(last) - from;
  const auto area = [&](const Vertex& p) {
    const Vertex n = cross<double>(along, p - from);
    return dot<double>(n, n);
  };
  const std::uint32_t aside =
      largest(cloud, area, [&](std::uint32_t p) { return !are_collinear(cloud, first, last, p); });
  if (aside == none) return {first, last};

  const Vertex normal = cross<double>(along, cloud.at(aside) - from);
  const auto height = [&](const Vertex& p) { return std::abs(dot<double>(normal, p - from)); };
  const std::uint32_t above =
      largest(cloud, height, [&](std::uint32_t p) { return cloud.side(first, last, aside, p) != Sign::zero; });
  if (above == none) return {first, last, aside};
  return {first, last, aside, above};
}

}  // namespace strata::convex
