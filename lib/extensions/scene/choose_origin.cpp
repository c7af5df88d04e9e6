#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/exact/finite.h"
#include "core/kernel/input_complex.h"
#include "extensions/scene/origin_sample.h"
#include "extensions/scene/scene_data.h"
#include "extensions/scene/sight.h"
#include "strata/query.h"

namespace strata {
namespace {

/// Is the origin on no plane of a face? Exact.
bool sees_no_face_flat(const Scene& scene, const Origin& origin) {
  const Sight sight(input_complex_of(scene), origin);
  std::atomic<bool> flat = false;
  tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, scene.face_count(), 1024), [&](const auto& range) {
    for (std::uint32_t f = range.begin(); f < range.end() && !flat.load(std::memory_order_relaxed); ++f)
      if (sight.orientation(input_complex_of(scene).face(f)) == Sign::zero) flat = true;
  });
  return !flat;
}

/// The position of least cost, the first of several, in the scene's coordinates.
InputComplex::Coordinates best_place(const OriginSample& sample) {
  std::optional<std::uint64_t> least;
  InputComplex::Coordinates best{};
  for (const auto& place : sample.places()) {
    const auto at = sample.in_scene(place);
    if (!is_finite(at)) continue;
    const std::uint64_t cost = sample.cost(place);
    if (least && *least <= cost) continue;
    least = cost;
    best = at;
  }
  return best;
}

/// Points (k, k^2, k^3) from a position, on a lattice of doubles. A plane contains at most three points of the curve,
/// so 3 n + 1 steps suffice for n planes, as long as they are exact. In nearly all cases the first ones suffice.
class Steps {
 public:
  /// The lattice is finer than the scene by 2^12, as far as doubles permit.
  Steps(const OriginSample& sample, const InputComplex::Coordinates& place)
      : unit_(std::max({sample.size_exponent() - 12, sample.exponent() - 53, -1074})) {
    for (std::size_t i = 0; i < 3; ++i) start_[i] = std::nearbyint(std::ldexp(place[i], -unit_));
  }
  [[nodiscard]] InputComplex::Coordinates at(int k) const {
    const double t = k;
    return {std::ldexp(start_[0] + t, unit_), std::ldexp(start_[1] + t * t, unit_),
            std::ldexp(start_[2] + t * t * t, unit_)};
  }

 private:
  int unit_;
  InputComplex::Coordinates start_{};
};

}  // namespace

Origin choose_origin(const Scene& scene) {
  if (scene.face_count() == 0) return Origin::point({0, 0, 0});
  const OriginSample sample(scene);
  const Steps steps(sample, best_place(sample));
  constexpr int most_steps = 1 << 16;  // while cubes are exact
  for (int i = 0; i < most_steps; ++i) {
    const Origin origin = Origin::point(steps.at(i % 2 == 0 ? -i / 2 : (i + 1) / 2));
    if (is_finite(origin.at) && sees_no_face_flat(scene, origin)) return origin;
  }
  throw std::invalid_argument("no origin found that is on no plane of a face");
}

}  // namespace strata
