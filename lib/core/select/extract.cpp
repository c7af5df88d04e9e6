#include "core/select/extract.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <utility>

#include "core/cells/face_blocks.h"
#include "core/containers/huge_pages.h"
#include "core/exact/invariants.h"
#include "core/select/merge_pieces.h"
#include "core/select/validate.h"

namespace strata {
namespace {

constexpr std::uint32_t unused = 0xffffffffu;
using Triangle = std::array<std::uint32_t, 3>;

/// Numbers the vertices of the result.
class VertexNumbers {
 public:
  VertexNumbers(const InputComplex& input, const PointTable& points) : points_(points) {
    resize_fresh(number_, points.end(), unused);
    if (!points.has_identified() && !input.has_identified()) return;
    same_.resize(points.first());
    for (std::uint32_t v = 0; v < same_.size(); ++v) same_[v] = points.representative(input.identified(v));
  }

  /// A vertex of a whole face. Threads may use vertices at the same time.
  void use_input(std::uint32_t v) { use(same(v)); }
  /// A point that represents itself.
  void use(PointId id) { std::atomic_ref<std::uint32_t>(number_[id]).store(0, std::memory_order_relaxed); }

  /// Numbers the used vertices and lists them.
  void assign(Boundary& boundary) {
    const auto inputs = list(0, points_.first(), 0, boundary.inputs);
    list(points_.first(), points_.end(), inputs, boundary.constructed);
  }
  [[nodiscard]] std::uint32_t of_input(std::uint32_t v) const { return number_[same(v)]; }
  [[nodiscard]] std::uint32_t of(PointId id) const { return number_[id]; }

 private:
  [[nodiscard]] PointId same(std::uint32_t v) const { return same_.empty() ? v : same_[v]; }

  /// Counts per run of points, then numbers every run from where it starts.
  std::uint32_t list(PointId begin, PointId end, std::uint32_t first_number, std::vector<std::uint32_t>& used) {
    constexpr std::size_t run = 1 << 14;
    const std::size_t runs = (end - begin + run - 1) / run;
    const auto start_of = [&](std::size_t n) { return std::min<std::size_t>(end, begin + n * run); };
    std::vector<std::uint32_t> first(runs + 1, 0);
    tbb::parallel_for(std::size_t{0}, runs, [&](std::size_t n) {
      std::uint32_t count = 0;
      for (std::size_t v = start_of(n); v < start_of(n + 1); ++v) count += number_[v] != unused;
      first[n + 1] = count;
    });
    std::partial_sum(first.begin(), first.end(), first.begin());
    resize_fresh(used, first.back());
    tbb::parallel_for(std::size_t{0}, runs, [&](std::size_t n) {
      std::uint32_t k = first[n];
      for (std::size_t v = start_of(n); v < start_of(n + 1); ++v)
        if (number_[v] != unused) {
          used[k] = static_cast<std::uint32_t>(v);
          number_[v] = first_number + k++;
        }
    });
    return first_number + first.back();
  }

  const PointTable& points_;
  std::vector<std::uint32_t> number_;  ///< per point: its number in the result
  std::vector<PointId> same_;          ///< per input vertex: the one that stands for it; empty: itself
};

/// The kept whole faces, in blocks.
class WholeFaces {
 public:
  WholeFaces(const InputComplex& input, const std::vector<Verdict>& verdicts)
      : input_(input), verdicts_(verdicts), blocks_(face_blocks(input)), first_(blocks_.size() + 1, 0) {}

  /// Marks the vertices in use and counts the faces.
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
      const std::uint32_t operand = blocks_[n].operand;
      for_each_face(n, [&](std::uint32_t face, Verdict verdict, const Triangle& t) {
        Triangle r{numbers.of_input(t[0]), numbers.of_input(t[1]), numbers.of_input(t[2])};
        if (verdict == Verdict::keep_reversed) std::swap(r[0], r[2]);
        boundary.triangles[i] = r;
        boundary.sources[i++] = {operand, face};
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
    const auto faces = input_.faces(operand);
    const Verdict* verdicts = verdicts_.data() + input_.first_face(operand);
    const std::uint32_t shift = input_.first_vertex(operand);
    for (std::uint32_t i = first; i < last; ++i)
      if (verdicts[i] != Verdict::drop)
        visit(i, verdicts[i], {faces[i][0] + shift, faces[i][1] + shift, faces[i][2] + shift});
  }

  const InputComplex& input_;
  const std::vector<Verdict>& verdicts_;
  std::vector<FaceBlock> blocks_;
  std::vector<std::size_t> first_;  ///< triangle per block
};

}  // namespace

Boundary extract(const InputComplex& input, const std::vector<Verdict>& verdicts, Subdivision subdivision,
                 const Monitor& monitor) {
  merge_pieces(input, subdivision, monitor);
  const std::vector<SubdividedFace>& faces = subdivision.faces;
  VertexNumbers numbers(input, subdivision.points);
  WholeFaces whole_faces(input, verdicts);
  whole_faces.use(numbers);
  std::vector<std::size_t> first(faces.size() + 1, whole_faces.count());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    first[i + 1] = first[i] + faces[i].triangles.size();
    for (const PointId id : faces[i].points) numbers.use(id);
  }

  Boundary result{
      .inputs = {}, .constructed = {}, .triangles = {}, .sources = {}, .covers = {}, .points = PointTable(input)};
  numbers.assign(result);
  tbb::parallel_invoke([&] { resize_fresh(result.triangles, first.back()); },
                       [&] { resize_fresh(result.sources, first.back()); });
  whole_faces.write(numbers, result);
  tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t i) {
    const SubdividedFace& face = faces[i];
    const std::uint32_t operand = input.operand_of_face(face.face);
    const Source source{operand, face.face - input.first_face(operand)};
    std::size_t n = first[i];
    for (const PieceTriangle& piece : face.triangles) {
      for (std::size_t k = 0; k < 3; ++k) result.triangles[n][k] = numbers.of(face.points[piece.v[k]]);
      result.sources[n++] = source;
    }
  });
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (const Cover& c : faces[i].covers)
      result.covers.push_back({static_cast<std::uint32_t>(first[i] + c.triangle), c.face});
  result.points = std::move(subdivision.points);
  ensure("extract", [&] { return validate(input, result); });
  return result;
}

}  // namespace strata
