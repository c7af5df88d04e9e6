#pragma once
#include <compare>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

#include "core/kernel/carriers.h"
#include "core/kernel/point.h"
#include "strata/rational.h"

namespace strata::contact {

/// Distinct points, found by name and by place: names that are one place get one number.
class Places {
 public:
  explicit Places(const Carriers& carriers) : carriers_(carriers) {}

  std::uint32_t number(const PointName& name);
  [[nodiscard]] std::size_t size() const { return positions_.size(); }
  [[nodiscard]] const RationalPoint& operator[](std::uint32_t n) const { return positions_[n]; }
  [[nodiscard]] const Carriers::Coordinates& nearest(std::uint32_t n) const { return nearest_[n]; }
  [[nodiscard]] const Point& point(std::uint32_t n) const { return points_[n]; }

 private:
  const Carriers& carriers_;
  std::map<PointName, std::uint32_t> by_name_;
  std::multimap<Carriers::Coordinates, std::uint32_t> by_nearest_;
  std::vector<Point> points_;
  std::vector<RationalPoint> positions_;
  std::vector<Carriers::Coordinates> nearest_;
};

}  // namespace strata::contact
