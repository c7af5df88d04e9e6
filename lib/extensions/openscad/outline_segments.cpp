#include "extensions/openscad/outline_segments.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <stdexcept>

#include "core/mesh/circle.h"
#include "extensions/openscad/primitives.h"

namespace strata::openscad {
namespace {

/// Numbers of parts of the edges of an outline.
using Parts = std::vector<std::uint32_t>;

class OutlineDivider {
 public:
  OutlineDivider(const Cap& cap, const LinearExtrusion& extrusion, std::uint32_t slices)
      : cap_(cap), extrusion_(extrusion), slices_(slices) {}

  [[nodiscard]] Parts parts_of(const std::vector<std::uint32_t>& loop) const {
    return by_number(lengths_of(loop), *extrusion_.segments);
  }

 private:
  /// The longest that each edge is in any layer.
  [[nodiscard]] std::vector<double> lengths_of(const std::vector<std::uint32_t>& loop) const {
    std::vector<double> lengths;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto &p = cap_.nearest[loop[i]], &q = cap_.nearest[loop[(i + 1) % loop.size()]];
      lengths.push_back(length_of(q[0] - p[0], q[1] - p[1]));
    }
    return lengths;
  }
  [[nodiscard]] double length_of(double x, double y) const {
    const auto& [sx, sy] = extrusion_.scale;
    if (sx == sy) return std::hypot(x, y) * std::max(sx, 1.0);
    double longest = 0;
    for (std::uint32_t j = 0; j <= slices_; ++j) {
      const double part = static_cast<double>(j) / slices_;
      const double turn = std::fmod(extrusion_.twist * part, 360);
      const CosineSine d = cosine_sine(turn < 0 ? turn + 360 : turn);
      longest = std::max(longest, std::hypot((x * d.cosine + y * d.sine) * (1 - (1 - sx) * part),
                                             (y * d.cosine - x * d.sine) * (1 - (1 - sy) * part)));
    }
    return longest;
  }

  /// Edges whose parts are longest are divided once more until there are `least`; those of nearly equal length
  /// together.
  static Parts by_number(const std::vector<double>& lengths, double least) {
    constexpr double nearly = 0.999;
    struct Edge {
      double part;
      std::size_t number;
      bool operator<(const Edge& other) const { return part < other.part; }
    };
    if (least > static_cast<double>(most_corners))
      throw std::length_error("an outline of more than ten million corners");
    Parts parts(lengths.size(), 1);
    std::priority_queue<Edge> longest;
    for (std::size_t i = 0; i < lengths.size(); ++i) longest.push({lengths[i], i});
    for (std::size_t count = lengths.size(); static_cast<double>(count) < least;) {
      std::vector<Edge> group;
      const double top = longest.top().part;
      while (!longest.empty() && longest.top().part > top * nearly) {
        group.push_back(longest.top());
        longest.pop();
      }
      if (group.empty()) break;
      for (const Edge& e : group) {
        ++parts[e.number];
        ++count;
        longest.push({lengths[e.number] / parts[e.number], e.number});
      }
    }
    return parts;
  }

  const Cap& cap_;
  const LinearExtrusion& extrusion_;
  std::uint32_t slices_;
};

}  // namespace

void divide_outlines(Cap& cap, const LinearExtrusion& extrusion, std::uint32_t slices) {
  if (!extrusion.segments) return;
  for (auto& loop : cap.loops) {
    const Parts parts = OutlineDivider(cap, extrusion, slices).parts_of(loop);
    std::vector<std::uint32_t> divided;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      divided.push_back(loop[i]);
      const planar::RationalPlacement p = cap.exact[loop[i]], q = cap.exact[loop[(i + 1) % loop.size()]];
      for (std::uint32_t k = 1; k < parts[i]; ++k) {
        const Rational part{Integer(k), Integer(parts[i])};
        planar::RationalPlacement between{p[0] + (q[0] - p[0]) * part, p[1] + (q[1] - p[1]) * part};
        divided.push_back(static_cast<std::uint32_t>(cap.exact.size()));
        cap.nearest.push_back({to_nearest_double(between[0]), to_nearest_double(between[1])});
        cap.exact.push_back(std::move(between));
      }
    }
    loop = std::move(divided);
  }
}

}  // namespace strata::openscad
