#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/spin_mutex.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "core/containers/box_sweep.h"
#include "extensions/contact/nearest.h"
#include "extensions/contact/parts.h"
#include "extensions/contact/region.h"
#include "extensions/contact/relation.h"
#include "strata/contact.h"

namespace strata::contact {
namespace {

/// Reports to a monitor how many of many tasks are done, from any thread.
class Progress {
 public:
  Progress(const Monitor& monitor, std::size_t tasks) : monitor_(monitor), tasks_(tasks) {}
  void done() {
    const std::size_t n = ++done_;
    if (n % 64 != 0 && n != tasks_) return;
    if (tbb::spin_mutex::scoped_lock lock; lock.try_acquire(mutex_))
      monitor_.report(static_cast<double>(done_.load()) / static_cast<double>(tasks_));
  }

 private:
  const Monitor& monitor_;
  std::size_t tasks_;
  std::atomic<std::size_t> done_ = 0;
  tbb::spin_mutex mutex_;
};

/// A box enlarged by half of `reach`: boxes at a distance of `reach` overlap when both are enlarged.
Box grown(Box box, double reach) {
  if (box.empty()) return box;
  constexpr double infinity = Box::infinity;
  const double half = std::nextafter(reach / 2, infinity);
  for (double& x : box.lower) x = std::nextafter(x - half, -infinity);
  for (double& x : box.upper) x = std::nextafter(x + half, infinity);
  return box;
}

}  // namespace

Assembly::Assembly(std::span<const Solid> parts) : parts_(Shared<Parts>::make(parts)) {}

std::uint32_t Assembly::size() const { return parts_->size(); }
const Solid& Assembly::part(std::uint32_t number) const { return parts_->solid(number); }

std::vector<RelatedPair> Assembly::pairs(const Monitor& monitor) const {
  std::vector<Box> boxes;
  for (std::uint32_t part = 0; part < size(); ++part) boxes.push_back(parts_->box(part));
  std::vector<RelatedPair> all;
  for (const auto& [a, b] : overlapping_pairs(boxes)) all.push_back({a, b, Relation::apart});
  Progress progress(monitor, all.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, all.size(), 1), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      monitor.check();
      all[i].relation = relation_of(*parts_, all[i].a, all[i].b, monitor);
      progress.done();
    }
  });
  std::erase_if(all, [](const RelatedPair& pair) { return pair.relation == Relation::apart; });
  return all;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> Assembly::near_pairs(double reach) const {
  std::vector<Box> boxes;
  for (std::uint32_t part = 0; part < size(); ++part) boxes.push_back(grown(parts_->box(part), reach));
  return overlapping_pairs(boxes);
}

Relation Assembly::relation(std::uint32_t a, std::uint32_t b, const Monitor& monitor) const {
  return relation_of(*parts_, a, b, monitor);
}

ContactRegion Assembly::contact_region(std::uint32_t a, std::uint32_t b, const Monitor& monitor) const {
  return region_of(*parts_, a, b, monitor);
}

Solid Assembly::overlap(std::uint32_t a, std::uint32_t b, const Options& options) const {
  if (parts_->common_box(a, b).empty()) return {};
  try {
    return combine_solids(Operation::intersection, {part(a), part(b)}, options);
  } catch (
      const InputError&) {  // a part touches itself inside of a face, which is visible where the other one comes near
    Options overlapping = options;
    overlapping.input = InputClass::overlapping;
    const auto resolved = [&](std::uint32_t p) { return Solid(part(p).exact_mesh(), overlapping); };
    return combine_solids(Operation::intersection, {resolved(a), resolved(b)}, options);
  }
}

Nearest Assembly::nearest(std::uint32_t a, std::uint32_t b, const Monitor& monitor) const {
  return nearest_of(*parts_, a, b, monitor);
}

}  // namespace strata::contact
