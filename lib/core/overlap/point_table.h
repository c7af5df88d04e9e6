#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/kernel/point.h"
#include "strata/options.h"

namespace strata {

/// The number of a point: input vertices have their own, constructed points follow.
using PointId = std::uint32_t;

/// All points of an evaluation, each constructed one once. Reading is thread-safe. The input must outlive it.
class PointTable {
 public:
  /// Starts with the input vertices.
  explicit PointTable(const InputComplex& input) : input_(&input) {}

  /// Numbers of symbolic points. New names are numbered in the order of their first occurrence, and their coordinates
  /// are computed. O(n + size), in parallel; the same for any number of threads.
  std::vector<PointId> add(std::span<const SymbolicPoint> names, const Monitor& monitor);

  /// Identifies coincident points: after this one number represents them, the lowest, which is an input vertex if there
  /// is one.
  void identify(std::span<const std::pair<PointId, PointId>> equal);
  /// Pairs of coincident points among these: exact, whatever their names are. O(n log n), in parallel.
  [[nodiscard]] std::vector<std::pair<PointId, PointId>> equal_positions(std::vector<PointId> ids,
                                                                         const Monitor& monitor) const;
  [[nodiscard]] PointId representative(PointId id) const { return same_.empty() ? id : same_[id]; }
  [[nodiscard]] bool has_identified() const { return !same_.empty(); }

  /// One more than the last number.
  [[nodiscard]] PointId end() const { return first() + static_cast<PointId>(constructed_.size()); }
  /// The number of the first constructed point.
  [[nodiscard]] PointId first() const { return input_->vertex_count(); }
  [[nodiscard]] bool is_input(PointId id) const { return id < first(); }
  [[nodiscard]] SymbolicPoint name(PointId id) const {
    return is_input(id) ? SymbolicPoint::input(id) : constructed(id).name;
  }
  [[nodiscard]] Point point(PointId id) const {
    return is_input(id) ? make_point(*input_, SymbolicPoint::input(id)) : constructed(id);
  }
  /// Requires a constructed point.
  [[nodiscard]] const Point& constructed(PointId id) const { return constructed_[id - first()]; }
  /// All constructed points, by number.
  [[nodiscard]] std::span<const Point> constructed() const { return constructed_; }

 private:
  const InputComplex* input_;
  std::vector<Point> constructed_;
  std::vector<PointId> same_;  ///< if any were identified
};

}  // namespace strata
