#include "extensions/convex/outer_pieces.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "core/exact/failure.h"
#include "core/kernel/disjoint_sets.h"

namespace strata::convex {
namespace {

/// A side of a piece.
struct SideOfPiece {
  PointId low = 0, high = 0;
  std::uint32_t piece = 0;
  bool forward = false;  ///< the piece has it from low to high
};

bool on_one_edge(const SideOfPiece& a, const SideOfPiece& b) { return a.low == b.low && a.high == b.high; }

/// Pieces that are kept or dropped together, and whether this is known.
class Patches {
 public:
  Patches(const std::vector<PieceOfFace>& pieces, const Monitor& monitor)
      : monitor_(monitor), sets_(pieces.size()), gone_(pieces.size(), false), stays_(pieces.size(), false) {
    sides_.reserve(3 * pieces.size());
    for (std::uint32_t p = 0; p < pieces.size(); ++p)
      for (std::size_t i = 0; i < 3; ++i) {
        const PointId v = pieces[p].corners[i], w = pieces[p].corners[(i + 1) % 3];
        sides_.push_back({std::min(v, w), std::max(v, w), p, v < w});
      }
    std::sort(sides_.begin(), sides_.end(), [&](const SideOfPiece& a, const SideOfPiece& b) {
      monitor_.check();
      return std::pair(std::pair(a.low, a.high), a.piece) < std::pair(std::pair(b.low, b.high), b.piece);
    });
    spread();
  }

  [[nodiscard]] bool is_gone(std::uint32_t piece) { return gone_[sets_.find(piece)]; }
  /// A decision about a piece is one about its patch.
  void drop(std::uint32_t piece) {
    if (stays_[sets_.find(piece)]) throw LogicError("a piece of a boundary is alone at an edge");
    gone_[sets_.find(piece)] = true;
  }
  void keep(std::uint32_t piece) { stays_[sets_.find(piece)] = true; }
  /// Propagates the consequences to other pieces.
  void spread() {
    while (look_at_edges()) {
    }
  }

  /// The patches without a decision, the largest first.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> unknown() {
    std::vector<std::uint32_t> number(gone_.size(), none);
    std::vector<std::vector<std::uint32_t>> patches;
    for (std::uint32_t p = 0; p < gone_.size(); ++p) {
      const std::uint32_t root = sets_.find(p);
      if (gone_[root] || stays_[root]) continue;
      if (number[root] == none) {
        number[root] = static_cast<std::uint32_t>(patches.size());
        patches.emplace_back();
      }
      patches[number[root]].push_back(p);
    }
    std::stable_sort(patches.begin(), patches.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
    return patches;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;

  /// Examines all edges that may lead to further decisions, and removes those that are exhausted. True if one led to a
  /// decision.
  bool look_at_edges() {
    bool changed = false;
    auto kept = sides_.begin();
    for (auto first = sides_.begin(), last = first; first != sides_.end(); first = last) {
      monitor_.check();
      last = std::find_if(first, sides_.end(), [&](const SideOfPiece& s) { return !on_one_edge(s, *first); });
      const auto end = std::copy_if(first, last, kept, [&](const SideOfPiece& s) { return !is_gone(s.piece); });
      const auto count = end - kept;
      if (count == 1) drop(kept->piece);
      if (count == 2) connect(kept[0], kept[1]);
      changed |= count == 1 || count == 2;
      if (count > 2) kept = end;
    }
    sides_.erase(kept, sides_.end());
    return changed;
  }

  /// Two pieces that are alone at an edge have the solid behind both only if their directions along it are opposite.
  void connect(const SideOfPiece& a, const SideOfPiece& b) {
    if (a.forward != b.forward) {
      const bool stays = stays_[sets_.find(a.piece)] || stays_[sets_.find(b.piece)];
      sets_.unite(a.piece, b.piece);
      stays_[sets_.find(a.piece)] = stays;
    } else {
      drop(a.piece);
      drop(b.piece);
    }
  }

  const Monitor& monitor_;
  DisjointSets<std::uint32_t> sets_;
  std::vector<bool> gone_, stays_;  ///< per patch, at its representative piece
  std::vector<SideOfPiece> sides_;  ///< by edges
};

/// All pieces of an arrangement: whole faces, then pieces of the others.
std::vector<PieceOfFace> list_pieces(const InputComplex& input, const std::vector<Verdict>& verdicts,
                                     const Subdivision& subdivision) {
  std::vector<PieceOfFace> all;
  for (std::uint32_t f = 0; f < verdicts.size(); ++f) {
    if (verdicts[f] == Verdict::drop) continue;
    auto corners = input.face(f);
    for (PointId& p : corners) p = subdivision.points.representative(p);
    all.push_back({f, corners});
  }
  for (const SubdividedFace& s : subdivision.faces)
    for (const PieceTriangle& t : s.triangles)
      all.push_back({s.face, {s.points[t.v[0]], s.points[t.v[1]], s.points[t.v[2]]}});
  return all;
}

/// The extent of a patch along the first axis, within bounds.
struct Reach {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = lower;
};

Reach reach_of(const std::vector<std::uint32_t>& patch, const std::vector<PieceOfFace>& pieces,
               const PointTable& points) {
  Reach reach;
  for (const std::uint32_t p : patch)
    for (const PointId v : pieces[p].corners) {
      const Bounded x = points.point(v).at[0];
      reach.lower = std::max(reach.lower, x.lower());
      reach.upper = std::max(reach.upper, x.upper());
    }
  return reach;
}

/// The patch that certainly extends farther than all others, or their number if it is not certain. It is in the
/// boundary, because one of the patches that extend farthest is.
std::size_t farthest(const std::vector<std::vector<std::uint32_t>>& patches, const std::vector<PieceOfFace>& pieces,
                     const PointTable& points) {
  if (patches.size() == 1) return 0;
  std::vector<Reach> reaches;
  for (const auto& patch : patches) reaches.push_back(reach_of(patch, pieces, points));
  const auto first = std::max_element(reaches.begin(), reaches.end(),
                                      [](const Reach& a, const Reach& b) { return a.lower < b.lower; });
  const auto reaches_as_far = [&](const Reach& r) { return r.upper >= first->lower; };
  if (std::count_if(reaches.begin(), reaches.end(), reaches_as_far) > 1) return patches.size();
  return static_cast<std::size_t>(first - reaches.begin());
}

/// Tests one position of a patch after the other until one is decided. Undecided positions lie on finitely many lines,
/// and each line contains at most two of the positions in one piece.
Side side_in_front(const std::vector<std::uint32_t>& patch, const std::vector<PieceOfFace>& pieces,
                   const SideInFront& ask, const Monitor& monitor) {
  constexpr int limit = 1 << 20;
  for (int k = 0; k < limit; ++k) {
    monitor.check();
    if (const Side side = ask(pieces[patch[static_cast<std::size_t>(k) % patch.size()]], k + 1); side != Side::unknown)
      return side;
  }
  fail("no place in front of a piece is known", pieces[patch.front()].face);
}

/// The remaining triangles of a face, and their points.
class Remainder {
 public:
  void clear() {
    index_.clear();
    points_.clear();
    triangles_.clear();
  }
  void keep(const SubdividedFace& face, const PieceTriangle& t) {
    index_.resize(face.points.size(), none);
    PieceTriangle& kept = triangles_.emplace_back(t);
    for (std::uint32_t& v : kept.v) {
      if (index_[v] == none) {
        index_[v] = static_cast<std::uint32_t>(points_.size());
        points_.push_back(face.points[v]);
      }
      v = index_[v];
    }
  }
  void replace(SubdividedFace& face, Pool& pool) {
    if (triangles_.size() == face.triangles.size()) return;
    find_boundary();
    face.points = pool.keep(points_);
    face.triangles = pool.keep(triangles_);
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;

  void find_boundary() {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
    for (const PieceTriangle& t : triangles_)
      for (std::size_t i = 0; i < 3; ++i) sides.emplace_back(t.v[i], t.v[(i + 1) % 3]);
    std::sort(sides.begin(), sides.end());
    for (PieceTriangle& t : triangles_)
      for (std::size_t i = 0; i < 3; ++i)
        if (!std::binary_search(sides.begin(), sides.end(), std::pair(t.v[(i + 1) % 3], t.v[i])))
          t.boundary |= static_cast<std::uint8_t>(1u << i);
  }

  std::vector<std::uint32_t> index_;  ///< per point of the face
  std::vector<PointId> points_;
  std::vector<PieceTriangle> triangles_;
};

/// Requires pieces as they were listed.
void drop_gone(std::vector<Verdict>& verdicts, Subdivision& subdivision, Patches& patches) {
  std::uint32_t next = 0;
  for (Verdict& v : verdicts)
    if (v != Verdict::drop && patches.is_gone(next++)) v = Verdict::drop;
  Remainder remainder;
  for (SubdividedFace& face : subdivision.faces) {
    remainder.clear();
    for (const PieceTriangle& t : face.triangles)
      if (!patches.is_gone(next++)) remainder.keep(face, t);
    remainder.replace(face, subdivision.pools.local());
  }
}

}  // namespace

void keep_outer_pieces(const InputComplex& input, std::vector<Verdict>& verdicts, Subdivision& subdivision,
                       const SideInFront& in_front, const Monitor& monitor) {
  const std::vector<PieceOfFace> all = list_pieces(input, verdicts, subdivision);
  Patches patches(all, monitor);
  auto unknown = patches.unknown();
  if (const std::size_t outside = farthest(unknown, all, subdivision.points); outside < unknown.size()) {
    patches.keep(unknown[outside].front());
    unknown.erase(unknown.begin() + static_cast<std::ptrdiff_t>(outside));
  }
  // Decisions about some patches decide many others.
  constexpr std::size_t least = 16, share = 8;
  while (!unknown.empty()) {
    unknown.resize(std::min(unknown.size(), std::max(least, unknown.size() / share)));
    std::vector<Side> sides(unknown.size());
    tbb::parallel_for(std::size_t{0}, unknown.size(),
                      [&](std::size_t i) { sides[i] = side_in_front(unknown[i], all, in_front, monitor); });
    for (std::size_t i = 0; i < unknown.size(); ++i)
      sides[i] == Side::in ? patches.drop(unknown[i].front()) : patches.keep(unknown[i].front());
    patches.spread();
    unknown = patches.unknown();
  }
  drop_gone(verdicts, subdivision, patches);
}

}  // namespace strata::convex
