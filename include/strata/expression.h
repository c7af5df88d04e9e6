#pragma once
/// Boolean expressions, evaluated in one arrangement.
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
/// of its solids, without any solid in between. So a chain of a thousand operations is exact and costs what its
/// surfaces cost where they meet, not what its steps would.
///
/// An immutable value, cheap to copy. Expressions share their parts; chains may be as long as memory allows.
class Expression {
 public:
  /// The name is for texts and messages.
  Expression(Solid solid, std::string name = {});  // NOLINT(google-explicit-constructor): solids are expressions

  static Expression any(std::span<const Expression> terms);  ///< union; of none: nothing
  static Expression all(std::span<const Expression> terms);  ///< intersection; throws std::invalid_argument for none
  static Expression odd(std::span<const Expression> terms);  ///< what is in an odd number of them
  friend Expression operator|(const Expression& a, const Expression& b);
  friend Expression operator&(const Expression& a, const Expression& b);
  friend Expression operator-(const Expression& a, const Expression& b);
  friend Expression operator^(const Expression& a, const Expression& b);
  friend Expression operator~(const Expression& a);  ///< the closure of everything else

  /// The image under an affine map. Maps of maps are multiplied before any coordinate is touched.
  [[nodiscard]] Expression transformed(const Transform& map, Placement placement = Placement::exact) const;

  /// The regularized solid. Throws std::invalid_argument if it is not bounded, Cancelled, std::length_error.
  [[nodiscard]] Solid evaluate(const Options& options = {}) const;

  /// Solids, counted as often as they occur.
  [[nodiscard]] std::size_t size() const;

  /// An equal expression in which solids alone are complemented, and of joints there are unions and intersections only.
  /// Its size is at most this one's, but for every odd joint of n terms up to 2^n times as large. Throws
  /// std::length_error beyond `most` solids.
  [[nodiscard]] Expression positive_form(std::size_t most = 1'000'000) const;

  /// An equal union of intersections of solids and complemented solids, without those that another one holds or that
  /// hold a solid and its complement. May be exponentially large: throws std::length_error beyond `most` solids.
  [[nodiscard]] Expression disjunctive_form(std::size_t most = 1'000'000) const;

  /// A solid where an expression has it.
  struct Primitive {
    std::string name;
    Solid solid;  ///< not transformed
    Transform map;
    Placement placement = Placement::exact;
    bool negative = false;  ///< complemented in the positive form; of a term of an odd joint: both occur
    bool positive = false;
    bool matters = true;  ///< false: the result is the same whatever this solid is
  };
  /// The different solids by first occurrence; the same solid under the same map is one.
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
  /// A union of intersections: no product is everything, none is nothing.
  using Products = std::vector<std::vector<Factor>>;
  /// The disjunctive form as lists, short products first. Throws std::length_error beyond `most` factors.
  [[nodiscard]] Products products(std::size_t most = 1'000'000) const;

  /// With names, operators and as few parentheses as they need. Solids without a name are `?`; maps are left out.
  [[nodiscard]] std::string text() const;

  struct Node;

 private:
  explicit Expression(Shared<Node> node) : node_(std::move(node)) {}
  Shared<Node> node_;
};

/// True when a point is in a disjunctive form. `is_in(primitive)` is asked at most once of each, and of none that does
/// not matter any more: a product ends at its first factor that does not hold, the form at its first product that does.
/// O(factors).
[[nodiscard]] bool is_in_products(const Expression::Products& products, FunctionRef<bool(std::uint32_t)> is_in);

/// Reads `(a - b) & (c | d) ^ ~e`. Names are letters, digits, '_' and '.'; ~ and ! bind strongest, then - and +
/// (union), then &, then ^, then |, as in C++; equal ones from left to right. `solid_of` gives the solid of a name, or
/// throws std::out_of_range. Throws ParseError.
[[nodiscard]] Expression parse_expression(std::string_view text, FunctionRef<Solid(const std::string&)> solid_of);

}  // namespace strata
