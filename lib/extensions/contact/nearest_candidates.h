#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <unordered_set>

#include "extensions/contact/feature_distance.h"
#include "extensions/contact/nearest.h"

namespace strata::contact {

/// The best of the pairs of features processed so far. For one thread.
class NearestCandidates {
 public:
  explicit NearestCandidates(const InputComplex& input) : input_(input) {}

  /// Processes all features of two faces, the first one of part a.
  void look_at(std::uint32_t f, std::uint32_t g);

  /// Half of an upper bound of the least distance.
  [[nodiscard]] double half_bound() const { return half_bound_; }
  /// Requires that faces were processed. Vertices are numbered globally.
  [[nodiscard]] const Nearest& best() const { return best_; }

 private:
  struct Pair {
    MeshFeature a, b;
    friend bool operator==(const Pair&, const Pair&) = default;
  };
  struct Hash {
    std::size_t operator()(const Pair& p) const;
  };
  class Scale;

  [[nodiscard]] bool are_apart_along_best(const InputComplex::Indices& f, const InputComplex::Indices& g,
                                          const Scale& scale) const;
  [[nodiscard]] bool may_be_best(const Pair& pair, const Scale& scale) const;
  void decide(const Pair& pair);
  void offer(const Pair& pair, const Rational& squared, const RationalPoint& on_a, const RationalPoint& on_b);
  [[nodiscard]] RationalPoint position(std::uint32_t vertex) const;

  const InputComplex& input_;
  std::unordered_set<Pair, Hash> decided_;
  bool has_best_ = false;
  Nearest best_;
  double half_bound_ = HUGE_VAL;
  InputComplex::Coordinates direction_{};  ///< from a to b, with a longest component of 1
};

}  // namespace strata::contact
