#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/arrange/triangulation.h"
#include "core/overlap/constraint.h"
#include "extensions/complex/arrangement.h"

namespace strata::complex {

/// Divides faces and collects their pieces, under numbers that are provisional until all faces are divided.
class FaceCutter {
 public:
  FaceCutter(const InputComplex& input, const PointTable& points, const std::vector<std::uint8_t>& is_reversed)
      : input_(input), points_(points), is_reversed_(is_reversed), triangulation_(input, points) {}
  FaceCutter(const FaceCutter&) = delete;
  FaceCutter& operator=(const FaceCutter&) = delete;

  /// Adds a face without intersections.
  void keep_whole(std::uint32_t face);
  /// Divides a face by these constraints, which are all it has.
  void cut(std::span<const Constraint> constraints);

  // Points are numbered as in the table, and from its end on as in `constructed`.
  std::vector<Piece> pieces;
  std::vector<std::uint32_t> covers;
  std::vector<SidePart> side_parts;
  std::vector<SymbolicPoint> constructed;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> coplanar;

 private:
  void triangulate();
  void list_coplanar();
  void spread();
  std::pair<std::int32_t, std::vector<std::uint32_t>> place_inside();
  [[nodiscard]] bool holds(std::uint32_t g, const Point& q) const;
  [[nodiscard]] std::vector<std::uint32_t> across(std::vector<std::uint32_t> covered, std::int32_t first_note) const;
  void add_border();
  void add_side_part(std::uint32_t face, int side, std::uint32_t a, std::uint32_t b);
  void add_piece(std::uint32_t face, std::array<std::uint32_t, 3> v, const std::vector<std::uint32_t>& covered);
  [[nodiscard]] PointId number_of(std::int32_t v);

  const InputComplex& input_;
  const PointTable& points_;
  const std::vector<std::uint8_t>& is_reversed_;
  Triangulation triangulation_;

  std::uint32_t face_ = 0;
  std::span<const Constraint> constraints_;
  std::vector<std::int32_t> next_;
  std::vector<std::uint32_t> number_, coplanar_here_;
  std::vector<bool> done_;
  std::vector<std::pair<std::int32_t, std::vector<std::uint32_t>>> stack_;
};

}  // namespace strata::complex
