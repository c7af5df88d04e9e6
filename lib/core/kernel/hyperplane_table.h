#pragma once
#include <array>
#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/exact/sign.h"
#include "core/kernel/hyperplane.h"

namespace strata {

/// The position where D hyperplanes of a table meet. It lies in the hyperplanes that name it; this needs no arithmetic.
///
/// In hyperplanes of the frame, x_i = W and x_i = -W, W is larger than any number. They give corners to unbounded parts
/// of hyperplanes, which then need no cases of their own. Source of the idea: the infimaximal frames of Seel and
/// Mehlhorn 2003.
template <int D>
struct HyperplaneMeet {
  std::array<std::uint32_t, D> names{};
  bool is_far = false;          ///< a hyperplane of the frame is among the names
  std::array<Bounded, D> at{};  ///< the position; when far, the direction in which it lies: its part that grows with W

  /// The coordinates are the doubles, exactly.
  [[nodiscard]] bool is_given() const {
    if (is_far) return false;
    for (const Bounded& x : at)
      if (x.error != 0) return false;
    return true;
  }
};

/// A position as nearest doubles, and the sign of the rounding error: positive where the exact value is larger.
template <int D>
struct RoundedPoint {
  std::array<double, D> nearest{};  ///< never -0
  std::array<Sign, D> rest{};

  [[nodiscard]] bool is_exact() const {
    for (const Sign s : rest)
      if (s != Sign::zero) return false;
    return true;
  }
};

/// Hyperplanes by number, each once, and the decisions about them. Every decision is the exact sign of a determinant of
/// coefficients of at most D + 1 of them: first in doubles with bounds, then by points that are known to lie in them,
/// in double-doubles, and in integers. core/kernel/theory.md, "Hyperplanes".
template <int D>
class HyperplaneTable {
 public:
  using Point = std::array<double, D>;

  /// The number of a hyperplane, a new number if it is not in the table. O(1) expected.
  std::uint32_t add(Hyperplane<D> hyperplane) {
    return add_shared(std::make_shared<const Hyperplane<D>>(std::move(hyperplane)));
  }
  /// The same for one of another table, with the points that are noted there. Tables share common data.
  std::uint32_t adopt(const HyperplaneTable& other, std::uint32_t h);

  /// Records a point that lies in a hyperplane, exactly: where `meet` and `side` find the same points recorded, they
  /// need no arithmetic. A few points on each hyperplane suffice; further ones are left out.
  void note(std::uint32_t h, const Point& p);

  /// Its number, if it is in the table.
  [[nodiscard]] std::optional<std::uint32_t> find(const Hyperplane<D>& hyperplane) const;

  [[nodiscard]] const Hyperplane<D>& operator[](std::uint32_t h) const { return *hyperplanes_[h]; }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(hyperplanes_.size()); }

  /// x_axis = W, or x_axis = -W, where W is larger than any number.
  [[nodiscard]] static constexpr std::uint32_t frame(std::size_t axis, bool is_upper) {
    return first_of_frame + static_cast<std::uint32_t>(2 * axis) + (is_upper ? 1 : 0);
  }
  [[nodiscard]] static constexpr bool is_frame(std::uint32_t h) { return h >= first_of_frame; }

  /// Requires that the hyperplanes meet in one point.
  [[nodiscard]] HyperplaneMeet<D> meet(const std::array<std::uint32_t, D>& names) const;
  /// The same, for a point that is known: its doubles are exact.
  [[nodiscard]] static HyperplaneMeet<D> given(const std::array<std::uint32_t, D>& names, const Point& place);

  /// Which side of a hyperplane, none of the frame, a corner is on.
  [[nodiscard]] Sign side(std::uint32_t h, const HyperplaneMeet<D>& corner) const;
  /// The same for points that are not of the table.
  [[nodiscard]] Sign side(std::uint32_t h, const Point& p) const;
  [[nodiscard]] Sign side(std::uint32_t h, const RationalVector<D>& p) const;

  /// A linear form in doubles, for many points: where |form| at rounded coordinates, in any order of summation, is
  /// larger than the bound, its sign is the side. `largest` are the largest magnitudes and errors of their coordinates.
  struct FormWithin {
    std::array<double, D + 1> form{};
    double bound = 0;
  };
  [[nodiscard]] FormWithin form_within(std::uint32_t h, const std::array<Bounded, D>& largest) const;

  /// The exact position of a corner that is not far.
  [[nodiscard]] RationalVector<D> position(const HyperplaneMeet<D>& corner) const;
  /// The exact position of the common point of hyperplanes that meet in one point.
  [[nodiscard]] RationalVector<D> position(const std::array<std::uint32_t, D>& names) const;
  /// The rounded position of a corner that is not far; several times as fast as `position`.
  [[nodiscard]] RoundedPoint<D> rounded(const HyperplaneMeet<D>& corner) const;

  /// Bytes used, approximately.
  [[nodiscard]] std::size_t bytes() const;

 private:
  using Shared = std::shared_ptr<const Hyperplane<D>>;
  using Points = boost::container::small_vector<Point, 3>;

  static constexpr std::uint32_t first_of_frame = 0xffff'fff0;
  static constexpr std::size_t most_noted = 16;  ///< points of one hyperplane

  std::uint32_t add_shared(Shared hyperplane);
  [[nodiscard]] bool is_noted(std::uint32_t h, const Point& p) const;
  /// A point that is noted on all of these; nullopt for hyperplanes of the frame.
  [[nodiscard]] std::optional<Point> noted_on_all(const std::array<std::uint32_t, D>& names) const;
  /// True when noted points show that a corner lies in a hyperplane.
  [[nodiscard]] bool lies_in(std::uint32_t h, const HyperplaneMeet<D>& corner) const;

  template <class Number>
  [[nodiscard]] std::array<Number, D + 1> row(std::uint32_t h, bool is_far) const;
  /// Homogeneous coordinates, w last, of the near or the far part of a meet: the position is (near + W far) / w.
  template <class Number>
  [[nodiscard]] std::array<Number, D + 1> part(const std::array<std::uint32_t, D>& names, bool is_far) const;
  [[nodiscard]] Sign side_beyond_doubles(std::uint32_t h, const HyperplaneMeet<D>& corner) const;
  [[nodiscard]] Sign exact_side(std::uint32_t h, const HyperplaneMeet<D>& corner) const;
  [[nodiscard]] Sign exact_side(std::uint32_t h, const Point& p) const;
  /// Nullopt where integers of this type do not fit.
  template <class Int>
  [[nodiscard]] std::optional<Sign> exact_side_of_meet(std::uint32_t h, const HyperplaneMeet<D>& corner) const;

  std::vector<Shared> hyperplanes_;
  std::vector<std::array<double, D + 1>> forms_;                 ///< their coefficients as doubles, together in memory
  std::vector<Points> noted_;                                    ///< by hyperplane
  std::unordered_multimap<std::size_t, std::uint32_t> numbers_;  ///< by hash
};

extern template class HyperplaneTable<1>;
extern template class HyperplaneTable<2>;
extern template class HyperplaneTable<3>;

}  // namespace strata
