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

/// What the coplanar faces that cover a face tell about it without a walk. Requires solids: where faces of one of them
/// cover a place and, counted with signs, look the way the face does, it has winding number 0 above and 1 below; where
/// they look the other way, 1 above and 0 below. theory.md, "Covered faces". For one thread.
class Covering {
 public:
  Covering(const InputComplex& input, const Rule& rule) : input_(input), rule_(rule) {}

  /// Looks at a face by all its constraints.
  void start(std::span<const Constraint> constraints);

  /// The faces coplanar with this one that it meets, by increasing number.
  [[nodiscard]] std::span<const std::uint32_t> coplanar() const { return coplanar_; }
  /// Is q, a point of this face's plane on no edge of g, inside g?
  [[nodiscard]] bool covers(std::uint32_t g, const Point& q) { return place_in(g, q) == Place::inside; }

  /// Winding numbers about the other operands just above a place with these covers, which are sorted, if they tell all.
  [[nodiscard]] std::optional<Windings> above(std::span<const std::uint32_t> covers);
  /// True when covers at a place, sorted, tell that nothing stays there: a face of an operand before its own speaks for
  /// all, or the rule has one value above and below whatever the other operands do.
  [[nodiscard]] bool leaves_nothing(std::span<const std::uint32_t> covers);
  /// True when nothing stays of a face that meets coplanar faces only, as one place of it tells. False: not known.
  [[nodiscard]] bool hides_face();

 private:
  /// The faces of one operand that cover a place: how many more look the same way than the other.
  struct Sheet {
    std::uint32_t operand = 0;
    int net = 0;

    [[nodiscard]] bool tells() const { return net == 1 || net == -1; }
    [[nodiscard]] int above() const { return net > 0 ? 0 : 1; }
    [[nodiscard]] int below() const { return 1 - above(); }
  };
  enum class Place : std::uint8_t { outside, border, inside };

  [[nodiscard]] bool meets_coplanar_faces_only() const;
  void find_sheets(std::span<const std::uint32_t> covers);
  [[nodiscard]] Place place_in(std::uint32_t g, const Point& q);
  [[nodiscard]] bool is_beyond_box(const InputComplex::Indices& triangle, Projection projection, const Point& q) const;

  const InputComplex& input_;
  const Rule& rule_;
  std::uint32_t face_ = 0, operand_ = 0;
  std::optional<Projection> projection_;  ///< of the face, once it was needed
  std::span<const Constraint> constraints_;
  std::vector<std::uint32_t> coplanar_, covers_;
  std::vector<Sheet> sheets_;
};

}  // namespace strata
