#pragma once
#include <cstdint>
#include <vector>

#include "extensions/scene/ray_line.h"
#include "strata/query.h"

namespace strata {

/// All hits of one solid at one parameter.
struct RayEvent {
  std::size_t hit = 0;     ///< number of one of them
  std::uint32_t face = 0;  ///< the lowest
  std::uint32_t solid = 0;
  Passage passage = Passage::entering;
};

/// Sign of the difference of two hits' parameters. Exact.
[[nodiscard]] Sign compare_parameters(const RayLine& line, FaceHit& a, FaceHit& b);

/// The events of a ray, given all its hits, by increasing parameter, equal ones by solid. O(n log n) comparisons for n
/// hits.
[[nodiscard]] std::vector<RayEvent> events_of(const Scene& scene, const RayLine& line, std::vector<FaceHit>& hits);

}  // namespace strata
