#include "extensions/scene/ray_events.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "extensions/scene/scene_data.h"

namespace strata {
namespace {

/// The events of one solid. Runs over its hits, in order, are grouped by parameter.
class SolidEvents {
 public:
  SolidEvents(const RayLine& line, std::vector<FaceHit>& hits, std::uint32_t solid)
      : line_(line), hits_(hits), solid_(solid) {}

  /// `sorted`: numbers of the solid's hits by increasing parameter.
  void find(std::span<const std::size_t> sorted, std::vector<RayEvent>& events) const {
    int stretches = 0, after = 0;
    for (const std::size_t h : sorted) {
      stretches -= hits_[h].stretch;  // stretches that began before the ray end without having begun
      after -= hits_[h].change;       // infinitely far away the winding number is zero
    }
    for (std::size_t i = 0; i < sorted.size();) {
      RayEvent event{sorted[i], hits_[sorted[i]].face, solid_, Passage::touching};
      const int stretches_before = stretches, before = after;
      std::size_t j = i;
      do {
        const FaceHit& h = hits_[sorted[j]];
        event.face = std::min(event.face, h.face);
        stretches += h.stretch;
        after += h.change;
      } while (++j < sorted.size() && compare_parameters(line_, hits_[sorted[i]], hits_[sorted[j]]) == Sign::zero);
      event.passage = passage(stretches_before > 0, before, stretches > 0, after);
      events.push_back(event);
      i = j;
    }
  }

 private:
  static Passage passage(bool is_on_before, int before, bool is_on_after, int after) {
    if (is_on_after) return Passage::along;
    if (is_on_before) return after != 0 ? Passage::entering : Passage::leaving;
    return after > before ? Passage::entering : after < before ? Passage::leaving : Passage::touching;
  }

  const RayLine& line_;
  std::vector<FaceHit>& hits_;
  std::uint32_t solid_;
};

}  // namespace

Sign compare_parameters(const RayLine& line, FaceHit& a, FaceHit& b) {
  if (a.t.upper() < b.t.lower()) return Sign::negative;
  if (b.t.upper() < a.t.lower()) return Sign::positive;
  return sign_of(line.exact(a).compare(line.exact(b)));
}

std::vector<RayEvent> events_of(const Scene& scene, const RayLine& line, std::vector<FaceHit>& hits) {
  std::vector<std::size_t> sorted(hits.size());
  std::iota(sorted.begin(), sorted.end(), std::size_t{0});
  std::vector<std::uint32_t> solid(hits.size());
  for (std::size_t i = 0; i < hits.size(); ++i) solid[i] = input_complex_of(scene).operand_of_face(hits[i].face);
  std::sort(sorted.begin(), sorted.end(), [&](std::size_t a, std::size_t b) {
    return solid[a] != solid[b] ? solid[a] < solid[b] : compare_parameters(line, hits[a], hits[b]) == Sign::negative;
  });
  std::vector<RayEvent> events;
  for (std::size_t i = 0; i < sorted.size();) {
    std::size_t j = i;
    while (j < sorted.size() && solid[sorted[j]] == solid[sorted[i]]) ++j;
    SolidEvents(line, hits, solid[sorted[i]]).find(std::span(sorted).subspan(i, j - i), events);
    i = j;
  }
  std::sort(events.begin(), events.end(), [&](const RayEvent& a, const RayEvent& b) {
    const Sign s = compare_parameters(line, hits[a.hit], hits[b.hit]);
    return s != Sign::zero ? s == Sign::negative : a.solid < b.solid;
  });
  return events;
}

}  // namespace strata
