#pragma once
/// Boolean formulas about numbered operands.
#include <cstdint>
#include <span>
#include <vector>

namespace strata {

class Windings;

/// A Boolean formula over operands: a tree of terms joined by any, all or odd, each of which may be negated. An operand
/// may occur any number of times. Made bottom up, then closed; an immutable value from then on.
class Formula {
 public:
  /// any: at least one term holds; all: every one; odd: an odd number.
  enum class Join : std::uint8_t { any, all, odd };
  /// An operand or a joint of terms, as it is or negated.
  class Term;

  explicit Formula(std::uint32_t operands) : occurrences_(operands) {}

  [[nodiscard]] Term operand(std::uint32_t number) const;
  /// Joins terms of this formula, none of which was joined before. Without terms: any and odd are false, all is true.
  /// Joints that are joined alike, or by De Morgan's laws would be, become one, so that long chains are shallow.
  Term join(Join join, std::span<const Term> terms);
  /// Says which term is the whole formula. O(size).
  void close(const Term& whole);

  [[nodiscard]] std::uint32_t operands() const { return static_cast<std::uint32_t>(occurrences_.size()); }
  /// The value where a point is in the operands with a positive winding number and in no other.
  /// O(k d log k) for k such operands and joints at most d deep: what is out everywhere costs nothing.
  [[nodiscard]] bool holds(const Windings& windings) const;

  /// True when the formula has one value as soon as one operand is in, or out, whatever the others are; found without
  /// looking at how other operands occur several times. O(1).
  [[nodiscard]] bool settles(std::uint32_t operand, bool in) const {
    return settles_[2 * std::size_t{operand} + (in ? 1 : 0)];
  }

  /// Operands that matter only in that a point is in one of them or in none: each list is as good as one operand, their
  /// union. Lists of at least two, in order; an operand that occurs several times is in none. O(operands log operands).
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> unions() const;

 private:
  static constexpr std::uint32_t none = 0xffffffffu;
  struct Place {
    std::uint32_t joint = none;
    bool negated = false;
  };
  struct Joint {
    Join join = Join::any;
    std::uint32_t terms = 0;
    std::uint32_t held = 0;  ///< terms that hold where nothing is in any operand
    Place in;                ///< the joint that has this one as a term
    bool absorbed = false;   ///< by the one it is in, which has its terms
  };
  [[nodiscard]] static bool value(const Joint& joint, std::uint32_t held);
  [[nodiscard]] static bool absorbs(Join join, const Joint& term, bool negated);
  [[nodiscard]] Place resolve(Place place) const;
  [[nodiscard]] bool find_settled(std::uint32_t operand, bool in) const;

  std::vector<std::vector<Place>> occurrences_;  ///< per operand
  std::vector<Joint> joints_;                    ///< what joins them comes after terms; the last is the whole
  std::vector<bool> settles_;
};

class Formula::Term {
 public:
  [[nodiscard]] Term operator!() const { return {number_, is_operand_, !negated_}; }

 private:
  friend class Formula;
  Term(std::uint32_t number, bool is_operand, bool negated)
      : number_(number), is_operand_(is_operand), negated_(negated) {}

  std::uint32_t number_;
  bool is_operand_, negated_;
};

}  // namespace strata
