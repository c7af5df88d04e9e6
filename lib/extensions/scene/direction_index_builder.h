#pragma once
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "extensions/scene/direction_index.h"

namespace strata {

/// Builds a DirectionIndex.
class DirectionIndexBuilder {
 public:
  DirectionIndexBuilder(const Scene& scene, const Origin& origin, const Monitor& monitor, DirectionIndex& index)
      : scene_(scene), origin_(origin), monitor_(monitor), index_(index) {}

  void build();

 private:
  using Chart = DirectionIndex::Chart;
  using Node = DirectionIndex::Node;

  /// A face's position in a chart before the chart has a grid.
  struct Span {
    std::uint32_t face = 0;
    std::array<double, 2> lower{}, upper{};
    bool is_whole = false;  ///< its rectangle is not known: the whole domain
    float near = 0;
  };
  /// The nodes and entries of a run of grid squares.
  struct Part {
    std::vector<Node> nodes;  ///< inner ones number their quarters from the part's first
    std::vector<std::uint32_t> entries;
  };

  /// A square and its list, before it is known whether it is subdivided.
  struct Square {
    ChartSquare place;
    std::size_t node = 0;
    std::vector<std::uint32_t> entries;  ///< footprints
  };

  void find_faces_at_origin();
  [[nodiscard]] std::vector<std::vector<Span>> find_spans() const;
  [[nodiscard]] std::optional<Span> span_in(std::size_t chart, std::uint32_t face) const;
  [[nodiscard]] float nearest(std::size_t chart, std::uint32_t face) const;
  void lay_grid(Chart& chart, const std::vector<Span>& spans) const;
  static void put_footprints(Chart& chart, const std::vector<Span>& spans);
  [[nodiscard]] static std::int32_t bits_for(std::size_t faces);
  void sort_into_squares(std::size_t c) const;
  void refine(std::size_t c, std::deque<Square> squares, Part& part) const;
  [[nodiscard]] std::array<std::vector<std::uint32_t>, 4> quarter(std::size_t c, const ChartSquare& square,
                                                                  std::span<const std::uint32_t> entries) const;
  [[nodiscard]] bool reaches(std::size_t c, const Footprint& footprint, const ChartSquare& square) const;
  [[nodiscard]] bool sees(std::size_t c, std::uint32_t face, const ChartSquare& square) const;
  [[nodiscard]] std::array<ChartVector, 3> corners(std::size_t chart, std::uint32_t face) const;

  const Scene& scene_;
  const Origin& origin_;
  const Monitor& monitor_;
  DirectionIndex& index_;
  std::vector<bool> at_origin_;
};

}  // namespace strata
