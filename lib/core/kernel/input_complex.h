#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/kernel/box.h"
#include "core/kernel/made_once.h"
#include "core/kernel/source_plane.h"
#include "strata/mesh.h"

namespace strata {

/// A vertex whose position is not its doubles: it is rational, or the intersection of planes.
struct PlacedVertex {
  std::uint32_t vertex = 0;
  const RationalPoint* rational = nullptr;
  const MeetOfPlanes* meet = nullptr;
};

/// How a vertex is given. At most one of `rational` and `meet` is not null; if both are null, its doubles are exact.
struct VertexPosition {
  const std::array<double, 3>* nearest = nullptr;  ///< the doubles nearest to it
  const RationalPoint* rational = nullptr;
  const MeetOfPlanes* meet = nullptr;
  /// The rounding error of a rational vertex, where it consists of three doubles: the vertex is the sum of `nearest`
  /// and this. Sums and halves of doubles are such vertices. Otherwise null.
  const std::array<double, 3>* remainder = nullptr;

  [[nodiscard]] bool has_doubles() const { return rational == nullptr && meet == nullptr; }
};

/// May faces of one operand meet each other elsewhere than along shared edges and vertices?
enum class SelfIntersections : bool {
  none,     ///< no: the winding numbers of every operand are 0 and 1, and only faces of different operands are compared
  possible  ///< perhaps: all faces are compared, and winding numbers are arbitrary
};

/// The input of one evaluation: points and faces of all operands under one global numbering.
/// Everything that is ever constructed is named by these numbers (see SymbolicPoint); nothing is copied.
/// Holds views: the arrays must outlive it. Reading is thread-safe.
class InputComplex {
 public:
  using Coordinates = std::array<double, 3>;
  using Indices = std::array<std::uint32_t, 3>;

  explicit InputComplex(SelfIntersections self = SelfIntersections::none) : self_(self) {}

  [[nodiscard]] bool may_self_intersect() const { return self_ == SelfIntersections::possible; }

  /// Appends the points and faces of one operand. `exact` lists the points that are rationals, by increasing index;
  /// `points` then holds their nearest doubles. Indices in `faces` are local to the operand. `bounds`: a box of the
  /// points that faces use, if one is known.
  void add(std::span<const Coordinates> points, std::span<const Indices> faces, std::span<const ExactVertex> exact = {},
           const std::optional<Box>& bounds = {});

  /// The same for an operand with source planes: `placed` lists the vertices that are not doubles, by increasing index.
  /// `planes` has the source plane of each face, or null where the plane is the one through its corners, which are
  /// doubles then.
  void add(std::span<const Coordinates> points, std::span<const Indices> faces, std::span<const PlacedVertex> placed,
           std::span<const SourcePlane* const> planes, const Box& bounds);

  /// Identifies pairs of coincident vertices: after this, `face` returns the lowest of them. Coordinates do not change.
  void identify(std::span<const std::pair<std::uint32_t, std::uint32_t>> equal);
  /// The vertex that represents this one in `face`.
  [[nodiscard]] std::uint32_t identified(std::uint32_t vertex) const { return same_.empty() ? vertex : same_[vertex]; }
  [[nodiscard]] bool has_identified() const { return !same_.empty(); }
  /// True when other vertices were identified with this one.
  [[nodiscard]] bool is_shared(std::uint32_t vertex) const { return !shared_.empty() && shared_[vertex]; }

  [[nodiscard]] std::uint32_t operand_count() const { return static_cast<std::uint32_t>(blocks_.size()); }
  [[nodiscard]] std::uint32_t vertex_count() const { return vertex_end_; }
  [[nodiscard]] std::uint32_t face_count() const { return face_end_; }

  [[nodiscard]] std::uint32_t first_vertex(std::uint32_t operand) const { return blocks_[operand].first_vertex; }
  [[nodiscard]] std::uint32_t first_face(std::uint32_t operand) const { return blocks_[operand].first_face; }
  [[nodiscard]] std::uint32_t face_count(std::uint32_t operand) const {
    return static_cast<std::uint32_t>(blocks_[operand].faces.size());
  }
  [[nodiscard]] std::span<const Coordinates> points(std::uint32_t operand) const { return blocks_[operand].points; }
  [[nodiscard]] std::span<const Indices> faces(std::uint32_t operand) const { return blocks_[operand].faces; }
  /// The box that was passed with an operand, or null.
  [[nodiscard]] const Box* bounds(std::uint32_t operand) const {
    const auto& b = blocks_[operand].bounds;
    return b ? &*b : nullptr;
  }

  [[nodiscard]] std::uint32_t operand_of_vertex(std::uint32_t vertex) const { return find<true>(vertex); }
  [[nodiscard]] std::uint32_t operand_of_face(std::uint32_t face) const { return find<false>(face); }

  /// Coordinates of a vertex: exact, or the nearest doubles if `exact(vertex)` is not null.
  [[nodiscard]] const Coordinates& vertex(std::uint32_t vertex) const {
    const Block& b = blocks_[find<true>(vertex)];
    return b.points[vertex - b.first_vertex];
  }
  /// Global vertex numbers of a face, counter-clockwise from outside.
  [[nodiscard]] Indices face(std::uint32_t face) const {
    const Block& b = blocks_[find<false>(face)];
    const Indices& t = b.faces[face - b.first_face];
    const Indices v{t[0] + b.first_vertex, t[1] + b.first_vertex, t[2] + b.first_vertex};
    return same_.empty() ? v : Indices{same_[v[0]], same_[v[1]], same_[v[2]]};
  }
  [[nodiscard]] VertexPosition place(std::uint32_t vertex) const {
    return has_rationals_ ? listed_place(vertex) : VertexPosition{&this->vertex(vertex)};
  }
  /// True when the position of a vertex is its doubles.
  [[nodiscard]] bool has_doubles(std::uint32_t vertex) const {
    if (!has_rationals_) return true;
    const Block& b = blocks_[find<true>(vertex)];
    return b.listing == nullptr || b.listing->place[vertex - b.first_vertex] == not_listed;
  }
  [[nodiscard]] bool has_doubles(const Indices& v) const {
    return !has_rationals_ || (has_doubles(v[0]) && has_doubles(v[1]) && has_doubles(v[2]));
  }
  /// The rational position of a vertex, or null when it is given by doubles or planes.
  [[nodiscard]] const RationalPoint* exact(std::uint32_t vertex) const {
    return has_rationals_ ? place(vertex).rational : nullptr;
  }
  /// A rational vertex over the least common denominator of its coordinates. O(1) from the second time on.
  [[nodiscard]] const HPoint<Integer>& homogeneous(std::uint32_t vertex) const;
  /// The planes that meet in a vertex, or null when it is given by doubles or rationals.
  [[nodiscard]] const MeetOfPlanes* meet(std::uint32_t vertex) const {
    return has_rationals_ ? place(vertex).meet : nullptr;
  }
  /// The source plane of a face, or null when it is the plane through its corners.
  [[nodiscard]] const SourcePlane* source_plane(std::uint32_t face) const {
    if (!has_planes_) return nullptr;
    const Block& b = blocks_[find<false>(face)];
    return b.planes.empty() ? nullptr : b.planes[face - b.first_face];
  }
  /// True when any face has a source plane.
  [[nodiscard]] bool has_planes() const { return has_planes_; }
  /// True when any vertex is not given by its doubles.
  [[nodiscard]] bool has_rationals() const { return has_rationals_; }

 private:
  static constexpr std::uint32_t not_listed = 0xffffffffu;
  /// Vertices that are not doubles.
  struct Listing {
    Listing(std::size_t vertices, std::size_t listed)
        : place(vertices, not_listed), remainder(listed), homogeneous(listed) {}

    std::vector<std::uint32_t> place;                   ///< in `exact` or `placed`, or none, per vertex
    std::vector<std::optional<Coordinates>> remainder;  ///< per entry: see VertexPosition
    MadeOnce<HPoint<Integer>> homogeneous;              ///< per entry that is rational
  };
  template <class Listed>
  static std::shared_ptr<const Listing> listing_of(std::span<const Coordinates> points, std::span<const Listed> listed);

  struct Block {
    std::span<const Coordinates> points;
    std::span<const Indices> faces;
    std::span<const ExactVertex> exact;
    std::span<const PlacedVertex> placed;
    std::span<const SourcePlane* const> planes;
    std::shared_ptr<const Listing> listing;  ///< if any vertex is listed
    std::uint32_t first_vertex = 0;
    std::uint32_t first_face = 0;
    std::optional<Box> bounds;
  };

  [[nodiscard]] VertexPosition listed_place(std::uint32_t vertex) const;
  void add(Block block);
  void list_operand(std::uint32_t operand);

  template <bool Vertex>
  [[nodiscard]] std::uint32_t find(std::uint32_t id) const {
    const auto first = [&](std::uint32_t o) { return Vertex ? blocks_[o].first_vertex : blocks_[o].first_face; };
    std::uint32_t o = (Vertex ? operand_at_vertex_ : operand_at_face_)[id >> stride_];
    while (o + 1 < blocks_.size() && first(o + 1) <= id) ++o;
    return o;
  }

  std::vector<Block> blocks_;
  /// Operands at every 2^stride-th number: where a search starts. The distance is smaller when there are many small
  /// operands.
  int stride_ = 6;
  std::vector<std::uint32_t> operand_at_vertex_, operand_at_face_;
  std::vector<std::uint32_t> same_;  ///< per vertex, if any are identified
  std::vector<bool> shared_;
  std::uint32_t vertex_end_ = 0;
  std::uint32_t face_end_ = 0;
  bool has_rationals_ = false;
  bool has_planes_ = false;
  SelfIntersections self_;
};

}  // namespace strata
