#include "core/io/welded_pieces.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <memory>
#include <utility>

#include "core/containers/hash_index.h"
#include "core/containers/huge_pages.h"
#include "core/containers/point_hash.h"
#include "core/io/face_list.h"

namespace strata::io {
namespace {

/// Welds the points of pieces. A point is known by its number among all points of all pieces.
template <class Scalar>
class Joint {
 public:
  using Point = std::array<Scalar, 3>;

  explicit Joint(std::span<const WeldedPiece<Scalar>> pieces) : pieces_(pieces), first_{0} {
    for (const auto& piece : pieces) first_.push_back(first_.back() + piece.points.size());
  }

  std::vector<Vertex> join() {
    bits_ = std::min(most_bits, static_cast<int>(std::bit_width(count() / partition_size)));
    deal();
    resize_fresh(first_use_, count());
    tbb::parallel_for(std::size_t{0}, partitions(), [&](std::size_t i) { find_first_uses(partition(i)); });
    dealt_.reset();
    auto vertices = number_first_uses();
    tbb::parallel_for(std::size_t{0}, pieces_.size(), [&](std::size_t i) { renumber(i); });
    return vertices;
  }

 private:
  struct Dealt {
    Point point;
    std::uint32_t number;
  };
  static constexpr std::size_t partition_size = 1 << 13;
  static constexpr int most_bits = 10;

  /// The number of all points, those equal to others included.
  [[nodiscard]] std::size_t count() const { return first_.back(); }
  [[nodiscard]] std::size_t partitions() const { return std::size_t{1} << bits_; }
  [[nodiscard]] std::size_t partition_of(const Point& p) const {
    return bits_ == 0 ? 0 : static_cast<std::size_t>(hash_of(p) >> (64 - bits_));
  }
  [[nodiscard]] std::span<const Dealt> partition(std::size_t i) const {
    return {dealt_.get() + ends_[i], dealt_.get() + ends_[i + 1]};
  }

  /// A stable counting sort by partition, piece by piece in parallel.
  void deal() {
    std::vector<std::vector<std::size_t>> place(pieces_.size());
    tbb::parallel_for(std::size_t{0}, pieces_.size(), [&](std::size_t i) {
      place[i].resize(partitions());
      for (const Point& p : pieces_[i].points) ++place[i][partition_of(p)];
    });
    ends_.assign(1, 0);
    for (std::size_t k = 0; k < partitions(); ++k) {
      std::size_t end = ends_.back();
      for (auto& p : place) end += std::exchange(p[k], end);
      ends_.push_back(end);
    }
    dealt_ = std::make_unique_for_overwrite<Dealt[]>(count());
    prefer_huge_pages(dealt_.get(), count() * sizeof(Dealt));
    tbb::parallel_for(std::size_t{0}, pieces_.size(), [&](std::size_t i) {
      auto number = static_cast<std::uint32_t>(first_[i]);
      for (const Point& p : pieces_[i].points) dealt_[place[i][partition_of(p)]++] = {p, number++};
    });
  }

  /// Points are in order, so the one that is in a table is the first.
  void find_first_uses(std::span<const Dealt> points) {
    HashIndex table(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      const Point& p = points[i].point;
      const std::uint32_t first =
          table.find_or_add(hash_of(p), i, [&](std::uint32_t there) { return are_equal(points[there].point, p); });
      first_use_[points[i].number] = points[first].number;
    }
  }

  /// The vertices. After this, vertex_ has the numbers of those points that are first uses.
  std::vector<Vertex> number_first_uses() {
    std::vector<std::size_t> next(pieces_.size());
    tbb::parallel_for(std::size_t{0}, pieces_.size(), [&](std::size_t i) {
      std::size_t count = 0;
      for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) count += first_use_[k] == k;
      next[i] = count;
    });
    std::size_t total = 0;
    for (std::size_t& n : next) total += std::exchange(n, total);
    std::vector<Vertex> vertices;
    resize_fresh(vertices, total);
    resize_fresh(vertex_, count());
    tbb::parallel_for(std::size_t{0}, pieces_.size(), [&](std::size_t i) {
      std::size_t vertex = next[i];
      for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) {
        if (first_use_[k] != k) continue;
        const Point& p = pieces_[i].points[k - first_[i]];
        vertices[vertex] = {p[0], p[1], p[2]};
        vertex_[k] = static_cast<std::uint32_t>(vertex++);
      }
    });
    return vertices;
  }

  /// Numbers the points of a piece that are not first uses, and its triangles.
  void renumber(std::size_t piece) {
    const std::size_t first = first_[piece];
    for (std::size_t k = first; k < first_[piece + 1]; ++k)
      if (first_use_[k] != k) vertex_[k] = vertex_[first_use_[k]];
    for (Triangle& t : pieces_[piece].triangles)
      t = {vertex_[first + t[0]], vertex_[first + t[1]], vertex_[first + t[2]]};
  }

  std::span<const WeldedPiece<Scalar>> pieces_;
  std::vector<std::size_t> first_;  ///< number of every piece's first point, and the count
  int bits_ = 0;
  std::unique_ptr<Dealt[]> dealt_;
  std::vector<std::size_t> ends_;         ///< of the partitions in dealt_, from 0
  std::vector<std::uint32_t> first_use_;  ///< per point, the first one that equals it
  std::vector<std::uint32_t> vertex_;     ///< per point
};

bool is_flat(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

void leave_out_flat_triangles(MeshFile& file, const std::string& name) {
  const auto& triangles = file.mesh.triangles;
  if (std::none_of(triangles.begin(), triangles.end(), is_flat)) return;
  FaceList faces;
  for (const Triangle& t : triangles) faces.add(t);
  file.mesh.triangles = {};
  gather_faces({&faces, 1}, file, name);
}

}  // namespace

template <class Scalar>
MeshFile join(std::span<const WeldedPiece<Scalar>> pieces, std::vector<Triangle> triangles, const std::string& name) {
  MeshFile file;
  file.mesh.vertices = Joint<Scalar>(pieces).join();
  file.mesh.triangles = std::move(triangles);
  leave_out_flat_triangles(file, name);
  return file;
}

template MeshFile join(std::span<const WeldedPiece<float>>, std::vector<Triangle>, const std::string&);
template MeshFile join(std::span<const WeldedPiece<double>>, std::vector<Triangle>, const std::string&);

}  // namespace strata::io
