#include "core/select/merge_pieces.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <unordered_map>

#include "core/arrange/triangulation.h"
#include "core/exact/failure.h"

namespace strata {
namespace {

using Id = PointId;
using Edge = std::pair<Id, Id>;

constexpr Id none = 0xffffffffu;

Edge undirected(Id a, Id b) { return {std::min(a, b), std::max(a, b)}; }

bool bounds(const PieceTriangle& t, std::size_t side) { return (t.boundary >> side & 1) != 0; }
bool is_carried(const PieceTriangle& t, std::size_t side) { return (t.carried >> side & 1) != 0; }

/// The edges of the result that lie on constraints, and their number at each vertex: the boundary edges of all pieces,
/// and those in which faces cross that are kept on both sides.
class ResultEdges {
 public:
  ResultEdges(const InputComplex& input, const PointTable& table, const std::vector<SubdividedFace>& faces) {
    concerned_.assign(table.end(), 0);
    for (const SubdividedFace& face : faces)
      for (const Id v : face.points) concerned_[v] |= static_cast<std::uint8_t>(face.may_merge);
    std::vector<Edge> inner;
    for (const SubdividedFace& face : faces)
      for (const PieceTriangle& t : face.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
          const Id a = face.points[t.v[i]], b = face.points[t.v[(i + 1) % 3]];
          if (concerned_[a] == 0 && concerned_[b] == 0) continue;
          if (bounds(t, i)) {
            edges_.push_back(undirected(a, b));
          } else if (is_carried(t, i)) {
            inner.push_back(undirected(a, b));
          }
        }
    add_crossings(std::move(inner));
    tbb::parallel_sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    degree_.assign(table.end(), 0);
    neighbours_.assign(table.end(), {none, none});
    for (const auto& [a, b] : edges_) {
      meet(a, b);
      meet(b, a);
    }
    find_straight(input, table);
  }

  /// True for an edge of the result, and for sides of which nothing is known: no face at their ends may merge.
  [[nodiscard]] bool may_have(Id a, Id b) const {
    return (concerned_[a] == 0 && concerned_[b] == 0) ||
           std::binary_search(edges_.begin(), edges_.end(), undirected(a, b));
  }
  /// True when the vertex is not needed: no edge ends there, or two that form a straight line.
  [[nodiscard]] bool is_redundant(Id v) const { return concerned_[v] != 0 && (degree_[v] == 0 || straight_[v] != 0); }

 private:
  /// Adds the sides inside two or more faces. Each face lists its own twice, from both triangles.
  void add_crossings(std::vector<Edge> inner) {
    tbb::parallel_sort(inner.begin(), inner.end());
    for (std::size_t i = 3; i < inner.size(); ++i)
      if (inner[i] == inner[i - 3]) edges_.push_back(inner[i]);
  }
  void meet(Id a, Id b) {
    if (degree_[a] < 2) neighbours_[a][degree_[a]] = b;
    ++degree_[a];
  }
  void find_straight(const InputComplex& input, const PointTable& table) {
    straight_.assign(degree_.size(), 0);
    tbb::parallel_for(std::size_t{0}, degree_.size(), [&](std::size_t v) {
      const auto id = static_cast<Id>(v);
      if (concerned_[v] == 0 || degree_[v] != 2 || table.is_input(id)) return;
      const auto [before, after] = neighbours_[v];
      straight_[v] = static_cast<std::uint8_t>(runs_straight(input, table, before, id, after));
    });
  }
  [[nodiscard]] static bool runs_straight(const InputComplex& input, const PointTable& table, Id a, Id b, Id c) {
    if (named_on_line(input, table.name(b), table.name(a), table.name(c))) return true;
    const Point p = table.point(a), q = table.point(b), r = table.point(c);
    for (const Projection axes : {Projection{0, 1}, Projection{1, 2}, Projection{2, 0}})
      if (orient2d(input, axes, p, q, r) != Sign::zero) return false;
    return true;
  }

  std::vector<std::uint8_t> concerned_;  ///< per point: its boundary edges are known
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> degree_;
  std::vector<std::array<Id, 2>> neighbours_;
  std::vector<std::uint8_t> straight_;
};

/// A directed run of sides between two kept vertices, with triangles of one verdict on its left.
struct Run {
  Id from = 0, to = 0;
  Verdict left = Verdict::drop;  ///< drop: the run only divides the face
};

/// Triangulates one face again.
class FaceMerger {
 public:
  FaceMerger(const InputComplex& input, const PointTable& table, const ResultEdges& edges)
      : edges_(edges), triangulation_(input, table) {}

  void merge(SubdividedFace& face, Pool& pool) {
    if (!is_concerned(face)) return;
    gather_runs(face);
    triangulate(face);
    collect();
    face.points = pool.keep(points_);
    face.triangles = pool.keep(triangles_);
  }

 private:
  [[nodiscard]] bool is_concerned(const SubdividedFace& face) const {
    for (const Id v : face.points)
      if (edges_.is_redundant(v)) return true;
    for (const PieceTriangle& t : face.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        if (!bounds(t, i) && is_carried(t, i) && !edges_.may_have(face.points[t.v[i]], face.points[t.v[(i + 1) % 3]]))
          return true;
    return false;
  }

  /// The kept sides, in the face's own orientation, joined across redundant vertices.
  void gather_runs(const SubdividedFace& face) {
    std::vector<Run> sides;
    for (const PieceTriangle& t : face.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        Id a = face.points[t.v[i]], b = face.points[t.v[(i + 1) % 3]];
        if (t.reversed) std::swap(a, b);
        if (bounds(t, i)) {
          sides.push_back({a, b, t.reversed ? Verdict::keep_reversed : Verdict::keep});
        } else if (is_carried(t, i) && edges_.may_have(a, b)) {
          sides.push_back({a, b, Verdict::drop});
        }
      }
    join(sides, face.face);
  }

  /// Joins runs at redundant vertices. Two sides meet in such a vertex, and each face that has one of them has both. A
  /// dividing side occurs once in each direction, from its two triangles.
  void join(const std::vector<Run>& sides, std::uint32_t face) {
    std::unordered_map<Id, std::vector<Run>> leaving;  // per redundant vertex
    for (const Run& s : sides)
      if (edges_.is_redundant(s.from)) leaving[s.from].push_back(s);
    runs_.clear();
    for (Run s : sides) {
      if (edges_.is_redundant(s.from)) continue;
      for (Id before = s.from; edges_.is_redundant(s.to);) {
        const auto& ways = leaving[s.to];
        const auto onward =
            std::find_if(ways.begin(), ways.end(), [&](const Run& w) { return w.left == s.left && w.to != before; });
        if (onward == ways.end()) fail("a boundary loop ends at a redundant vertex", face);
        before = s.to;
        s.to = onward->to;
      }
      runs_.push_back(s);
    }
  }

  /// Runs, and vertices in which other faces only touch this one.
  void triangulate(const SubdividedFace& face) {
    triangulation_.start(face.face, Triangulation::Names::any);
    ids_.clear();
    std::vector<std::pair<std::int32_t, std::int32_t>> ends;
    for (const Run& r : runs_) ends.push_back({add_point(r.from), add_point(r.to)});
    for (const Id v : face.points)
      if (!edges_.is_redundant(v)) add_point(v);
    const std::int32_t points = triangulation_.points().size();
    for (std::size_t i = 0; i < ends.size(); ++i)
      triangulation_.add_segment(ends[i].first, ends[i].second, static_cast<std::int32_t>(i), {});
    if (triangulation_.points().size() != points) fail("boundary loops of pieces cross", face.face);
    triangulation_.avoid_flat_angles();
  }

  std::int32_t add_point(Id id) {
    const std::int32_t v = triangulation_.add_point(id);
    const auto i = static_cast<std::size_t>(v);
    if (ids_.size() <= i) ids_.resize(i + 1, none);
    ids_[i] = id;
    return v;
  }

  void collect() {
    const auto triangles = triangulation_.triangles();
    std::vector<Verdict> verdicts(triangles.size(), Verdict::drop);
    std::vector<std::size_t> stack;
    const auto reach = [&](std::int32_t t, Verdict v) {
      if (t < 0 || verdicts[static_cast<std::size_t>(t)] != Verdict::drop) return;
      verdicts[static_cast<std::size_t>(t)] = v;
      stack.push_back(static_cast<std::size_t>(t));
    };
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (const std::int32_t first : triangles[t].c)
        for (std::int32_t n = first; n >= 0; n = triangulation_.note(n).next) {
          const auto& note = triangulation_.note(n);
          const Verdict left = runs_[static_cast<std::size_t>(note.constraint)].left;
          if (note.forward && left != Verdict::drop) reach(static_cast<std::int32_t>(t), left);
        }
    while (!stack.empty()) {
      const std::size_t t = stack.back();
      stack.pop_back();
      for (std::size_t i = 0; i < 3; ++i)
        if (triangles[t].c[i] < 0 || only_divides(triangles[t].c[i])) reach(triangles[t].n[i], verdicts[t]);
    }
    points_.clear();
    triangles_.clear();
    std::vector<std::uint32_t> index(static_cast<std::size_t>(triangulation_.points().size()), none);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      if (verdicts[t] == Verdict::drop) continue;
      PieceTriangle piece;
      piece.reversed = verdicts[t] == Verdict::keep_reversed;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto v = static_cast<std::size_t>(triangles[t].v[piece.reversed ? 2 - i : i]);
        if (index[v] == none) {
          index[v] = static_cast<std::uint32_t>(points_.size());
          points_.push_back(ids_[v]);
        }
        piece.v[i] = index[v];
      }
      triangles_.push_back(piece);
    }
  }

  [[nodiscard]] bool only_divides(std::int32_t first_note) const {
    for (std::int32_t n = first_note; n >= 0; n = triangulation_.note(n).next)
      if (runs_[static_cast<std::size_t>(triangulation_.note(n).constraint)].left != Verdict::drop) return false;
    return true;
  }

  const ResultEdges& edges_;
  Triangulation triangulation_;
  std::vector<Run> runs_;
  std::vector<Id> ids_;  ///< per vertex of the triangulation
  std::vector<PointId> points_;
  std::vector<PieceTriangle> triangles_;
};

}  // namespace

void merge_pieces(const InputComplex& input, Subdivision& subdivision, const Monitor& monitor) {
  std::vector<SubdividedFace>& faces = subdivision.faces;
  if (std::none_of(faces.begin(), faces.end(), [](const SubdividedFace& f) { return f.may_merge; })) return;
  const ResultEdges edges(input, subdivision.points, faces);
  tbb::enumerable_thread_specific<FaceMerger> mergers([&] { return FaceMerger(input, subdivision.points, edges); });
  tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t i) {
    monitor.check();
    mergers.local().merge(faces[i], subdivision.pools.local());
  });
}

}  // namespace strata
