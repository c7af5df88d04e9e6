#include "core/round/flip_caps.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "core/containers/collect.h"
#include "core/round/distances.h"
#include "strata/rational.h"

namespace strata {
namespace {

using Index = std::uint32_t;

/// A face that lies within some units of one of its sides.
struct Cap {
  Index face = 0, corner = 0;  ///< the corner that is near the other corners' side
  double foot = 0;             ///< where it is nearest to that side: between 0 at the next corner and 1
};

/// The line through two points, in doubles.
class Line {
 public:
  Line(const Vertex& a, const Vertex& b) : a_(a), b_(b), scale_(distance(a, b)) {
    for (std::size_t i = 0; i < 3; ++i) square_ += scaled(b, i) * scaled(b, i);
  }
  [[nodiscard]] bool is_valid() const { return scale_ > 0 && std::isfinite(scale_); }
  /// Where the point of the line is that is nearest to p: 0 at the first point, 1 at the second.
  [[nodiscard]] double foot(const Vertex& p) const {
    double along = 0;
    for (std::size_t i = 0; i < 3; ++i) along += scaled(p, i) * scaled(b_, i);
    return along / square_;
  }
  [[nodiscard]] bool is_within(const Vertex& p, double reach) const {
    const double t = foot(p);
    Vertex at;
    for (std::size_t i = 0; i < 3; ++i) at[i] = a_[i] + t * (b_[i] - a_[i]);
    return distance(p, at) <= reach;
  }

 private:
  /// Keeps squares from overflow and underflow.
  [[nodiscard]] double scaled(const Vertex& p, std::size_t i) const { return (p[i] - a_[i]) / scale_; }

  Vertex a_, b_;
  double scale_, square_ = 0;
};

double length(const Vertex& a, const Vertex& b) { return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]); }

/// At least the distance from p to the point a + t (b - a), in the maximum norm.
double distance_to(const Vertex& p, const Vertex& a, const Vertex& b, double t) {
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational from = to_rational(a[i]), to = to_rational(b[i]);
    const Rational way = abs(Rational(to_rational(p[i]) - from - to_rational(t) * (to - from)));
    largest = std::max(largest, std::nextafter(to_nearest_double(way), Box::infinity));
  }
  return largest;
}

class CapFlips {
 public:
  enum class Which { all, shorter_in_bundles };

  CapFlips(MovingMesh& mesh, const GridRounding& grid, double reach)
      : mesh_(mesh), grid_(grid), reach_(reach), is_covered_(mesh.mesh().vertices.size(), false) {}

  /// Flips caps among some faces, each face in one flip at most. Returns the neighbours with which they were flipped.
  std::vector<Index> flip(std::span<const Index> faces, Which which) {
    const CapsBySide caps = caps_by_side(faces);
    if (caps.empty()) return {};
    std::vector<FlatFlip> flips;
    std::vector<bool> is_taken(triangles().size(), false);
    for (const Index base : faces_with_sides(caps))
      for (std::size_t k = 0; k < 3; ++k) {
        const Triangle& t = triangles()[base];
        const auto found = caps.find({t[k], t[(k + 1) % 3]});
        if (found == caps.end()) continue;
        for (const Cap& cap : found->second) {
          if (is_taken[base] || is_taken[cap.face]) continue;
          const Index tip = triangles()[cap.face][cap.corner], other_tip = t[(k + 2) % 3];
          if (tip == other_tip) continue;
          if (which == Which::shorter_in_bundles && !is_shorter_in_bundle(found->first, tip, other_tip)) continue;
          is_taken[base] = is_taken[cap.face] = true;
          flips.push_back({cap.face, base, cap.corner, height(cap)});
        }
      }
    if (flips.empty()) return {};
    mesh_.flip(flips);
    std::vector<Index> bases;
    for (const FlatFlip& f : flips) bases.push_back(f.base);
    return bases;
  }

 private:
  using Side = std::pair<Index, Index>;
  using CapsBySide = std::map<Side, std::vector<Cap>>;

  [[nodiscard]] std::span<const Triangle> triangles() const { return mesh_.mesh().triangles; }
  [[nodiscard]] const Vertex& point(Index v) const { return mesh_.mesh().vertices[v]; }
  [[nodiscard]] bool is_near(const Line& line, Index v) const {
    return line.is_within(point(v), reach_ * grid_.unit_at(size(point(v))));
  }

  [[nodiscard]] std::optional<Cap> cap_of(Index face) const {
    const Triangle& t = triangles()[face];
    std::size_t corner = 0;
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double opposite = length(point(t[(k + 1) % 3]), point(t[(k + 2) % 3]));
      if (opposite > longest) {
        corner = k;
        longest = opposite;
      }
    }
    const Vertex &a = point(t[(corner + 1) % 3]), &b = point(t[(corner + 2) % 3]);
    const Line line(a, b);
    if (!line.is_valid()) return {};
    const double foot = line.foot(point(t[corner]));
    if (!(foot > 0 && foot < 1 && is_near(line, t[corner]))) return {};
    return Cap{face, static_cast<Index>(corner), foot};
  }
  /// At least that.
  [[nodiscard]] double height(const Cap& cap) const {
    const Triangle& t = triangles()[cap.face];
    return distance_to(point(t[cap.corner]), point(t[(cap.corner + 1) % 3]), point(t[(cap.corner + 2) % 3]), cap.foot);
  }

  /// By the side as a neighbour has it.
  [[nodiscard]] CapsBySide caps_by_side(std::span<const Index> faces) const {
    CapsBySide caps;
    for (const Index f : faces) {
      if (!mesh_.is_left(f)) continue;
      if (const auto cap = cap_of(f)) {
        const Triangle& t = triangles()[f];
        caps[{t[(cap->corner + 2) % 3], t[(cap->corner + 1) % 3]}].push_back(*cap);
      }
    }
    return caps;
  }

  /// All faces that can have one of these, by increasing number.
  std::vector<Index> faces_with_sides(const CapsBySide& caps) {
    const auto is_around = [&](const auto& item) {
      return is_covered_[item.first.first] || is_covered_[item.first.second];
    };
    if (!std::all_of(caps.begin(), caps.end(), is_around)) cover(caps);
    std::vector<bool> is_end(is_covered_.size(), false);
    for (const auto& [side, list] : caps) is_end[side.first] = is_end[side.second] = true;
    std::vector<Index> faces;
    for (const Index f : around_) {
      const auto [a, b, c] = triangles()[f];
      const int ends = static_cast<int>(is_end[a]) + static_cast<int>(is_end[b]) + static_cast<int>(is_end[c]);
      if (ends >= 2 && mesh_.is_left(f)) faces.push_back(f);
    }
    return faces;
  }
  void cover(const CapsBySide& caps) {
    for (const auto& [side, list] : caps)
      for (const Cap& cap : list)
        for (const Index v : triangles()[cap.face]) is_covered_[v] = true;
    around_ = collect(triangles().size(), [&](Index f) {
      const auto [a, b, c] = triangles()[f];
      return is_covered_[a] || is_covered_[b] || is_covered_[c];
    });
  }

  [[nodiscard]] bool is_shorter_in_bundle(const Side& side, Index tip, Index other_tip) const {
    const Vertex &a = point(side.first), &b = point(side.second);
    return length(point(tip), point(other_tip)) < length(a, b) && is_near(Line(a, b), other_tip);
  }

  MovingMesh& mesh_;
  const GridRounding& grid_;
  double reach_;
  std::vector<bool> is_covered_;  ///< per vertex: corners of some caps
  std::vector<Index> around_;     ///< all faces with one of these; flips add none
};

}  // namespace

bool flip_caps(MovingMesh& mesh, const std::vector<Index>& wrong, const GridRounding& grid, double reach,
               Bundles bundles) {
  CapFlips caps(mesh, grid, reach);
  const auto flip_wrong = [&] {
    constexpr int passes = 3;
    int n = 0;
    while (n < passes && !caps.flip(wrong, CapFlips::Which::all).empty()) ++n;
    return n > 0;
  };
  const auto put_in_order = [&] {
    constexpr int most_passes = 30;
    std::vector<Index> faces = wrong;
    for (int n = 0; n < most_passes; ++n) {
      std::vector<Index> bases = caps.flip(faces, CapFlips::Which::shorter_in_bundles);
      if (bases.empty()) return n > 0;
      std::sort(bases.begin(), bases.end());
      std::vector<Index> all;
      std::set_union(faces.begin(), faces.end(), bases.begin(), bases.end(), std::back_inserter(all));
      faces = std::move(all);
    }
    return true;
  };
  bool is_changed = flip_wrong();
  if (bundles == Bundles::put_in_order && put_in_order()) {
    flip_wrong();
    is_changed = true;
  }
  return is_changed;
}

}  // namespace strata
