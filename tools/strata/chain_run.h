#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "chain.h"
#include "chain_checkpoint.h"
#include "chain_document.h"
#include "chain_operands.h"
#include "common/watch.h"
#include "report.h"
#include "strata/incremental.h"
#include "strata/unit.h"

/// A chain being done: the incremental solid as it is now, and what there is to report.
class ChainRun {
 public:
  /// All must outlive this. `marks` may be empty where no checkpoint is asked for.
  ChainRun(const ChainDocument& document, const std::vector<ChainMark>& marks, const ChainSettings& chain,
           const Settings& settings, Watch& watch);

  /// The unit of all coordinates from here on, for checkpoints.
  void use_unit(strata::Unit unit) { unit_ = unit; }
  /// Where to start: a checkpoint, or the document's start.
  void begin(const ChainCheckpoint& from);
  void begin(ChainOperands& operands);

  /// Does all other steps and writes the checkpoints. When stopped it writes one more and throws strata::Cancelled,
  /// which tells about it.
  void finish(ChainOperands& operands);

  /// `cut_material` may be null.
  [[nodiscard]] strata::Solid solid(const strata::Material* cut_material) const;

  /// {start, resumed, steps, checkpoints, seconds: {evaluate, volumes, checkpoints}}.
  void add_to(Json& report) const;

 private:
  void do_step(const ChainStep& step, ChainOperands& operands, const strata::Options& options);
  [[nodiscard]] Json facts();
  void save();  ///< unless the last checkpoint is of this step

  const ChainDocument& document_;
  const std::vector<ChainMark>& marks_;
  const ChainSettings& chain_;
  const Settings& settings_;
  Watch& watch_;

  strata::IncrementalSolid solid_in_steps_;
  std::size_t done_ = 0;
  Json start_, resumed_, rows_ = Json::array();
  double evaluating_ = 0, measuring_ = 0, saving_ = 0;  // seconds
  std::size_t saves_ = 0;
  std::optional<std::size_t> saved_;  // steps done in the last checkpoint written
  strata::Unit unit_ = strata::Unit::none;
};
