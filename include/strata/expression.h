#pragma once
/// Boolean expressions of solids, evaluated in one arrangement.
///
///   const Expression part = (Expression(block) | boss) -
///   holes.transformed(Transform::translation({0, 0, 1})); const Solid solid =
///   part.evaluate();
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "strata/errors.h"
#include "strata/formula.h"
#include "strata/function.h"
#include "strata/options.h"
#include "strata/shared.h"
#include "strata/solid.h"
#include "strata/transform.h"

namespace strata {

/// A Boolean expression over solids: nothing is computed before it is evaluated, and then all of it in one arrangement
/// of its solids, without any solid in between. So a chain of a thousand operations is exact without growing rationals,
/// and costs what its surfaces cost where they meet, not what its steps would. Complements are unbounded, which is
/// allowed everywhere but in what is evaluated.
///
/// An immutable value: copying is O(1), reading is thread-safe. Expressions share their parts, so an expression is
/// built in O(1) per operation; chains may be as long as memory allows (nothing here is recursive).
class Expression {
 public:
  /// A solid as an expression. The name is for texts and messages.
  Expression(Solid solid, std::string name = {});  // NOLINT(google-explicit-constructor):
                                                   // solids are expressions

  static Expression any(std::span<const Expression> terms);  ///< union; of no terms: the empty set
  static Expression all(
      std::span<const Expression> terms);  ///< intersection; throws std::invalid_argument for no terms
  static Expression odd(std::span<const Expression> terms);  ///< what is in an odd number of terms
  friend Expression operator|(const Expression& a, const Expression& b);
  friend Expression operator&(const Expression& a, const Expression& b);
  friend Expression operator-(const Expression& a, const Expression& b);
  friend Expression operator^(const Expression& a, const Expression& b);
  friend Expression operator~(const Expression& a);  ///< complement: the closure of everything else; unbounded

  /// The image under an affine map. Maps of maps are multiplied before any coordinate is touched. Placement::rounded
  /// rounds the mapped vertices of every solid below to doubles, once, after all maps; nothing checks that they bound a
  /// solid still.
  [[nodiscard]] Expression transformed(const Transform& map, Placement placement = Placement::exact) const;

  /// The same expression about other solids: `replace(solid)` takes the place of a solid, with its name and maps. It is
  /// called once for all copies of one solid. O(size in memory).
  [[nodiscard]] Expression with_solids(FunctionRef<Solid(const Solid&)> replace) const;

  /// The regularized solid, as `combine` makes it; operands are the primitives that matter, in order. Law: equal, as a
  /// point set, to evaluating step by step. Throws std::invalid_argument if it is not bounded, InputError, Cancelled,
  /// std::length_error, std::overflow_error where a mapped coordinate is beyond all doubles.
  [[nodiscard]] Solid evaluate(const Options& options = {}) const;

  /// The number of solids, counted as often as they occur. O(1).
  [[nodiscard]] std::size_t size() const;

  /// The negation normal form: an equal expression of unions and intersections in which solids alone are complemented.
  /// Its size is at most this one's, but every `odd` of n terms may make it 2^n times as large. Throws
  /// std::length_error beyond `most` solids.
  [[nodiscard]] Expression positive_form(std::size_t most = 1'000'000) const;

  /// The disjunctive normal form: an equal union of intersections of solids and complemented solids, without
  /// intersections that have a solid and its complement, or all factors of another one. May be exponentially large:
  /// throws std::length_error beyond `most` solids.
  [[nodiscard]] Expression disjunctive_form(std::size_t most = 1'000'000) const;

  /// A solid under the map that an expression puts it.
  struct Primitive {
    std::string name;
    Solid solid;  ///< not transformed
    Transform map;
    Placement placement = Placement::exact;
    bool negative = false;  ///< it occurs complemented in the positive form; below `odd`, both ways
    bool positive = false;  ///< it occurs as it is
    bool matters = true;    ///< false: the result is the same whatever this solid is. Always true in large expressions
  };
  /// The different solids, in the order of first occurrence; copies of one solid under equal maps are one. O(size).
  [[nodiscard]] std::vector<Primitive> primitives() const;

  /// The expression as a formula about its primitives, by their numbers: for sets of other kinds, one per primitive.
  /// Throws std::length_error beyond 2^32 - 2 solids.
  [[nodiscard]] Formula formula() const;

  /// A primitive by number, or its complement.
  struct Factor {
    std::uint32_t primitive = 0;
    bool negative = false;

    friend bool operator==(const Factor&, const Factor&) = default;
  };
  /// A union of intersections. The empty list is the empty set; an empty intersection in it is all of space.
  using Products = std::vector<std::vector<Factor>>;
  /// The disjunctive form as lists, short products first. Throws std::length_error beyond `most` factors.
  [[nodiscard]] Products products(std::size_t most = 1'000'000) const;

  /// With names, operators and as few parentheses as they need; `parse_expression` reads it. Solids without a name are
  /// `?`; maps are left out. O(size).
  [[nodiscard]] std::string text() const;

  struct Node;

 private:
  explicit Expression(Shared<Node> node) : node_(std::move(node)) {}
  Shared<Node> node_;
};

/// True when a point is in a union of intersections. `is_in(primitive)` is called at most once for each primitive, and
/// for none that no longer matters: an intersection ends at its first factor that does not hold, the union at its first
/// intersection that does. O(factors).
[[nodiscard]] bool is_in_products(const Expression::Products& products, FunctionRef<bool(std::uint32_t)> is_in);

/// Reads `(a - b) & (c | d) ^ ~e`. Names are letters, digits, '_' and '.'; ~ and ! bind strongest, then - and +
/// (union), then &, then ^, then |, as in C++; equal ones from left to right. `solid_of(name)` returns the solid of a
/// name, or throws std::out_of_range, as `std::map::at` does, which becomes a ParseError at that name. It is called
/// once per occurrence, from left to right. Throws ParseError for what does not follow the grammar. O(length).
[[nodiscard]] Expression parse_expression(std::string_view text, FunctionRef<Solid(const std::string&)> solid_of);

}  // namespace strata
