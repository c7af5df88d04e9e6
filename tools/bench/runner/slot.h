#pragma once
#include <optional>
#include <utility>

#include "strata/incremental.h"
#include "strata/options.h"
#include "strata/solid.h"

namespace bench {

/// What an operation of a request left: a solid, an incremental one, or both once both were asked for.
class Slot {
 public:
  explicit Slot(strata::Solid solid) : solid_(std::move(solid)) {}
  explicit Slot(strata::IncrementalSolid solid) : incremental_(std::move(solid)) {}

  const strata::Solid& solid(const strata::Options& options) {
    if (!solid_) solid_ = incremental_->solid(options);
    return *solid_;
  }

  const strata::IncrementalSolid& incremental() {
    if (!incremental_) incremental_.emplace(*solid_);
    return *incremental_;
  }

 private:
  std::optional<strata::Solid> solid_;  ///< one of the two at least
  std::optional<strata::IncrementalSolid> incremental_;
};

}  // namespace bench
