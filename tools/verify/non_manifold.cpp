#include "verify/non_manifold.h"

#include <map>
#include <span>
#include <vector>

#include "core/kernel/disjoint_sets.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/equal_vertices.h"

namespace verify {
namespace {

using strata::EdgeUse;
using strata::Rational;
using strata::RationalPoint;
using strata::Triangle;

/// The end of a non-manifold mesh edge at a vertex.
struct EdgeEnd {
  std::uint32_t other;
  std::size_t sheets;
};

class Surface {
 public:
  explicit Surface(const strata::ExactMesh& mesh) : mesh_(mesh), first_(strata::equal_vertices(mesh)) {
    for (const Triangle& t : mesh.mesh.triangles) {
      const Triangle welded{first_[t[0]], first_[t[1]], first_[t[2]]};
      if (!strata::repeats_vertex(welded)) triangles_.push_back(welded);
    }
    link();
  }

  [[nodiscard]] NonManifold facts() {
    NonManifold result;
    for (const auto& [vertex, ends] : ends_) {
      for (const EdgeEnd& end : ends) {
        if (end.other < vertex) continue;
        ++result.edges;
        result.extra_edges += end.sheets / 2 - 1;
      }
    }
    const std::vector<std::uint32_t> fans = fans_per_vertex();
    for (std::uint32_t v = 0; v < fans.size(); ++v) {
      if (fans[v] < 2) continue;
      if (const std::size_t sheets = passing_sheets(v, fans[v]); sheets != 0) {  // two stretches that are one
        --result.edges;
        result.extra_edges -= sheets / 2 - 1;
      } else {
        ++result.vertices;
        result.extra_vertices += fans[v] - 1;
      }
    }
    result.parts = parts();
    return result;
  }

 private:
  /// Joins corners and triangles over manifold edges; collects the other edges at their ends.
  void link() {
    corners_ = strata::DisjointSets<std::size_t>(3 * triangles_.size());
    connected_ = strata::DisjointSets<std::size_t>(triangles_.size());
    const std::vector<EdgeUse> table = strata::edge_table(triangles_, mesh_.mesh.vertices.size());
    strata::for_each_edge(table, [&](std::span<const EdgeUse> uses) {
      if (uses.size() > 2) {
        ends_[uses[0].low].push_back({uses[0].high, uses.size()});
        ends_[uses[0].high].push_back({uses[0].low, uses.size()});
      } else if (uses.size() == 2) {
        for (const bool at_low : {true, false}) corners_.unite(corner(uses[0], at_low), corner(uses[1], at_low));
        connected_.unite(uses[0].triangle, uses[1].triangle);
      }
    });
  }

  static std::size_t corner(const EdgeUse& use, bool at_low) {
    const std::size_t other = use.corner == 2 ? 0 : use.corner + std::size_t{1};
    return 3 * std::size_t{use.triangle} + (use.forward == at_low ? use.corner : other);
  }

  [[nodiscard]] std::vector<std::uint32_t> fans_per_vertex() {
    std::vector<std::uint32_t> count(mesh_.mesh.vertices.size(), 0);
    for (std::size_t c = 0; c < 3 * triangles_.size(); ++c)
      if (corners_.find(c) == c) ++count[triangles_[c / 3][c % 3]];
    return count;
  }

  /// The sheets of the stretch that v is inside of; 0 if it is not.
  [[nodiscard]] std::size_t passing_sheets(std::uint32_t v, std::uint32_t fans) const {
    const auto found = ends_.find(v);
    if (found == ends_.end() || found->second.size() != 2) return 0;
    const EdgeEnd &a = found->second[0], &b = found->second[1];
    if (a.sheets != b.sheets || a.sheets != fans) return 0;
    return is_straight(a.other, v, b.other) ? a.sheets : 0;
  }

  [[nodiscard]] bool is_straight(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const RationalPoint p = mesh_.position(a), q = mesh_.position(b), r = mesh_.position(c);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if ((q[i] - p[i]) * (r[j] - q[j]) != (q[j] - p[j]) * (r[i] - q[i])) return false;
    }
    return true;
  }

  [[nodiscard]] std::uint64_t parts() {
    std::uint64_t count = 0;
    for (std::size_t t = 0; t < triangles_.size(); ++t) count += connected_.find(t) == t;
    return count;
  }

  const strata::ExactMesh& mesh_;
  std::vector<std::uint32_t> first_;
  std::vector<Triangle> triangles_;
  strata::DisjointSets<std::size_t> corners_{0}, connected_{0};
  std::map<std::uint32_t, std::vector<EdgeEnd>> ends_;
};

}  // namespace

NonManifold non_manifold(const strata::ExactMesh& mesh) { return Surface(mesh).facts(); }

}  // namespace verify
