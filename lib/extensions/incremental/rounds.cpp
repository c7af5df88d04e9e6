#include "extensions/incremental/rounds.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <unordered_set>
#include <utility>

#include "core/csg/arena.h"
#include "extensions/incremental/step.h"

namespace strata {
namespace {

/// Steps in one round, at most.
constexpr std::size_t most_in_round = 16;

class Rounds {
 public:
  Rounds(FaceTree solid_in_steps, Operation operation, std::vector<ToolGroup> groups, const Options& options)
      : tree_(std::move(solid_in_steps)),
        operation_(operation),
        waiting_(std::move(groups)),
        all_(waiting_.size()),
        options_(options),
        monitor_(options.cancel, &options.progress) {}

  FaceTree take_all() {
    while (!waiting_.empty()) {
      monitor_.check();
      if (tree_.size() == 0) {
        if (operation_ == Operation::difference || operation_ == Operation::intersection) return {};
        begin();
      } else {
        take_round();
      }
      monitor_.report(1 - static_cast<double>(waiting_.size()) / static_cast<double>(all_));
    }
    return std::move(tree_);
  }

 private:
  /// The first operand is the incremental solid.
  void begin() {
    std::vector<Tool>& tools = waiting_.front().tools;
    tree_ = FaceTree(faces_of(tools.front()));
    tools.erase(tools.begin());
    if (tools.empty()) waiting_.erase(waiting_.begin());
  }

  void take_round() {
    std::vector<ToolGroup> round = chosen();
    std::size_t faces = 0;
    for (const ToolGroup& group : round)
      for (const Tool& tool : group.tools) faces += tool.solid.mesh().triangles.size();
    arena_for(options_, faces).execute([&] {
      std::vector<FaceChange> changes(round.size());
      tbb::parallel_for(std::size_t{0}, round.size(), [&](std::size_t i) {
        changes[i] = change_by(tree_, operation_, round[i], Monitor(options_.cancel));
      });
      apply(std::move(changes), std::move(round));
    });
  }

  /// Applies the changes that remove no face which an earlier one removes; the other groups wait for the next round.
  void apply(std::vector<FaceChange> changes, std::vector<ToolGroup> round) {
    std::vector<FaceChange> independent;
    std::vector<ToolGroup> again;
    std::unordered_set<const WorkFace*> removed;
    const bool is_alone = round.size() == 1;
    for (std::size_t i = 0; i < round.size(); ++i) {
      const auto is_gone = [&](const WorkFace* f) { return removed.contains(f); };
      if (std::any_of(changes[i].removed.begin(), changes[i].removed.end(), is_gone)) {
        again.push_back(std::move(round[i]));
      } else {
        if (!is_alone) removed.insert(changes[i].removed.begin(), changes[i].removed.end());
        independent.push_back(std::move(changes[i]));
      }
    }
    most_ = again.empty() ? std::min(2 * most_, most_in_round) : independent.size();
    tree_ = tree_.with(std::move(independent));
    waiting_.insert(waiting_.begin(), std::make_move_iterator(again.begin()), std::make_move_iterator(again.end()));
  }

  /// The first waiting groups that are apart from each other. The result of an intersection depends on all faces, so
  /// its steps are taken one by one.
  std::vector<ToolGroup> chosen() {
    const std::size_t most = operation_ == Operation::intersection ? 1 : most_;
    std::vector<ToolGroup> round, rest;
    for (ToolGroup& group : waiting_) {
      const auto is_near = [&](const ToolGroup& other) { return group.box.overlaps(other.box); };
      const bool is_taken = round.size() < most && std::none_of(round.begin(), round.end(), is_near);
      (is_taken ? round : rest).push_back(std::move(group));
    }
    waiting_ = std::move(rest);
    return round;
  }

  FaceTree tree_;
  const Operation operation_;
  std::vector<ToolGroup> waiting_;
  const std::size_t all_;
  const Options& options_;
  const Monitor monitor_;
  std::size_t most_ = 4;  ///< groups in the next round; fewer after conflicts, as in one large face
};

}  // namespace

FaceTree take_steps(FaceTree solid_in_steps, Operation operation, std::vector<ToolGroup> groups,
                    const Options& options) {
  return Rounds(std::move(solid_in_steps), operation, std::move(groups), options).take_all();
}

}  // namespace strata
