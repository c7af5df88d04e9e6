#include "strata/select/whole_faces.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace strata {
namespace {

/// Judges faces one after the other; neighbours in number are often neighbours in space.
class FaceJudge {
 public:
  FaceJudge(const Carriers& carriers, const CellTree& cells, const Rule& rule, bool self)
      : carriers_(carriers), layers_(carriers, cells), cells_(cells), rule_(rule), self_(self) {}

  /// Local face number `i` of an operand.
  [[nodiscard]] Verdict judge(std::uint32_t operand, std::uint32_t i) {
    const std::uint32_t face = carriers_.first_face(operand) + i, cell = cells_.cell_of_face(face);
    const std::uint32_t vertex = carriers_.faces(operand)[i][0];
    const bool mixed = cells_.cells()[cell].mixed;
    if (!self_ && operand == known_operand_ && cell == known_cell_ && (!mixed || vertex == known_vertex_)) return known_;
    Windings w;
    if (self_) {
      w = layers_.above(face, make_point(carriers_, PointName::weighted(face, 1)), {&face, 1});
    } else if (mixed) {
      const auto name = PointName::input(carriers_.first_vertex(operand) + vertex);
      w = layers_.around(make_point(carriers_, name), operand);
    } else {
      w = *cells_.cells()[cell].windings;
      w.set(operand, 0);
    }
    known_ = verdict_of(w, operand);
    known_operand_ = operand;
    known_cell_ = cell;
    known_vertex_ = vertex;
    return known_;
  }

 private:
  static constexpr std::uint32_t nobody = 0xffffffffu;

  /// From the winding numbers just above a face.
  [[nodiscard]] Verdict verdict_of(Windings& w, std::uint32_t operand) const {
    const bool above = rule_.inside(w);
    w.add(operand, 1);
    return verdict(above, rule_.inside(w));
  }

  const Carriers& carriers_;
  const LocalLayers layers_;
  const CellTree& cells_;
  const Rule& rule_;
  bool self_;
  std::uint32_t known_operand_ = nobody, known_cell_ = nobody, known_vertex_ = nobody;
  Verdict known_{};
};

}  // namespace

std::vector<Verdict> judge_whole_faces(const Carriers& carriers, const CellTree& cells, const Rule& rule,
                                       const std::vector<std::uint8_t>& touched, bool self, const Monitor& monitor) {
  std::vector<Verdict> verdicts(carriers.face_count(), Verdict::drop);
  for (std::uint32_t operand = 0; operand < carriers.operand_count(); ++operand) {
    const std::uint32_t first = carriers.first_face(operand);
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, carriers.face_count(operand), 1 << 12),
                      [&](const auto& range) {
                        monitor.check();
                        FaceJudge judge(carriers, cells, rule, self);
                        for (std::uint32_t i = range.begin(); i != range.end(); ++i)
                          if (!touched[first + i]) verdicts[first + i] = judge.judge(operand, i);
                      });
  }
  return verdicts;
}

}  // namespace strata
