#pragma once
/// Boolean formulas about numbered operands: what `combine` evaluates in one arrangement when the four operations do
/// not do. Most callers write an Expression instead, which makes its formula itself.
///
///   Formula formula(3);  // in 0 and in 1, and not in 2
///   const std::array terms{formula.operand(0), formula.operand(1), !formula.operand(2)};
///   formula.close(formula.join(Formula::Join::all, terms));
#include <cstdint>
#include <span>
#include <vector>

namespace strata {

class Windings;  // internal: winding numbers of a point about operands

/// A Boolean formula over operands: a tree of terms joined by any, all or odd, each of which may be negated. An operand
/// may occur any number of times. Made bottom up by one thread, then closed; a value that is only read from then on, by
/// any number of threads.
class Formula {
 public:
  /// How terms are joined: any: at least one of them holds; all: every one does; odd: an odd number does.
  enum class Join : std::uint8_t { any, all, odd };
  /// An operand or a joint of terms, as it is or negated: `!term`.
  class Term;

  /// A formula about so many operands, without terms yet.
  explicit Formula(std::uint32_t operands) : occurrences_(operands) {}

  /// An operand as a term; numbers count from 0. Requires number < operands().
  [[nodiscard]] Term operand(std::uint32_t number) const;
  /// A joint of terms of this formula, none of which was joined before. Without terms: any and odd are false, all is
  /// true. A joint within a joint of the same kind, also by De Morgan's laws, becomes part of it, so that long chains
  /// are shallow. O(terms).
  Term join(Join join, std::span<const Term> terms);
  /// Declares which term is the whole formula; it has no more terms afterwards. O(size).
  void close(const Term& whole);

  [[nodiscard]] std::uint32_t operands() const { return static_cast<std::uint32_t>(occurrences_.size()); }
  /// The value at a point that is in the operands with a positive winding number and in no other. Requires a closed
  /// formula. O(k d log k) for k such operands and joints at most d deep, whatever the number of all operands.
  [[nodiscard]] bool holds(const Windings& windings) const;

  /// True only if the formula has one value wherever a point is in that operand (or is not), whatever the others are.
  /// False may be wrong where operands occur several times: it is found from one occurrence at a time. Requires a
  /// closed formula. O(1).
  [[nodiscard]] bool settles(std::uint32_t operand, bool in) const {
    return settles_[2 * std::size_t{operand} + (in ? 1 : 0)];
  }

  /// Sets of operands for which it matters only whether a point is in any of them: each could be replaced by its union.
  /// Sets of at least two, increasing; an operand that occurs several times is in none. O(operands log operands).
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
