#include "extensions/incremental/redundant_corners.h"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "extensions/incremental/star_polygon.h"

namespace strata {
namespace {

using Index = std::uint32_t;
constexpr Index none = std::numeric_limits<Index>::max();

/// Triangles around a corner in one plane and with one orientation.
struct Sheet {
  PlanePointer plane;
  boost::container::small_vector<Index, 8> triangles;
};

/// A measure from 0 to 1 of how far three planes are from having a line in common.
double spread(const SourcePlane& p, const SourcePlane& q, const SourcePlane& r) {
  const auto length = [](const BoundedPoint& n) { return std::hypot(n[0].value, n[1].value, n[2].value); };
  const auto &a = p.bounded_normal(), &b = q.bounded_normal(), &c = r.bounded_normal();
  return std::abs(dot<Bounded>(a, cross<Bounded>(b, c)).value) / (length(a) * length(b) * length(c));
}

class CornerRemover {
 public:
  CornerRemover(const InputComplex& input, const PointTable& points, FacePlanes& planes,
                const std::vector<PointId>& candidates, std::vector<ResultTriangle>& triangles,
                const std::vector<FaceOrigin>& origins)
      : input_(input),
        points_(points),
        planes_(planes),
        candidates_(candidates),
        triangles_(triangles),
        origins_(origins) {
    place_.assign(points.end(), none);
    for (Index i = 0; i < candidates.size(); ++i) place_[candidates[i]] = i;
    around_.resize(candidates.size());
    std::vector<OrientedFace> faces;
    for (Index t = 0; t < triangles.size(); ++t)
      if (list(t)) faces.push_back({triangles[t].face, triangles[t].reversed});
    planes_.compute(faces);
  }

  std::vector<MeetingPlanes> remove_all() {
    std::vector<MeetingPlanes> intersections(candidates_.size());
    for (Index i = 0; i < candidates_.size(); ++i) {
      find_sheets(i);
      if (sheets_.empty() || (!find_meeting(intersections[i]) && remove(i))) continue;
    }
    std::erase_if(triangles_, [](const ResultTriangle& t) { return t.face == none; });
    return intersections;
  }

 private:
  /// Adds a triangle to those around its corners; false if none of these is a candidate.
  bool list(Index t) {
    bool is_listed = false;
    for (const PointId v : triangles_[t].v) {
      if (place_[v] == none) continue;
      around_[place_[v]].push_back(t);
      is_listed = true;
    }
    return is_listed;
  }

  void find_sheets(Index corner) {
    sheets_.clear();
    for (const Index t : around_[corner]) {
      const ResultTriangle& triangle = triangles_[t];
      if (triangle.face == none) continue;
      const PlanePointer& plane = planes_.of({triangle.face, triangle.reversed});
      auto at = std::find_if(sheets_.begin(), sheets_.end(), [&](const Sheet& s) { return s.plane == plane; });
      if (at == sheets_.end())
        at = std::find_if(sheets_.begin(), sheets_.end(), [&](const Sheet& s) {
          return are_parallel(*s.plane, *plane) && have_same_direction(*s.plane, *plane);
        });
      if (at == sheets_.end()) at = sheets_.insert(sheets_.end(), Sheet{plane, {}});
      at->triangles.push_back(t);
    }
  }

  /// Three planes that meet in the corner, of those around it the best conditioned ones; false if there are no three.
  bool find_meeting(MeetingPlanes& meeting) const {
    double best = -1;
    const std::size_t n = std::min<std::size_t>(sheets_.size(), 6), all = sheets_.size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j)
        for (std::size_t k = j + 1; k < n; ++k) consider(i, j, k, best, meeting);
    if (best >= 0 || all <= n) return best >= 0;
    for (std::size_t i = 0; i < all && best < 0; ++i)
      for (std::size_t j = i + 1; j < all && best < 0; ++j)
        for (std::size_t k = j + 1; k < all && best < 0; ++k) consider(i, j, k, best, meeting);
    return best >= 0;
  }
  void consider(std::size_t i, std::size_t j, std::size_t k, double& best, MeetingPlanes& meeting) const {
    const PlanePointer &p = sheets_[i].plane, &q = sheets_[j].plane, &r = sheets_[k].plane;
    const double size = spread(*p, *q, *r);
    if (size <= best || !are_independent(*p, *q, *r)) return;
    best = size;
    meeting = {p, q, r};
  }

  /// False if the corner cannot be removed.
  bool remove(Index corner) {
    fans_.clear();
    for (const Sheet& sheet : sheets_)
      if (!has_one_origin(sheet) || !find_fans(candidates_[corner], sheet)) return false;
    if (!split_discs() || !ends_match()) return false;
    std::vector<ResultTriangle> replacing;
    for (const Fan& fan : fans_) {
      const auto triangulated = triangulate_star(input_, points_, *sheets_[fan.sheet].plane, fan.loop);
      if (!triangulated) return false;
      const ResultTriangle& like = triangles_[sheets_[fan.sheet].triangles.front()];
      for (const auto& v : *triangulated) replacing.push_back({v, like.face, like.reversed, false});
    }
    for (const Sheet& sheet : sheets_)
      for (const Index t : sheet.triangles) triangles_[t].face = none;
    for (const ResultTriangle& t : replacing) {
      triangles_.push_back(t);
      list(static_cast<Index>(triangles_.size() - 1));
    }
    return true;
  }

  /// True if the sheet is a part of one face of the given solids, or none of them has attributes.
  [[nodiscard]] bool has_one_origin(const Sheet& sheet) const {
    if (origins_.empty()) return true;
    const auto origin = [&](Index t) {
      FaceOrigin o = origins_[triangles_[t].face];
      o.is_turned ^= triangles_[t].reversed;
      return o;
    };
    const FaceOrigin first = origin(sheet.triangles.front());
    return std::all_of(sheet.triangles.begin(), sheet.triangles.end(), [&](Index t) { return origin(t) == first; });
  }

  /// The triangles of a sheet around a corner: a whole disc, or a fan from one side to another.
  struct Fan {
    std::size_t sheet = 0;
    bool is_closed = false;
    std::vector<PointId> loop;
  };

  /// Connects the sides opposite to the corner to chains. False when they branch.
  bool find_fans(PointId corner, const Sheet& sheet) {
    std::vector<std::pair<PointId, PointId>> sides;
    for (const Index t : sheet.triangles) {
      const auto& v = triangles_[t].v;
      const std::size_t i = v[0] == corner ? 0 : v[1] == corner ? 1 : 2;
      sides.emplace_back(v[(i + 1) % 3], v[(i + 2) % 3]);
    }
    std::sort(sides.begin(), sides.end());
    std::vector<PointId> heads;
    for (const auto& [tail, head] : sides) heads.push_back(head);
    std::sort(heads.begin(), heads.end());
    if (std::adjacent_find(heads.begin(), heads.end()) != heads.end()) return false;
    for (std::size_t i = 0; i + 1 < sides.size(); ++i)
      if (sides[i].first == sides[i + 1].first) return false;
    std::vector<bool> used(sides.size());
    const auto follow = [&](std::size_t first) {
      Fan fan{static_cast<std::size_t>(&sheet - sheets_.data()), false, {sides[first].first}};
      for (std::size_t at = first;;) {
        used[at] = true;
        const PointId next = sides[at].second;
        if (next == fan.loop.front()) {
          fan.is_closed = true;
          break;
        }
        fan.loop.push_back(next);
        const auto onward = std::lower_bound(sides.begin(), sides.end(), std::pair{next, PointId{0}});
        if (onward == sides.end() || onward->first != next) break;
        at = static_cast<std::size_t>(onward - sides.begin());
      }
      fans_.push_back(std::move(fan));
    };
    for (std::size_t i = 0; i < sides.size(); ++i)
      if (!std::binary_search(heads.begin(), heads.end(), sides[i].first)) follow(i);
    for (std::size_t i = 0; i < sides.size(); ++i)
      if (!used[i]) follow(i);
    return true;
  }

  /// Where sheets bend, they bend along one line, which must remain an edge of all sheets through it: flat sheets are
  /// split along it. False when the line does not end in the same two corners for all of them.
  bool split_discs() {
    const auto open = std::find_if(fans_.begin(), fans_.end(), [](const Fan& f) { return !f.is_closed; });
    if (open == fans_.end()) return fans_.size() == 1;
    const auto ends = std::minmax(open->loop.front(), open->loop.back());
    const std::pair<PointId, PointId> line(ends.first, ends.second);
    for (std::size_t i = 0, n = fans_.size(); i < n; ++i) {
      if (!fans_[i].is_closed) {
        if (std::pair<PointId, PointId>(std::minmax({fans_[i].loop.front(), fans_[i].loop.back()})) != line)
          return false;
        continue;
      }
      Fan half{fans_[i].sheet, false, {}};
      std::vector<PointId>& loop = fans_[i].loop;
      const auto first = std::find(loop.begin(), loop.end(), line.first);
      std::rotate(loop.begin(), first, loop.end());
      const auto second = std::find(loop.begin(), loop.end(), line.second);
      if (loop.front() != line.first || second == loop.end()) return false;
      half.loop.assign(second, loop.end());
      half.loop.push_back(line.first);
      loop.erase(second + 1, loop.end());
      fans_[i].is_closed = false;
      fans_.push_back(std::move(half));
    }
    return true;
  }

  /// True if the sides that close the open fans cancel. Then the result remains closed.
  [[nodiscard]] bool ends_match() const {
    std::vector<std::pair<PointId, PointId>> forth, back;
    for (const Fan& fan : fans_) {
      if (fan.is_closed) continue;
      forth.emplace_back(fan.loop.front(), fan.loop.back());
      back.emplace_back(fan.loop.back(), fan.loop.front());
    }
    std::sort(forth.begin(), forth.end());
    std::sort(back.begin(), back.end());
    return forth == back;
  }

  const InputComplex& input_;
  const PointTable& points_;
  FacePlanes& planes_;
  const std::vector<PointId>& candidates_;
  std::vector<ResultTriangle>& triangles_;
  const std::vector<FaceOrigin>& origins_;
  std::vector<Index> place_;                                      ///< among the candidates, per point
  std::vector<boost::container::small_vector<Index, 8>> around_;  ///< triangles, per candidate
  std::vector<Sheet> sheets_;
  std::vector<Fan> fans_;
};

}  // namespace

std::vector<MeetingPlanes> remove_redundant_corners(const InputComplex& input, const PointTable& points,
                                                    FacePlanes& planes, const std::vector<PointId>& candidates,
                                                    std::vector<ResultTriangle>& triangles,
                                                    const std::vector<FaceOrigin>& origins) {
  return CornerRemover(input, points, planes, candidates, triangles, origins).remove_all();
}

}  // namespace strata
