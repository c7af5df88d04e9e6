#pragma once
#include <cstdint>
#include <span>
#include <string>

#include "scene_input.h"
#include "strata/query.h"

/// How many rays there were, how many of them met a solid, and rows about hits.
struct RayCounts {
  std::uint64_t rays = 0, meeting = 0, hits = 0;
};

/// Answers rays and writes rows about them: the number of the ray, the number of the hit along it (both from 0), the
/// place and the parameter along the direction as the shortest digits of the nearest doubles, solid, face, passage. A
/// ray that meets nothing has one row, which is empty but for its number.
class HitTable {
 public:
  /// What a row is made for and from.
  struct Form {
    bool all = false;    ///< all hits, not the first only
    bool exact = false;  ///< four more columns: the place and the parameter as rationals
  };

  /// Keeps references.
  HitTable(const strata::RayCaster& caster, const SceneInput& input, Form form)
      : caster_(caster), input_(input), form_(form) {}

  [[nodiscard]] std::string header() const;
  /// Appends the rows of a ray, and counts them. Safe to call from many threads.
  void append_rows(std::uint64_t number, const strata::Ray& ray, std::string& rows, RayCounts& counts) const;

 private:
  void append_row(std::uint64_t number, std::uint64_t hit, const strata::RoundedHit& h, std::string& rows) const;
  void append_exact(std::uint64_t number, const strata::Ray& ray, std::string& rows, RayCounts& counts) const;

  const strata::RayCaster& caster_;
  const SceneInput& input_;
  Form form_;
};
