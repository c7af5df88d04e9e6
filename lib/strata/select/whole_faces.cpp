#include "strata/select/whole_faces.h"

#include <tbb/parallel_for.h>

namespace strata {
namespace {

/// Judges the faces whose first vertex is in one cell.
class CellJudge {
 public:
  CellJudge(const Carriers& carriers, const CellTree& cells, const Cell& cell, const Rule& rule, bool self)
      : carriers_(carriers), layers_(carriers, cells), grid_(cells.grid()), cell_(cell), rule_(rule), self_(self) {}

  void judge(const std::vector<std::uint8_t>& touched, std::vector<Verdict>& verdicts) {
    std::uint32_t operand = 0, end = 0;
    std::uint32_t known_vertex = nobody;
    Verdict known{};
    for (const CellFace& f : cell_.faces) {
      if (touched[f.face]) continue;
      if (f.face >= end) {
        operand = carriers_.operand_of_face(f.face);
        end = carriers_.first_face(operand) + carriers_.face_count(operand);
        known_vertex = nobody;
      }
      const std::uint32_t v = carriers_.faces(operand)[f.face - carriers_.first_face(operand)][0];
      if (!owns(carriers_.points(operand)[v])) continue;
      const bool reuse = !self_ && (v == known_vertex || (!cell_.mixed && known_vertex != nobody));
      if (!reuse) known = judge_face(f.face, operand, v);
      known_vertex = v;
      verdicts[f.face] = known;
    }
  }

 private:
  static constexpr std::uint32_t nobody = 0xffffffffu;

  [[nodiscard]] bool owns(const Carriers::Coordinates& p) const {
    for (int i = 0; i < 3; ++i) {
      const auto a = static_cast<std::size_t>(i);
      const std::int32_t g = grid_.at(i, p[a]);
      if (g < cell_.box.lower[a] || g >= cell_.box.upper[a]) return false;
    }
    return true;
  }

  [[nodiscard]] Verdict judge_face(std::uint32_t face, std::uint32_t operand, std::uint32_t local_vertex) const {
    Windings w;
    if (self_) {
      w = layers_.above(face, make_point(carriers_, PointName::weighted(face, 1)), {&face, 1});
    } else {
      const auto name = PointName::input(carriers_.first_vertex(operand) + local_vertex);
      w = layers_.around(make_point(carriers_, name), operand);
    }
    const bool above = rule_.inside(w);
    w.add(operand, 1);
    return verdict(above, rule_.inside(w));
  }

  const Carriers& carriers_;
  const LocalLayers layers_;
  const Grid& grid_;
  const Cell& cell_;
  const Rule& rule_;
  bool self_;
};

}  // namespace

std::vector<Verdict> judge_whole_faces(const Carriers& carriers, const CellTree& cells, const Rule& rule,
                                       const std::vector<std::uint8_t>& touched, bool self, const Monitor& monitor) {
  std::vector<Verdict> verdicts(carriers.face_count(), Verdict::drop);
  tbb::parallel_for(std::size_t{0}, cells.cells().size(), [&](std::size_t i) {
    const Cell& cell = cells.cells()[i];
    if (cell.faces.empty()) return;
    monitor.check();
    CellJudge(carriers, cells, cell, rule, self).judge(touched, verdicts);
  });
  return verdicts;
}

}  // namespace strata
