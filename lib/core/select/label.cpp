#include "core/select/label.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

#include "core/cells/cell_tree.h"
#include "core/cells/face_blocks.h"
#include "core/exact/invariants.h"
#include "core/exact/pace.h"
#include "core/select/validate.h"
#include "core/winding/corner_cache.h"

namespace strata {
namespace {

/// The verdict that follows from the winding numbers just above a face.
Verdict verdict_from(const Rule& rule, std::uint32_t operand, Windings w) {
  const bool above = rule.inside(w);
  w.add(operand, 1);
  return verdict(above, rule.inside(w));
}

/// At a point in the interior of a face.
Windings windings_above(const InputComplex& input, const WindingOracle& oracle, std::uint32_t face) {
  return oracle.above(face, make_point(input, SymbolicPoint::weighted(face, 1)), {&face, 1});
}

}  // namespace

Verdict label(const InputComplex& input, std::uint32_t face, const Classifier& classifier) {
  return verdict_from(classifier.rule, input.operand_of_face(face), windings_above(input, classifier.oracle, face));
}

namespace {

/// Labels the faces of one operand in order; faces with near numbers are often near in space.
class FaceJudge {
 public:
  FaceJudge(const InputComplex& input, const Classifier& classifier, std::uint32_t operand)
      : input_(input),
        oracle_(classifier.oracle),
        cells_(oracle_.cells()),
        rule_(classifier.rule),
        operand_(operand),
        self_(input.may_self_intersect()),
        faces_(input.faces(operand)),
        first_vertex_(input.first_vertex(operand)),
        known_(input.points(operand).size()) {}

  /// Local face number `i`. All faces around a vertex that meet no other surface have one verdict.
  [[nodiscard]] Verdict judge(std::uint32_t i) {
    const auto& corners = faces_[i];
    const std::uint32_t vertex = first_vertex_ + corners[0];
    if (self_) return judge_inside(i);
    if (cells_ != nullptr)
      if (const std::uint32_t cell = cells_->cell_of_vertex(vertex); !cells_->cells()[cell].mixed)
        return judge_in_region(cell);
    for (const std::uint32_t v : corners)
      if (const Verdict* known = known_.find(v)) return remember(corners, *known);
    if (input_.is_shared(vertex)) return judge_inside(i);
    return remember(corners, verdict_of(oracle_.around(make_point(input_, SymbolicPoint::input(vertex)), operand_)));
  }

 private:
  static constexpr std::uint32_t nobody = 0xffffffffu;

  /// A vertex shared with another operand may lie on its surface, so it decides nothing.
  Verdict remember(const InputComplex::Indices& corners, Verdict verdict) {
    for (const std::uint32_t v : corners)
      if (!input_.is_shared(first_vertex_ + v)) known_.remember(v, verdict);
    return verdict;
  }

  [[nodiscard]] Verdict judge_in_region(std::uint32_t cell) {
    if (cell == known_cell_) return of_known_cell_;
    Windings w = *cells_->cells()[cell].windings;
    w.set(operand_, 0);
    known_cell_ = cell;
    return of_known_cell_ = verdict_of(std::move(w));
  }

  /// Decided at a point in the interior.
  [[nodiscard]] Verdict judge_inside(std::uint32_t i) const {
    Windings w = windings_above(input_, oracle_, input_.first_face(operand_) + i);
    if (!self_) w.set(operand_, 0);
    return verdict_of(std::move(w));
  }

  [[nodiscard]] Verdict verdict_of(Windings w) const { return verdict_from(rule_, operand_, std::move(w)); }

  const InputComplex& input_;
  const WindingOracle& oracle_;
  const CellTree* cells_;
  const Rule& rule_;
  const std::uint32_t operand_;
  const bool self_;
  const std::span<const InputComplex::Indices> faces_;
  const std::uint32_t first_vertex_;
  std::uint32_t known_cell_ = nobody;
  Verdict of_known_cell_{};
  CornerCache<Verdict> known_;  ///< by local vertices
};

}  // namespace

std::vector<Verdict> label(const InputComplex& input, const Subdivision& subdivision, const Classifier& classifier,
                           const Monitor& monitor) {
  const std::vector<SubdividedFace>& subdivided = subdivision.faces;
  std::vector<Verdict> verdicts(input.face_count(), Verdict::drop);
  if (!classifier.rule.looks_around()) {
    verdicts.assign(verdicts.size(), Verdict::keep);
    for (const SubdividedFace& s : subdivided) verdicts[s.face] = Verdict::drop;
    return verdicts;
  }
  const std::vector<FaceBlock> blocks = face_blocks(input);
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t n) {
    monitor.check();
    const FaceBlock& block = blocks[n];
    const std::uint32_t first = input.first_face(block.operand);
    FaceJudge judge(input, classifier, block.operand);
    auto next = std::lower_bound(subdivided.begin(), subdivided.end(), first + block.first,
                                 [](const SubdividedFace& s, std::uint32_t f) { return s.face < f; });
    Pace pace(monitor);
    for (std::uint32_t i = block.first; i < block.last; ++i) {
      pace.step();
      if (next != subdivided.end() && next->face == first + i) {
        ++next;
      } else {
        verdicts[first + i] = judge.judge(i);
      }
    }
  });
  ensure("label", [&] { return validate(input, verdicts, subdivision); });
  return verdicts;
}

std::vector<Verdict> label(const InputComplex& input, const Subdivision& subdivision, const Rule& rule,
                           const SheetWindings& windings) {
  const Shells& patches = windings.sheets().patches();
  std::vector<Verdict> of_patch;
  for (std::uint32_t p = 0; p < patches.count; ++p) {
    Windings w;
    w.add(0, windings.above_patch(p));
    of_patch.push_back(verdict_from(rule, 0, std::move(w)));
  }
  std::vector<Verdict> verdicts(input.face_count(), Verdict::drop);
  for (std::uint32_t f = 0; f < verdicts.size(); ++f)
    if (!windings.sheets().is_subdivided(f)) verdicts[f] = of_patch[patches.of_face[f]];
  ensure("label", [&] { return validate(input, verdicts, subdivision); });
  return verdicts;
}

}  // namespace strata
