#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "extensions/bsp/for_some.h"
#include "extensions/convex/region.h"

namespace strata::convex {
namespace {

constexpr std::size_t most_candidates = 128;    ///< planes through reflex edges that are tried
constexpr std::size_t most_edges_asked = 1024;  ///< reflex edges that are tested for being divided
constexpr std::size_t most_asked = 64;          ///< faces that are tested for their side
constexpr std::size_t parts_tried = 6;          ///< connected parts whose planes are tried, and planes of each
constexpr double cost_of_divided_face = 0.05;   ///< where a reflex edge that is resolved counts 1; measured

/// Edges, and their ends in doubles, which decide in nearly all cases whether a plane divides them.
class ReflexEdges {
 public:
  explicit ReflexEdges(const HyperplaneTable<3>& table) : table_(table) {}

  void add(const Edge& e) {
    edges_.push_back(&e);
    for (std::size_t end = 0; end < 2; ++end) {
      Point& p = ends_.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const Bounded& x = e.ends[end].at[i];
        p[i] = x.value;
        largest_[i] = Bounded(std::max(largest_[i].value, std::abs(x.value)), std::max(largest_[i].error, x.error));
      }
    }
  }

  /// The number of edges that a plane divides; at most `enough` are counted.
  [[nodiscard]] std::size_t divided_by(std::uint32_t plane, double enough) const {
    const auto [form, bound] = table_.form_within(plane, largest_);
    const auto value = [&, form = form](const Point& p) {
      return form[0] * p[0] + form[1] * p[1] + form[2] * p[2] + form[3];
    };
    std::size_t divided = 0;
    for (std::size_t k = 0; k < edges_.size() && static_cast<double>(divided) < enough; ++k) {
      const double from = value(ends_[2 * k]), to = value(ends_[2 * k + 1]);
      const bool is_certain = std::abs(from) > bound && std::abs(to) > bound;
      divided += is_certain ? (from > 0) != (to > 0) : is_divided(*edges_[k], plane);
    }
    return divided;
  }

 private:
  using Point = std::array<double, 3>;

  [[nodiscard]] bool is_divided(const Edge& e, std::uint32_t plane) const {
    const Sign from = table_.side(plane, e.ends[0]);
    return from != Sign::zero && from * table_.side(plane, e.ends[1]) == Sign::negative;
  }

  const HyperplaneTable<3>& table_;
  std::vector<const Edge*> edges_;
  std::vector<Point> ends_;           ///< two for each
  std::array<Bounded, 3> largest_{};  ///< coordinates and errors
};

class CutChooser {
 public:
  CutChooser(const PreparedBoundary& boundary, Workspace& workspace, const Region& region)
      : boundary_(boundary), workspace_(workspace), region_(region), asked_(boundary.table) {
    for (const Edge& e : region.edges)
      if (boundary.wedges[e.wedge].is_reflex) reflex_.push_back(&e);
    bsp::for_some(reflex_.size(), most_edges_asked, [&](std::size_t k) { asked_.add(*reflex_[k]); });
  }

  std::optional<std::uint32_t> choose() const { return reflex_.empty() ? between_parts() : through_reflex_edges(); }

 private:
  using Part = std::vector<const Face*>;

  /// The plane with the best value: reflex edges that it is known to resolve, minus those that it divides, minus a
  /// small cost for divided faces.
  [[nodiscard]] std::uint32_t through_reflex_edges() const {
    std::uint32_t best = 0;
    double highest = -HUGE_VAL;
    for (const auto& [plane, edges] : candidates()) {
      if (edges <= highest) break;
      double worth = edges - divided_edges(plane, edges - highest);
      if (worth > highest) worth -= cost_of_divided_face * divided_faces(plane);
      if (worth <= highest) continue;
      best = plane;
      highest = worth;
    }
    return best;
  }

  struct Candidate {
    std::uint32_t plane = 0;
    std::uint32_t edges = 0;  ///< reflex edges that are known to lie in it
  };

  /// The planes through most reflex edges first.
  [[nodiscard]] std::vector<Candidate> candidates() const {
    std::vector<Candidate> planes;
    for (const Edge* e : reflex_)
      for (const std::uint32_t plane : boundary_.cut_planes[e->wedge])
        if (workspace_.of_planes[plane]++ == 0) planes.push_back({plane, 0});
    for (Candidate& c : planes) c.edges = std::exchange(workspace_.of_planes[c.plane], 0);
    const std::size_t tried = std::min(planes.size(), most_candidates);
    const auto comes_first = [](const Candidate& a, const Candidate& b) {
      return a.edges != b.edges ? a.edges > b.edges : a.plane < b.plane;
    };
    std::partial_sort(planes.begin(), planes.begin() + static_cast<std::ptrdiff_t>(tried), planes.end(), comes_first);
    planes.resize(tried);
    return planes;
  }

  /// The number of reflex edges that a plane divides; at most `enough` are counted. Of many edges a sample is tested.
  [[nodiscard]] double divided_edges(std::uint32_t plane, double enough) const {
    const std::size_t count = reflex_.size();
    const double each = static_cast<double>(count) / static_cast<double>(std::min(count, most_edges_asked));
    return each * static_cast<double>(asked_.divided_by(plane, enough / each));
  }

  /// An estimate, from some faces and doubles that may be rounded.
  [[nodiscard]] double divided_faces(std::uint32_t plane) const {
    const std::size_t count = region_.faces.size();
    double divided = 0;
    bsp::for_some(count, most_asked, [&](std::size_t k) {
      divided += bsp::estimated_lie(boundary_.table, *region_.faces[k].part, plane) == bsp::Lie::both ? 1 : 0;
    });
    return divided * static_cast<double>(count) / static_cast<double>(std::min(count, most_asked));
  }

  /// A plane of a face that divides few components of the boundary and leaves about as many on either side.
  [[nodiscard]] std::optional<std::uint32_t> between_parts() const {
    const std::vector<Part> parts = connected_parts();
    if (parts.size() == 1) return std::nullopt;
    std::uint32_t best = 0;
    double lowest = HUGE_VAL;
    bsp::for_some(parts.size(), parts_tried, [&](std::size_t k) {
      bsp::for_some(parts[k].size(), parts_tried, [&](std::size_t i) {
        const std::uint32_t plane = boundary_.plane_of(parts[k][i]->triangle);
        if (const double cost = cost_between(parts, plane); cost < lowest) {
          best = plane;
          lowest = cost;
        }
      });
    });
    return best;
  }

  [[nodiscard]] double cost_between(const std::vector<Part>& parts, std::uint32_t plane) const {
    constexpr double cost_of_divided_part = 4;
    double divided = 0, minus = 0, plus = 0;
    for (const Part& part : parts) {
      bool is_minus = false, is_plus = false;
      for (const Face* f : part) {
        const bsp::Lie lie = bsp::lie_of(boundary_.table, *f->part, plane);
        is_minus |= lie == bsp::Lie::minus || lie == bsp::Lie::both;
        is_plus |= lie == bsp::Lie::plus || lie == bsp::Lie::both;
        if (is_minus && is_plus) break;
      }
      divided += is_minus && is_plus ? 1 : 0;
      minus += is_minus ? 1 : 0;
      plus += is_plus ? 1 : 0;
    }
    return cost_of_divided_part * divided + std::max(minus, plus);
  }

  /// Components: faces connected over edges. In the order of their first faces.
  [[nodiscard]] std::vector<Part> connected_parts() const {
    std::vector<std::uint32_t>& parent = workspace_.parents;  // the entries of faces of the region are set here
    for (const Face& f : region_.faces) parent[f.triangle] = f.triangle;
    const auto root = [&](std::uint32_t t) {
      while (parent[t] != t) t = parent[t] = parent[parent[t]];
      return t;
    };
    std::size_t count = region_.faces.size();
    for (const Edge& e : region_.edges) {
      const auto [f, g] = boundary_.wedges[e.wedge].faces;
      const std::uint32_t a = root(f), b = root(g);
      count -= a != b ? 1 : 0;
      parent[a] = b;
    }
    if (count == 1) return std::vector<Part>(1);  // whose faces are not needed
    std::vector<Part> parts;
    std::map<std::uint32_t, std::size_t> number;
    for (const Face& f : region_.faces) {
      const auto [at, is_new] = number.try_emplace(root(f.triangle), parts.size());
      if (is_new) parts.emplace_back();
      parts[at->second].push_back(&f);
    }
    return parts;
  }

  const PreparedBoundary& boundary_;
  Workspace& workspace_;
  const Region& region_;
  std::vector<const Edge*> reflex_;
  ReflexEdges asked_;
};

}  // namespace

std::optional<std::uint32_t> choose_cut(const PreparedBoundary& boundary, Workspace& workspace, const Region& region) {
  return CutChooser(boundary, workspace, region).choose();
}

}  // namespace strata::convex
