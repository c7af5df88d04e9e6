#include "strata/select/boundary.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <utility>

#include "strata/cells/face_blocks.h"
#include "strata/mesh/huge_pages.h"

namespace strata {
namespace {

constexpr std::uint32_t unused = 0xffffffffu;
using Triangle = std::array<std::uint32_t, 3>;

/// Numbers the vertices of the result.
class VertexNumbers {
 public:
  VertexNumbers(const Carriers& carriers, const PointTable& table) : table_(table), constructed_(table.size(), unused) {
    resize_fresh(input_, carriers.vertex_count(), unused);
    if (table.replaced().empty() && !carriers.has_identified()) return;
    same_.resize(carriers.vertex_count());
    std::iota(same_.begin(), same_.end(), 0u);
    for (const EqualVertices& e : table.replaced()) same_[e.a] = e.b;
    for (std::uint32_t v = 0; v < same_.size(); ++v)
      if (const std::uint32_t w = carriers.identified(v); w != v) same_[v] = same_[w];
  }

  /// Threads may use vertices at the same time.
  void use_input(std::uint32_t v) {
    std::atomic_ref<std::uint32_t>(input_[same(v)]).store(0, std::memory_order_relaxed);
  }
  /// A point of the table.
  void use(std::uint32_t id) {
    const PointName& name = table_.name(id);
    if (name.kind == PointName::Kind::input) {
      use_input(name.id[0]);
    } else {
      constructed_[id] = 0;
    }
  }
  /// Numbers the used vertices and lists them.
  void assign(Boundary& boundary) {
    assign_inputs(boundary.inputs);
    auto number = static_cast<std::uint32_t>(boundary.inputs.size());
    for (std::uint32_t i = 0; i < constructed_.size(); ++i)
      if (constructed_[i] != unused) {
        constructed_[i] = number++;
        boundary.constructed.push_back(table_.name(i));
      }
  }
  [[nodiscard]] std::uint32_t of_input(std::uint32_t v) const { return input_[same(v)]; }
  [[nodiscard]] std::uint32_t of(std::uint32_t id) const {
    const PointName& name = table_.name(id);
    return name.kind == PointName::Kind::input ? of_input(name.id[0]) : constructed_[id];
  }

 private:
  [[nodiscard]] std::uint32_t same(std::uint32_t v) const { return same_.empty() ? v : same_[v]; }

  /// Counts per run of vertices, then numbers every run from where it starts.
  void assign_inputs(std::vector<std::uint32_t>& inputs) {
    constexpr std::size_t run = 1 << 14;
    const std::size_t runs = (input_.size() + run - 1) / run;
    const auto end_of = [&](std::size_t n) { return std::min(input_.size(), (n + 1) * run); };
    std::vector<std::uint32_t> first(runs + 1, 0);
    tbb::parallel_for(std::size_t{0}, runs, [&](std::size_t n) {
      std::uint32_t count = 0;
      for (std::size_t v = n * run; v < end_of(n); ++v) count += input_[v] != unused;
      first[n + 1] = count;
    });
    std::partial_sum(first.begin(), first.end(), first.begin());
    resize_fresh(inputs, first.back());
    tbb::parallel_for(std::size_t{0}, runs, [&](std::size_t n) {
      std::uint32_t number = first[n];
      for (std::size_t v = n * run; v < end_of(n); ++v)
        if (input_[v] != unused) {
          inputs[number] = static_cast<std::uint32_t>(v);
          input_[v] = number++;
        }
    });
  }

  const PointTable& table_;
  std::vector<std::uint32_t> input_;        ///< per input vertex: its number in the result
  std::vector<std::uint32_t> same_;         ///< per input vertex: the equal one that stands for it; empty: itself
  std::vector<std::uint32_t> constructed_;  ///< per table entry
};

/// The faces that stay whole, in blocks.
class WholeFaces {
 public:
  WholeFaces(const Carriers& carriers, const std::vector<Verdict>& verdicts)
      : carriers_(carriers), verdicts_(verdicts), blocks_(face_blocks(carriers)), first_(blocks_.size() + 1, 0) {}

  /// Tells the vertices and counts the faces.
  void use(VertexNumbers& numbers) {
    for_each_block([&](std::size_t n) {
      std::uint32_t count = 0;
      for_each_face(n, [&](std::uint32_t, Verdict, const Triangle& t) {
        ++count;
        for (const std::uint32_t v : t) numbers.use_input(v);
      });
      first_[n + 1] = count;
    });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
  }
  [[nodiscard]] std::size_t count() const { return first_.back(); }

  void write(const VertexNumbers& numbers, Boundary& boundary) const {
    for_each_block([&](std::size_t n) {
      std::size_t i = first_[n];
      for_each_face(n, [&](std::uint32_t face, Verdict verdict, const Triangle& t) {
        Triangle r{numbers.of_input(t[0]), numbers.of_input(t[1]), numbers.of_input(t[2])};
        if (verdict == Verdict::keep_turned) std::swap(r[0], r[2]);
        boundary.triangles[i] = r;
        boundary.sources[i++] = face;
      });
    });
  }

 private:
  template <class Visit>
  void for_each_block(const Visit& visit) const {
    tbb::parallel_for(std::size_t{0}, blocks_.size(), visit);
  }
  template <class Visit>
  void for_each_face(std::size_t block, const Visit& visit) const {
    const auto& [operand, first, last] = blocks_[block];
    const auto faces = carriers_.faces(operand);
    const Verdict* verdicts = verdicts_.data() + carriers_.first_face(operand);
    const std::uint32_t shift = carriers_.first_vertex(operand), first_face = carriers_.first_face(operand);
    for (std::uint32_t i = first; i < last; ++i)
      if (verdicts[i] != Verdict::drop)
        visit(first_face + i, verdicts[i], {faces[i][0] + shift, faces[i][1] + shift, faces[i][2] + shift});
  }

  const Carriers& carriers_;
  const std::vector<Verdict>& verdicts_;
  std::vector<FaceBlock> blocks_;
  std::vector<std::size_t> first_;  ///< triangle per block
};

}  // namespace

Boundary gather_boundary(const Carriers& carriers, const std::vector<Verdict>& whole, const SplitFaces& split,
                         const PointTable& table) {
  VertexNumbers numbers(carriers, table);
  WholeFaces whole_faces(carriers, whole);
  whole_faces.use(numbers);
  std::vector<std::size_t> first(split.faces.size() + 1, whole_faces.count());
  for (std::size_t i = 0; i < split.faces.size(); ++i) {
    first[i + 1] = first[i] + split.faces[i].triangles.size();
    for (const std::uint32_t id : split.faces[i].ids) numbers.use(id);
  }

  Boundary result;
  numbers.assign(result);
  resize_fresh(result.triangles, first.back());
  resize_fresh(result.sources, first.back());
  whole_faces.write(numbers, result);
  tbb::parallel_for(std::size_t{0}, split.faces.size(), [&](std::size_t i) {
    const SplitFace& face = split.faces[i];
    std::size_t n = first[i];
    for (const PieceTriangle& piece : face.triangles) {
      for (std::size_t k = 0; k < 3; ++k) result.triangles[n][k] = numbers.of(face.ids[piece.v[k]]);
      result.sources[n++] = face.face;
    }
  });
  return result;
}

}  // namespace strata
