#pragma once
#include <compare>
#include <cstdint>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/kernel/input_complex.h"
#include "core/kernel/point.h"
#include "strata/rational.h"

namespace strata::contact {

/// Distinct points, found by name and by position: coincident names get one number.
class Places {
 public:
  explicit Places(const InputComplex& input) : input_(input) {}

  std::uint32_t number(const SymbolicPoint& name);
  [[nodiscard]] std::size_t size() const { return positions_.size(); }
  [[nodiscard]] const RationalPoint& operator[](std::uint32_t n) const { return positions_[n]; }
  [[nodiscard]] std::span<const RationalPoint> positions() const { return positions_; }  ///< by number
  [[nodiscard]] const InputComplex::Coordinates& nearest(std::uint32_t n) const { return nearest_[n]; }
  [[nodiscard]] const Point& point(std::uint32_t n) const { return points_[n]; }

 private:
  const InputComplex& input_;
  std::map<SymbolicPoint, std::uint32_t> by_name_;
  std::multimap<InputComplex::Coordinates, std::uint32_t> by_nearest_;
  std::vector<Point> points_;
  std::vector<RationalPoint> positions_;
  std::vector<InputComplex::Coordinates> nearest_;
};

}  // namespace strata::contact
