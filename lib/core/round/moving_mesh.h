#pragma once
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "core/containers/box_cover.h"
#include "core/kernel/box.h"
#include "core/kernel/grid_rounding.h"
#include "core/mesh/edge_table.h"
#include "core/overlap/embedded_stars.h"
#include "strata/mesh.h"

namespace strata {

/// A vertex that goes to another place, and perhaps becomes another vertex.
struct VertexMove {
  std::uint32_t vertex = 0;
  std::uint32_t becomes = 0;  ///< itself, or the vertex that takes its place in all triangles
  Vertex to{};                ///< its new place; that of `becomes`
  double way = 0;             ///< at least the distance, in the maximum norm
};

/// The way of a vertex to the grid. `is_rounded`: it is not where its doubles are, but nearest to them.
[[nodiscard]] VertexMove move_to_grid(std::uint32_t vertex, const Vertex& at, bool is_rounded, const GridRounding& grid,
                                      int bits_less = 0);

/// Triangles a b c and b a d become a d c and d b c: what the first covers beside the segment a b goes there.
struct FlatFlip {
  std::uint32_t cap = 0, base = 0;  ///< the two triangles
  std::uint32_t corner = 0;         ///< where c is in the first
  double way = 0;                   ///< at least the distance from c to the segment a b
};

/// A triangle that is part of another.
struct PartOfTriangle {
  Triangle corners{};
  std::uint32_t of = 0;
};

/// The box of a triangle.
[[nodiscard]] inline Box box_of(MeshView mesh, std::uint32_t triangle) {
  Box box;
  for (const std::uint32_t v : mesh.triangles[triangle]) box.include(mesh.vertices[v]);
  return box;
}

/// A closed chain of triangles on its way to a grid. Triangles are changed in place; those that repeat a vertex are no
/// longer there. It remembers which were changed, and where the surface passed on its way: elsewhere, winding numbers
/// are those of the start.
class MovingMesh {
 public:
  /// Per triangle: the face of the exact boundary that it is part of, and how far it is from that boundary at most.
  MovingMesh(Mesh mesh, std::vector<std::uint32_t> source_face, std::vector<double> moved);
  /// The exact boundary itself, of which every vertex is at its nearest doubles. Refers to the mesh; it is copied when
  /// something of it changes.
  explicit MovingMesh(MeshView boundary) : boundary_(boundary), swept_(std::in_place) {}

  [[nodiscard]] MeshView mesh() const { return boundary_ ? *boundary_ : MeshView(mesh_); }
  /// Nothing has changed yet but how far vertices are from the exact ones.
  [[nodiscard]] bool is_as_given() const { return boundary_.has_value(); }
  [[nodiscard]] bool is_left(std::uint32_t face) const { return !repeats_vertex(mesh().triangles[face]); }
  [[nodiscard]] Box box(std::uint32_t face) const { return box_of(mesh(), face); }

  /// Triangles that are left and meet some boxes, by increasing number. O(n) in parallel; after a search of all of
  /// them, most are passed over in runs where triangles that follow each other are near each other.
  [[nodiscard]] std::vector<std::uint32_t> faces_that_meet(const BoxCover& boxes) const;

  /// At most one move per vertex, by increasing vertex; what a vertex becomes does not move. Once `swept` is
  /// everywhere, a vertex that becomes one in the same place changes no triangle. O(n), in parallel.
  void move(std::span<const VertexMove> moves);
  /// Each triangle in one flip at most.
  void flip(std::span<const FlatFlip> flips);
  /// Takes pairs of triangles out that have the same vertices, the one the reverse of the other.
  void cancel(std::span<const std::pair<std::uint32_t, std::uint32_t>> opposites);

  /// Replaces some triangles by others with the same boundary, such that a box around all of them contains what is
  /// between. `way`: at least the distance of any point of the new ones from the former.
  void replace(std::span<const std::uint32_t> faces, std::span<const Triangle> by, double way);
  /// Some triangles are taken out, and parts of some of them are put in, such that the mesh bounds a solid. As far as
  /// vertices are where they should be: from here on, winding numbers are compared with those of this solid.
  void resolve(std::span<const std::uint32_t> gone, std::span<const PartOfTriangle> parts);
  /// A vertex that no triangle has yet.
  std::uint32_t add_vertex(const Vertex& at);

  /// Triangles that were changed since the start, by increasing number; if all of it moved, since the last search.
  [[nodiscard]] const std::vector<std::uint32_t>& changed() const { return changed_; }
  /// Boxes of all that the surface passed; none if that is everywhere.
  [[nodiscard]] const std::optional<std::vector<Box>>& swept() const { return swept_; }
  /// Edges, from the lower to the higher vertex, that triangles no longer have without a move of a vertex, as long as
  /// boxes are kept.
  [[nodiscard]] const std::set<std::pair<std::uint32_t, std::uint32_t>>& lost_sides() const { return lost_sides_; }
  /// How far changed triangles are from the exact boundary at most; of a mesh as it was given.
  [[nodiscard]] const std::vector<double>& moved_of_changed() const { return moved_; }
  /// All triangles were searched for intersections, and these have some.
  void set_searched(const std::vector<std::uint32_t>& wrong);
  /// The same, and these stars are embedded; vertices in one place are one there.
  void set_searched(const std::vector<std::uint32_t>& wrong, EmbeddedStars stars);
  /// Of those, the ones where nothing changed since; none if there was no such search, or `swept` is kept.
  [[nodiscard]] const std::optional<EmbeddedStars>& stars() const { return stars_; }

  /// The mesh as it is, without triangles that are no longer there and, if there are vertices that became others,
  /// without vertices that no triangle has.
  struct Parts {
    Mesh mesh;
    std::vector<std::uint32_t> source_face;
    std::vector<double> moved;
  };
  [[nodiscard]] Parts take() &&;

 private:
  void copy_given();
  void forget_stars(const Triangle& at);
  void include_in_run(std::uint32_t face);
  void add_changed(std::vector<std::uint32_t> faces);
  void lose_side(std::uint32_t a, std::uint32_t b);

  std::optional<MeshView> boundary_;  ///< in place of `mesh_` and `source_face_`, as long as nothing changed
  Mesh mesh_;
  std::vector<std::uint32_t> source_face_;
  std::vector<double> moved_;  ///< of every triangle; with `boundary_`, of the changed ones
  std::vector<std::uint32_t> changed_;
  std::optional<std::vector<Box>> swept_;
  std::optional<EmbeddedStars> stars_;  ///< since the last search, if `swept_` is everywhere
  std::vector<Box>
      runs_;  ///< around triangles that follow each other and are left; none before a search of all of them
  bool has_unused_ = false;  ///< vertices that triangles had
  std::set<std::pair<std::uint32_t, std::uint32_t>> lost_sides_;
};

}  // namespace strata
