#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>

#include "core/kernel/input_complex.h"
#include "extensions/scene/ray_caster_data.h"
#include "extensions/scene/ray_events.h"
#include "extensions/scene/ray_line.h"
#include "extensions/scene/scene_data.h"
#include "strata/query.h"

namespace strata {
namespace {

/// The hits of least parameter so far, and some that may be so, as far as doubles decide.
class NearestHits {
 public:
  void take(FaceHit&& hit) {
    if (hit.t.lower() > limit_) return;
    const double upper = hit.t.upper();
    if (upper < limit_) limit_ = upper;
    hits_.push_back(std::move(hit));
  }
  /// All further hits beyond this parameter can be ignored.
  [[nodiscard]] double limit() const { return limit_; }

  [[nodiscard]] auto& finish() {
    const auto is_behind = [&](const FaceHit& h) { return h.t.lower() > limit_; };
    hits_.erase(std::remove_if(hits_.begin(), hits_.end(), is_behind), hits_.end());
    return hits_;
  }

 private:
  boost::container::small_vector<FaceHit, 8> hits_;
  double limit_ = HUGE_VAL;
};

template <class Ask>
void in_parallel(std::size_t count, const Ask& ask) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 64), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) ask(i);
  });
}

/// An event, and a hit that gives its position.
struct Found {
  FaceHit hit;
  std::uint32_t face = 0, solid = 0;
  Passage passage = Passage::entering;
};

RayHit exact(const RayLine& line, Found& found) {
  const Rational& t = line.exact(found.hit);
  RayHit hit{t, line.place_at(t), {}, found.face, found.solid, found.passage};
  for (std::size_t i = 0; i < 3; ++i) hit.rounded[i] = to_nearest_double(hit.place[i]);
  return hit;
}

RoundedHit rounded(const RayLine& line, Found& found) {
  const auto [t, place] = line.rounded(found.hit);
  return {t, place, found.face, found.solid, found.passage};
}

std::vector<Found> find_all(const RayCaster::Data& data, const RayLine& line) {
  std::vector<FaceHit> hits;
  data.tree.for_each_along(line.slabs(data.tree.bounds()), line.end(), [&](std::span<const std::uint32_t> faces) {
    for (const std::uint32_t f : faces) line.meet(f, [&](FaceHit&& hit) { hits.push_back(std::move(hit)); });
    return line.end();
  });
  std::vector<Found> all;
  for (const RayEvent& e : events_of(data.scene, line, hits))
    all.push_back({std::move(hits[e.hit]), e.face, e.solid, e.passage});
  return all;
}

/// A single hit in the interior of a face is an event by itself. So are hits that are no stretches, by the sum of their
/// changes. The passage after a stretch requires all events.
std::optional<Found> find_first(const RayCaster::Data& data, const RayLine& line) {
  NearestHits nearest;
  data.tree.for_each_along(line.slabs(data.tree.bounds()), line.end(), [&](std::span<const std::uint32_t> faces) {
    for (const std::uint32_t f : faces) line.meet(f, [&](FaceHit&& hit) { nearest.take(std::move(hit)); });
    return nearest.limit();
  });
  auto& hits = nearest.finish();
  if (hits.empty()) return std::nullopt;
  if (hits.size() == 1 && hits[0].is_inside)
    return Found{std::move(hits[0]), hits[0].face, input_complex_of(data.scene).operand_of_face(hits[0].face),
                 hits[0].change > 0 ? Passage::entering : Passage::leaving};
  std::vector<Found> all = find_all(data, line);
  return std::move(all.front());
}

}  // namespace

RayCaster::RayCaster(Scene scene) : data_(Shared<Data>::make(std::move(scene))) {}
const Scene& RayCaster::scene() const { return data_->scene; }

bool RayCaster::any(const Segment& segment) const {
  const RayLine line(input_complex_of(data_->scene), segment);
  bool found = false;
  data_->tree.for_each_along(line.slabs(data_->tree.bounds()), line.end(), [&](std::span<const std::uint32_t> faces) {
    for (const std::uint32_t f : faces) line.meet(f, [&](FaceHit&&) { found = true; });
    return found ? -1 : line.end();
  });
  return found;
}

std::optional<RayHit> RayCaster::first(const Ray& ray) const {
  const RayLine line(input_complex_of(data_->scene), ray);
  auto found = find_first(*data_, line);
  return found ? std::optional(exact(line, *found)) : std::nullopt;
}

std::optional<RoundedHit> RayCaster::first_rounded(const Ray& ray) const {
  const RayLine line(input_complex_of(data_->scene), ray);
  auto found = find_first(*data_, line);
  return found ? std::optional(rounded(line, *found)) : std::nullopt;
}

std::vector<RayHit> RayCaster::all(const Ray& ray) const {
  const RayLine line(input_complex_of(data_->scene), ray);
  std::vector<RayHit> hits;
  for (Found& f : find_all(*data_, line)) hits.push_back(exact(line, f));
  return hits;
}

std::vector<RoundedHit> RayCaster::all_rounded(const Ray& ray) const {
  const RayLine line(input_complex_of(data_->scene), ray);
  std::vector<RoundedHit> hits;
  for (Found& f : find_all(*data_, line)) hits.push_back(rounded(line, f));
  return hits;
}

std::vector<std::optional<RayHit>> RayCaster::first(std::span<const Ray> rays) const {
  std::vector<std::optional<RayHit>> answers(rays.size());
  in_parallel(rays.size(), [&](std::size_t i) { answers[i] = first(rays[i]); });
  return answers;
}

std::vector<std::vector<RayHit>> RayCaster::all(std::span<const Ray> rays) const {
  std::vector<std::vector<RayHit>> answers(rays.size());
  in_parallel(rays.size(), [&](std::size_t i) { answers[i] = all(rays[i]); });
  return answers;
}

void RayCaster::first_rounded(std::span<const Ray> rays, std::span<std::optional<RoundedHit>> answers) const {
  in_parallel(rays.size(), [&](std::size_t i) { answers[i] = first_rounded(rays[i]); });
}

void RayCaster::all_rounded(std::span<const Ray> rays, std::span<std::vector<RoundedHit>> answers) const {
  in_parallel(rays.size(), [&](std::size_t i) { answers[i] = all_rounded(rays[i]); });
}

void RayCaster::any(std::span<const Segment> segments, std::span<bool> answers) const {
  in_parallel(segments.size(), [&](std::size_t i) { answers[i] = any(segments[i]); });
}

}  // namespace strata
