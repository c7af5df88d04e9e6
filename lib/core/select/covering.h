#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/cells/windings.h"
#include "core/kernel/input_complex.h"
#include "core/kernel/point.h"
#include "core/kernel/predicates.h"
#include "core/overlap/constraint.h"
#include "core/select/rule.h"

namespace strata {

/// Winding numbers and verdicts of a face that follow from the coplanar faces that cover it, without a walk. Requires
/// solids. Where faces of an operand cover a position of the face and, counted with signs, have its orientation, the
/// operand has winding number 0 above and 1 below; with the opposite orientation, 1 above and 0 below. theory.md,
/// "Covered faces". For one thread.
class Covering {
 public:
  Covering(const InputComplex& input, const Rule& rule) : input_(input), rule_(rule) {}

  /// Starts with a face, given by all its constraints.
  void start(std::span<const Constraint> constraints);

  /// The faces coplanar with this one that it meets, by increasing number.
  [[nodiscard]] std::span<const std::uint32_t> coplanar() const { return coplanar_; }
  /// Is q, a point of this face's plane on no edge of g, inside g?
  [[nodiscard]] bool covers(std::uint32_t g, const Point& q) { return place_in(g, q) == Place::inside; }

  /// Winding numbers about the other operands just above a position with these covers, which are sorted, if these
  /// determine them all.
  [[nodiscard]] std::optional<Windings> above(std::span<const std::uint32_t> covers);
  /// True when covers at a position, sorted, show that no piece is kept there: a face of an operand before its own
  /// represents all, or the rule has one value above and below whatever the other operands are.
  [[nodiscard]] bool leaves_nothing(std::span<const std::uint32_t> covers);
  /// True when no piece is kept of the face, which meets coplanar faces only. False: not known.
  [[nodiscard]] bool hides_face();
  /// The same for a face that meets no other faces than some of these, which are coplanar with it and sorted: decided
  /// at one position of it.
  [[nodiscard]] bool hides(std::uint32_t face, std::span<const std::uint32_t> coplanar);

 private:
  /// The faces of one operand that cover a position: how many more have the same orientation than the opposite one.
  struct Sheet {
    std::uint32_t operand = 0;
    int net = 0;

    [[nodiscard]] bool is_decisive() const { return net == 1 || net == -1; }
    [[nodiscard]] int above() const { return net > 0 ? 0 : 1; }
    [[nodiscard]] int below() const { return 1 - above(); }
  };
  enum class Place : std::uint8_t { outside, border, inside };

  void begin(std::uint32_t face);
  [[nodiscard]] bool meets_coplanar_faces_only() const;
  void find_sheets(std::span<const std::uint32_t> covers);
  [[nodiscard]] Place place_in(std::uint32_t g, const Point& q);
  [[nodiscard]] bool is_beyond_box(const InputComplex::Indices& triangle, Projection projection, const Point& q) const;

  const InputComplex& input_;
  const Rule& rule_;
  std::uint32_t face_ = 0, operand_ = 0;
  std::optional<Projection> projection_;  ///< of the face, once it is needed
  std::span<const Constraint> constraints_;
  std::vector<std::uint32_t> coplanar_, covers_;
  std::vector<Sheet> sheets_;
};

}  // namespace strata
