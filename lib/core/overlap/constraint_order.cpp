#include "core/overlap/constraint_order.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <atomic>
#include <bit>
#include <utility>

#include "core/containers/huge_pages.h"

namespace strata {
namespace {

/// Runs of neighbouring faces, so many that each run has few constraints where these are spread evenly.
class FaceRuns {
 public:
  FaceRuns(std::size_t constraints, std::uint32_t face_count) {
    constexpr std::size_t typical = 8;
    const std::size_t most = std::bit_ceil(constraints / typical + 2);
    while ((face_count >> shift_) >= most) ++shift_;
    first_.assign((face_count >> shift_) + 2, 0);
  }

  [[nodiscard]] std::size_t count() const { return first_.size() - 1; }
  [[nodiscard]] std::uint32_t first(std::size_t run) const { return first_[run]; }
  void add(std::uint32_t face) { advance(face); }
  /// Replaces the numbers of constraints by the positions at which runs start.
  void sum_up() {
    std::uint32_t sum = 0;
    for (std::uint32_t& n : first_) sum += std::exchange(n, sum);
  }
  /// The next position in the face's run; advances the start of the run.
  std::uint32_t take(std::uint32_t face) { return advance(face); }
  /// The starts before all positions were taken.
  void restore() {
    for (std::size_t run = first_.size() - 1; run > 0; --run) first_[run] = first_[run - 1];
    first_[0] = 0;
  }

 private:
  std::uint32_t advance(std::uint32_t face) {
    return std::atomic_ref<std::uint32_t>(first_[face >> shift_]).fetch_add(1, std::memory_order_relaxed);
  }

  int shift_ = 0;
  std::vector<std::uint32_t> first_;
};

}  // namespace

std::vector<ConstraintPosition> order_by_face(const std::vector<PairIntersections>& per_cell,
                                              std::uint32_t face_count) {
  std::size_t count = 0;
  for (const PairIntersections& m : per_cell) count += m.constraints.size();
  FaceRuns runs(count, face_count);
  tbb::parallel_for(std::size_t{0}, per_cell.size(), [&](std::size_t c) {
    for (const Constraint& x : per_cell[c].constraints) runs.add(x.face);
  });
  runs.sum_up();
  std::vector<ConstraintPosition> places;
  resize_fresh(places, count);
  tbb::parallel_for(std::size_t{0}, per_cell.size(), [&](std::size_t c) {
    const auto& constraints = per_cell[c].constraints;
    for (std::uint32_t i = 0; i < constraints.size(); ++i)
      places[runs.take(constraints[i].face)] = {std::uint64_t{constraints[i].face} << 32 | constraints[i].other,
                                                static_cast<std::uint32_t>(c), i};
  });
  runs.restore();
  tbb::parallel_for(std::size_t{0}, runs.count(), [&](std::size_t run) {
    tbb::parallel_sort(places.begin() + runs.first(run), places.begin() + runs.first(run + 1));
  });
  return places;
}

}  // namespace strata
