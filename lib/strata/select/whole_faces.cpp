#include "strata/select/whole_faces.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "strata/cells/face_blocks.h"

namespace strata {
namespace {

/// Judges faces of one operand one after the other; neighbours in number are often neighbours in space.
class FaceJudge {
 public:
  FaceJudge(const Carriers& carriers, const CellTree& cells, const Rule& rule, std::uint32_t operand, bool self)
      : carriers_(carriers),
        layers_(carriers, cells),
        corners_(carriers, layers_),
        cells_(cells),
        rule_(rule),
        operand_(operand),
        self_(self),
        faces_(carriers.faces(operand)),
        first_vertex_(carriers.first_vertex(operand)) {}

  /// Local face number `i`.
  [[nodiscard]] Verdict judge(std::uint32_t i) {
    const std::uint32_t vertex = first_vertex_ + faces_[i][0], cell = cells_.cell_of_vertex(vertex);
    if (cell == known_cell_ && (vertex == known_vertex_ || one_for_all_)) return known_;
    const bool mixed = cells_.cells()[cell].mixed;
    Windings w;
    const bool is_shared = carriers_.is_shared(vertex);
    if (self_ || is_shared) {
      const std::uint32_t face = carriers_.first_face(operand_) + i;
      w = layers_.above(face, make_point(carriers_, PointName::weighted(face, 1)), {&face, 1});
      if (!self_) w.set(operand_, 0);
    } else if (mixed) {
      w = corners_.around(vertex, operand_);
    } else {
      w = *cells_.cells()[cell].windings;
      w.set(operand_, 0);
    }
    known_ = verdict_of(w);
    if (self_ || is_shared) return known_;
    one_for_all_ = !mixed;
    known_cell_ = cell;
    known_vertex_ = vertex;
    return known_;
  }

 private:
  static constexpr std::uint32_t nobody = 0xffffffffu;

  /// From the winding numbers just above a face.
  [[nodiscard]] Verdict verdict_of(Windings& w) const {
    const bool above = rule_.inside(w);
    w.add(operand_, 1);
    return verdict(above, rule_.inside(w));
  }

  const Carriers& carriers_;
  const LocalLayers layers_;
  CornerWindings corners_;
  const CellTree& cells_;
  const Rule& rule_;
  const std::uint32_t operand_;
  const bool self_;
  const std::span<const Carriers::Indices> faces_;
  const std::uint32_t first_vertex_;
  std::uint32_t known_cell_ = nobody, known_vertex_ = nobody;
  bool one_for_all_ = false;  ///< the cell is of one operand
  Verdict known_{};
};

}  // namespace

std::vector<Verdict> judge_whole_faces(const Carriers& carriers, const CellTree& cells, const Rule& rule,
                                       const std::vector<SplitFace>& split, bool self, const Monitor& monitor) {
  std::vector<Verdict> verdicts(carriers.face_count(), Verdict::drop);
  const std::vector<FaceBlock> blocks = face_blocks(carriers);
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t n) {
    monitor.check();
    const FaceBlock& block = blocks[n];
    const std::uint32_t first = carriers.first_face(block.operand);
    FaceJudge judge(carriers, cells, rule, block.operand, self);
    auto next = std::lower_bound(split.begin(), split.end(), first + block.first,
                                 [](const SplitFace& s, std::uint32_t f) { return s.face < f; });
    for (std::uint32_t i = block.first; i < block.last; ++i) {
      if (next != split.end() && next->face == first + i) {
        ++next;
      } else {
        verdicts[first + i] = judge.judge(i);
      }
    }
  });
  return verdicts;
}

}  // namespace strata
