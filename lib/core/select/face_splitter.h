#pragma once
#include <array>
#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/arrange/triangulation.h"
#include "core/select/classifier.h"
#include "core/select/covering.h"
#include "core/select/early_out.h"
#include "core/select/subdivide.h"
#include "core/winding/corner_cache.h"

namespace strata {

/// Points found while a face is subdivided, before they are in the table of points.
struct NewPoints {
  std::span<SymbolicPoint> constructed;                          ///< numbered from the end of the table; in a pool
  std::vector<std::pair<SymbolicPoint, SymbolicPoint>> equal{};  ///< pairs of names of one point
};

/// Subdivides one face and labels its pieces; used for one face after the other, so that memory is reused. For one
/// thread.
class FaceSplitter {
 public:
  /// `seeks_hidden`: hidden faces may be among those that are to be split.
  FaceSplitter(const InputComplex& input, const Classifier& classifier, const PointTable& points, bool seeks_hidden);

  /// The pieces of the face with these constraints, which are all it has.
  [[nodiscard]] SubdividedFace split(std::span<const Constraint> constraints, NewPoints& found, Pool& pool);

 private:
  /// The known facts about one region of the face.
  struct Region {
    Windings above;                     ///< winding numbers just above the face
    std::vector<std::uint32_t> covers;  ///< other coplanar faces that cover it, sorted
  };
  /// A position in the face and its region.
  struct Start {
    std::int32_t triangle = 0;
    Region region;
  };
  /// A corner on no other surface, with the winding numbers there: about the other operands, or just above the sheet of
  /// a mesh that crosses itself.
  struct FreeCorner {
    std::size_t index = 0;
    Windings windings;
  };
  /// A side with constraints and the triangle from which it was reached.
  struct Crossing {
    std::int32_t triangle;
    int side;
  };
  /// The polygons beside a constraint.
  struct Sides {
    std::size_t left = 0, right = 0;
  };
  /// The kept pieces while they are collected.
  struct Kept {
    std::vector<PointId> points;
    std::vector<PieceTriangle> triangles;
    std::vector<Cover> covers;
    std::vector<SymbolicPoint> constructed;

    void clear() {
      points.clear();
      triangles.clear();
      covers.clear();
      constructed.clear();
    }
  };

  void list_met();
  void find_free_corners();
  [[nodiscard]] bool is_one_of_the_same() const;
  void collect_whole();
  void collect_pieces(const std::optional<FreeCorner>& corner, NewPoints& found);
  void connect_names(bool simple, NewPoints& found);

  [[nodiscard]] bool is_crossed_by_one_solid() const;
  [[nodiscard]] bool fill_kept(const PathPolygons& polygons, const FreeCorner& corner);
  void spread_over(const PathPolygons& polygons, const FreeCorner& corner);
  bool triangulate(const PathPolygons* polygons);
  void spread(Start from);
  [[nodiscard]] Region across_notes(Region region, std::int32_t first_note) const;
  void cross(Region& region, std::size_t constraint, bool forward) const;
  static void cover(Region& region, std::uint32_t g, bool enters);
  void keep_covers(const Region& region);
  void judge();
  [[nodiscard]] Verdict verdict_on(const Region& r) const;
  [[nodiscard]] std::uint32_t representative(const Region& r, const Windings& below) const;
  void collect();
  [[nodiscard]] PointId number_of(std::int32_t v);

  [[nodiscard]] std::optional<FreeCorner> ask_free_corner() const;
  [[nodiscard]] std::optional<FreeCorner> ask_sheets() const;
  void remember_corners();
  [[nodiscard]] std::int32_t triangle_at_corner(std::size_t i) const;
  [[nodiscard]] Start start_inside();
  [[nodiscard]] Windings above_at(const SymbolicPoint& q, const std::vector<std::uint32_t>& covers);

  const InputComplex& input_;
  const WindingOracle& oracle_;
  const SheetWindings* sheets_;
  CornerCache<Windings> known_corners_;
  EarlyOut early_out_;
  Covering covering_;
  const Rule& rule_;
  bool self_;
  bool seeks_hidden_;
  const PointTable& points_;
  Triangulation triangulation_;

  std::uint32_t face_ = 0, operand_ = 0;
  InputComplex::Indices corners_{};
  std::span<const Constraint> constraints_;
  std::vector<std::uint32_t> met_;  ///< operands
  boost::container::static_vector<std::size_t, 3> free_corners_;
  std::vector<std::int32_t> region_of_;  ///< per triangle
  std::vector<Region> regions_;
  std::array<std::int32_t, 3> region_at_corner_{};
  std::vector<std::int32_t> region_of_polygon_;  ///< if polygons were spread over
  std::vector<std::size_t> polygon_queue_;
  std::vector<Sides> sides_;         ///< per constraint
  std::vector<Crossing> crossings_;  ///< in the order in which they were reached
  std::vector<std::int32_t> inner_;
  std::vector<Verdict> verdicts_;
  Kept kept_;
  std::vector<std::int32_t> kept_index_;  ///< per point of the triangulation
};

}  // namespace strata
