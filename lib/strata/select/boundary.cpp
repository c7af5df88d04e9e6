#include "strata/select/boundary.h"

#include <numeric>
#include <utility>

namespace strata {
namespace {

constexpr std::uint32_t unused = 0xffffffffu;

/// Numbers the vertices of the result.
class VertexNumbers {
 public:
  VertexNumbers(const Carriers& carriers, const PointTable& table)
      : table_(table), input_(carriers.vertex_count(), unused), same_(0), constructed_(table.names().size(), unused) {
    for (std::uint32_t i = 0; i < table.names().size(); ++i) {
      const PointName& name = table.names()[i];
      if (name.kind != PointName::Kind::input || table.representative(i) == i) continue;
      if (same_.empty()) {
        same_.resize(carriers.vertex_count());
        std::iota(same_.begin(), same_.end(), 0u);
      }
      same_[name.id[0]] = table.names()[table.representative(i)].id[0];
    }
  }

  void use_input(std::uint32_t v) { input_[same(v)] = 0; }
  void use(std::uint32_t index) {
    const std::uint32_t r = table_.representative(index);
    if (table_.names()[r].kind == PointName::Kind::input) {
      use_input(table_.names()[r].id[0]);
    } else {
      constructed_[r] = 0;
    }
  }
  /// Numbers the used vertices and lists them.
  [[nodiscard]] std::vector<PointName> assign() {
    std::vector<PointName> vertices;
    for (std::uint32_t v = 0; v < input_.size(); ++v)
      if (input_[v] != unused) {
        input_[v] = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back(PointName::input(v));
      }
    for (std::uint32_t i = 0; i < constructed_.size(); ++i)
      if (constructed_[i] != unused) {
        constructed_[i] = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back(table_.names()[i]);
      }
    return vertices;
  }
  [[nodiscard]] std::uint32_t of_input(std::uint32_t v) const { return input_[same(v)]; }
  [[nodiscard]] std::uint32_t of(std::uint32_t index) const {
    const std::uint32_t r = table_.representative(index);
    const PointName& name = table_.names()[r];
    return name.kind == PointName::Kind::input ? of_input(name.id[0]) : constructed_[r];
  }

 private:
  [[nodiscard]] std::uint32_t same(std::uint32_t v) const { return same_.empty() ? v : same_[v]; }

  const PointTable& table_;
  std::vector<std::uint32_t> input_;        ///< per input vertex: its number in the result
  std::vector<std::uint32_t> same_;         ///< per input vertex: the equal one that stands for it; empty: itself
  std::vector<std::uint32_t> constructed_;  ///< per table entry
};

}  // namespace

Boundary gather_boundary(const Carriers& carriers, const std::vector<Verdict>& whole, const SplitFaces& split,
                         const PointTable& table) {
  VertexNumbers numbers(carriers, table);
  for (std::uint32_t f = 0; f < whole.size(); ++f)
    if (whole[f] != Verdict::drop)
      for (const std::uint32_t v : carriers.face(f)) numbers.use_input(v);
  std::vector<std::vector<std::uint32_t>> indices(split.faces.size());
  for (std::size_t i = 0; i < split.faces.size(); ++i)
    for (const PointName& name : split.faces[i].points) {
      indices[i].push_back(table.index(name));
      numbers.use(indices[i].back());
    }

  Boundary result;
  result.vertices = numbers.assign();
  for (std::uint32_t f = 0; f < whole.size(); ++f) {
    if (whole[f] == Verdict::drop) continue;
    const auto v = carriers.face(f);
    std::array<std::uint32_t, 3> t{numbers.of_input(v[0]), numbers.of_input(v[1]), numbers.of_input(v[2])};
    if (whole[f] == Verdict::keep_turned) std::swap(t[0], t[2]);
    result.triangles.push_back(t);
    result.sources.push_back(f);
  }
  for (std::size_t i = 0; i < split.faces.size(); ++i)
    for (const PieceTriangle& piece : split.faces[i].triangles) {
      std::array<std::uint32_t, 3> t;
      for (std::size_t k = 0; k < 3; ++k) t[k] = numbers.of(indices[i][piece.v[k]]);
      result.triangles.push_back(t);
      result.sources.push_back(split.faces[i].face);
    }
  return result;
}

}  // namespace strata
