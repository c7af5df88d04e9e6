#include <algorithm>
#include <array>
#include <set>
#include <string>

#include "extensions/planar/gather.h"
#include "extensions/planar/predicates.h"
#include "strata/planar.h"

namespace strata::planar {
namespace {

/// That a vertex of the arrangement is a vertex of a loop, or inside an edge.
struct Incidence {
  std::uint32_t at = 0;
  bool is_inside = false;
  std::uint32_t number = 0;  ///< of the loops' vertex, or of the edge

  friend auto operator<=>(const Incidence&, const Incidence&) = default;
};

/// An edge along a piece, which is given by its ends.
struct AlongPiece {
  std::array<std::uint32_t, 2> ends{};
  std::uint32_t edge = 0;
};

class MeetingCollector {
 public:
  explicit MeetingCollector(const Loops& loops) : loops_(loops), gathered_(gather(std::array{Operand(loops)}, true)) {
    arrangement_ = arrange(std::move(gathered_.segments));
  }

  std::vector<SelfMeeting> collect() {
    add_points();
    add_overlaps();
    add_lone_vertices();
    return std::move(found_);
  }

 private:
  void add_points() {
    std::vector<Incidence> all;
    all.reserve(loops_.vertices.size());
    for (std::uint32_t i = 0; i < loops_.vertices.size(); ++i) all.push_back({vertex(loops_.vertices[i]), false, i});
    for (std::uint32_t s = 0; s < gathered_.edge_of.size(); ++s)
      for (std::uint32_t k = arrangement_.first_piece[s] + 1; k < arrangement_.first_piece[s + 1]; ++k)
        all.push_back({arrangement_.pieces[k][0], true, gathered_.edge_of[s]});
    std::sort(all.begin(), all.end());
    for (auto first = all.begin(), last = first; first != all.end(); first = last) {
      last = std::find_if(first, all.end(), [&](const Incidence& i) { return i.at != first->at; });
      if (last - first == 1) continue;
      std::vector<std::uint32_t> vertices, edges;
      for (auto i = first; i != last; ++i) (i->is_inside ? edges : vertices).push_back(i->number);
      if (vertices.size() > 1) add(SelfMeetingKind::vertex_on_vertex, first->at, vertices, {});
      if (!vertices.empty() && !edges.empty()) add(SelfMeetingKind::vertex_on_edge, first->at, vertices, edges);
      if (vertices.empty()) add(SelfMeetingKind::edges_crossing, first->at, {}, edges);
    }
  }
  void add_overlaps() {
    std::vector<AlongPiece> all;
    all.reserve(arrangement_.pieces.size());
    for (std::uint32_t s = 0; s < gathered_.edge_of.size(); ++s)
      for (std::uint32_t k = arrangement_.first_piece[s]; k < arrangement_.first_piece[s + 1]; ++k) {
        const auto [p, q] = arrangement_.pieces[k];
        all.push_back({{std::min(p, q), std::max(p, q)}, gathered_.edge_of[s]});
      }
    std::stable_sort(all.begin(), all.end(), [](const AlongPiece& a, const AlongPiece& b) { return a.ends < b.ends; });
    for (auto first = all.begin(), last = first; first != all.end(); first = last) {
      last = std::find_if(first, all.end(), [&](const AlongPiece& a) { return a.ends != first->ends; });
      if (last - first == 1) continue;
      std::vector<std::uint32_t> through;
      for (auto a = first; a != last; ++a) through.push_back(a->edge);
      add(SelfMeetingKind::edges_overlapping, first->ends[0], {}, std::move(through));
      found_.back().to = exact_position(arrangement_.places, first->ends[1]);
    }
  }
  void add_lone_vertices() {
    for (std::uint32_t l = 0; l < loops_.size(); ++l)
      if (loops_.loop(l).size() == 1)
        add(SelfMeetingKind::lone_vertex, vertex(loops_.loop(l).front()), {loops_.first_vertex[l]}, {});
  }
  void add(SelfMeetingKind kind, std::uint32_t v, std::vector<std::uint32_t> vertices,
           std::vector<std::uint32_t> edges) {
    found_.push_back({kind, exact_position(arrangement_.places, v), {}, std::move(vertices), std::move(edges)});
  }
  [[nodiscard]] std::uint32_t vertex(std::uint32_t p) const { return arrangement_.vertex_of[gathered_.name_of[0][p]]; }

  const Loops& loops_;
  Gathered gathered_;
  Arrangement arrangement_;
  std::vector<SelfMeeting> found_;
};

}  // namespace

std::string_view name(SelfMeetingKind kind) {
  switch (kind) {
    case SelfMeetingKind::vertex_on_vertex:
      return "vertex on vertex";
    case SelfMeetingKind::vertex_on_edge:
      return "vertex on edge";
    case SelfMeetingKind::edges_crossing:
      return "edges crossing";
    case SelfMeetingKind::edges_overlapping:
      return "edges overlapping";
    case SelfMeetingKind::lone_vertex:
      return "loop of one vertex";
  }
  return "";
}

std::vector<SelfMeeting> self_intersections(const Loops& loops) { return MeetingCollector(loops).collect(); }

bool is_clean(const Loops& loops) {
  for (std::uint32_t l = 0; l < loops.size(); ++l)
    if (loops.loop(l).size() < 3) return false;
  return self_intersections(loops).empty();
}

std::vector<SelfMeeting> rounding_conflicts(const Region& region) {
  const Places& places = region.loops.places;
  if (places.error.empty()) return {};
  Loops rounded;
  rounded.places.place = places.place;
  rounded.vertices = region.loops.vertices;
  rounded.edge_line.assign(rounded.vertices.size(), none);
  rounded.first_vertex = region.loops.first_vertex;
  std::vector<SelfMeeting> conflicts = self_intersections(rounded);
  std::erase_if(conflicts, [&](const SelfMeeting& m) {
    const auto is_same = [&](std::uint32_t i) { return rounded.vertices[i] == rounded.vertices[m.vertices.front()]; };
    return m.kind == SelfMeetingKind::vertex_on_vertex && std::all_of(m.vertices.begin(), m.vertices.end(), is_same);
  });
  return conflicts;
}

std::vector<std::string> validate(const Region& region) {
  std::vector<std::string> broken;
  std::vector<std::uint32_t> loop_of;
  for (std::uint32_t l = 0; l < region.loops.size(); ++l) loop_of.resize(region.loops.first_vertex[l + 1], l);
  for (const SelfMeeting& m : self_intersections(region.loops)) {
    std::set<std::uint32_t> touching;
    for (const std::uint32_t v : m.vertices) touching.insert(loop_of[v]);
    if (m.kind != SelfMeetingKind::vertex_on_vertex) {
      broken.push_back("loops meet other than in vertices: " + std::string(name(m.kind)));
    } else if (touching.size() < m.vertices.size()) {
      broken.emplace_back("a loop comes to a vertex twice");
    }
  }
  if (broken.empty() && canonical_form(fill({region.loops, FillRule::positive})) != canonical_form(region))
    broken.emplace_back("loops are not what bounds their inside");
  return broken;
}

}  // namespace strata::planar
