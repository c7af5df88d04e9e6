#include <algorithm>
#include <array>
#include <utility>

#include "core/exact/pace.h"
#include "core/mesh/defect_list.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/fill_holes.h"
#include "core/mesh/orient.h"
#include "core/mesh/prepare.h"
#include "core/mesh/prepare_steps.h"

namespace strata {
namespace {

/// What is made a solid, and what is told of it.
struct Soup {
  MeshView mesh;
  std::size_t operand;
  const Monitor& monitor;
  std::vector<Defect> notes;

  /// With the notes so far.
  [[noreturn]] void refuse(std::vector<Defect> errors) const {
    errors.insert(errors.end(), notes.begin(), notes.end());
    throw InputError(std::move(errors), operand);
  }
};

/// Keeps the faces for which `keep` holds.
template <class Keep>
void keep_if(SourcedTriangles& faces, const Monitor& monitor, Keep keep) {
  SourcedTriangles kept;
  Pace pace(monitor);
  for (std::size_t i = 0; i < faces.triangles.size(); ++i) {
    pace.step();
    if (keep(i)) kept.add(faces.triangles[i], faces.sources[i]);
  }
  faces = std::move(kept);
}

void drop_repeated_vertices(Soup& soup, SourcedTriangles& faces) {
  DefectList list(DefectKind::degenerate_triangle, Severity::note, "the face was dropped");
  keep_if(faces, soup.monitor, [&](std::size_t i) {
    const Triangle& t = faces.triangles[i];
    if (!repeats_vertex(t)) return true;
    const std::uint32_t f = faces.sources[i];
    list.add(soup.mesh.vertices[t[0]], {f},
             [&] { return "two corners of face " + std::to_string(f) + " are one point"; });
    return false;
  });
  list.append_to(soup.notes);
}

/// True if the corners, in order, are an even permutation of their increasing order.
bool is_even(const Triangle& t) { return (t[0] < t[1]) == ((t[1] < t[2]) == (t[0] < t[2])); }

Triangle sorted(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

/// What becomes of faces with the same three vertices if both orientations occur equally often.
enum class OppositePairs : bool { dropped, one_kept };

/// Of the faces with the same three vertices at most one is kept.
void drop_duplicates(Soup& soup, OppositePairs opposite, SourcedTriangles& faces) {
  const auto& triangles = faces.triangles;
  std::vector<std::uint32_t> order(triangles.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  Pace pace(soup.monitor);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    pace.step();
    const Triangle s = sorted(triangles[a]), t = sorted(triangles[b]);
    return s != t ? s < t : a < b;
  });
  std::vector<bool> keep(triangles.size(), true);
  DefectList list(DefectKind::duplicate_face, Severity::note,
                  opposite == OppositePairs::dropped ? "equal faces were reduced to one, opposite pairs to none"
                                                     : "equal and opposite faces were reduced to one");
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    pace.step();
    std::int64_t net = 0;
    for (; end < order.size() && sorted(triangles[order[end]]) == sorted(triangles[order[begin]]); ++end) {
      net += is_even(triangles[order[end]]) ? 1 : -1;
    }
    if (end - begin == 1) continue;
    std::vector<std::uint32_t> same;
    bool kept_one = net == 0 && opposite == OppositePairs::dropped;
    for (std::size_t i = begin; i < end; ++i) {
      keep[order[i]] = !kept_one && (net == 0 || is_even(triangles[order[i]]) == (net > 0));
      kept_one = kept_one || keep[order[i]];
      same.push_back(faces.sources[order[i]]);
    }
    const std::size_t count = same.size();
    list.add(soup.mesh.vertices[triangles[order[begin]][0]], std::move(same),
             [&] { return std::to_string(count) + " faces have the same three vertices"; });
  }
  keep_if(faces, soup.monitor, [&](std::size_t i) { return keep[i]; });
  list.append_to(soup.notes);
}

/// Drops sheets that are open and consist only of zero-area faces, until there are none.
void drop_loose_flat_sheets(Soup& soup, SourcedTriangles& faces) {
  DefectList list(DefectKind::degenerate_triangle, Severity::note, "the face was dropped");
  for (bool dropped = true; dropped;) {
    dropped = false;
    std::vector<Triangle> oriented = faces.triangles;
    const Sheets sheets = orient_sheets(oriented, soup.mesh.vertices.size(), soup.monitor);
    const ZeroAreaTest is_zero(MeshView(soup.mesh.vertices, faces.triangles));
    std::vector<bool> keep(faces.triangles.size(), true);
    for (std::size_t s = 0; s < sheets.triangles.size(); ++s) {
      const auto& members = sheets.triangles[s];
      if (sheets.closed[s] || !std::all_of(members.begin(), members.end(), is_zero)) continue;
      dropped = true;
      for (const std::uint32_t t : members) {
        keep[t] = false;
        list.add(soup.mesh.vertices[faces.triangles[t][0]], {faces.sources[t]},
                 [&] { return "face " + std::to_string(faces.sources[t]) + " has zero area and bounds nothing"; });
      }
    }
    if (dropped) keep_if(faces, soup.monitor, [&](std::size_t i) { return keep[i]; });
  }
  list.append_to(soup.notes);
}

void add_note(std::vector<Defect>& notes, DefectKind kind, std::uint64_t count, std::string message,
              std::string remedy) {
  if (count == 0) return;
  Defect note;
  note.kind = kind;
  note.severity = Severity::note;
  note.count = count;
  note.message = std::move(message);
  note.remedy = std::move(remedy);
  notes.push_back(std::move(note));
}

void note_reversed(std::vector<Defect>& notes, const Sheets& sheets) {
  add_note(notes, DefectKind::inconsistent_orientation, sheets.reversed,
           std::to_string(sheets.reversed) + " faces were reversed to run against their neighbours",
           "nothing to do, or orient faces where the mesh is made");
}

/// Closed sheets face outwards, or inwards as the walls of cavities; those that are trusted stay if they face outwards.
void orient_shells(const Soup& soup, SourcedTriangles& faces, const Sheets& sheets, std::vector<Defect>& notes,
                   const std::vector<bool>& trusted = {}) {
  const Shells shells = orient_outwards(soup.mesh.vertices, faces.triangles, sheets, trusted, soup.monitor);
  add_note(notes, DefectKind::inside_out, shells.reversed,
           std::to_string(shells.reversed) + " shells were reversed; of all shells, " +
               std::to_string(shells.cavities) +
               " lie inside an odd number of others and bound cavities, the rest faces outwards",
           "orient shells where the mesh is made if something else is meant");
}

/// Orients all faces, or throws with the open edges and the notes so far.
void orient(Soup& soup, SourcedTriangles& faces) {
  const MeshView mesh = soup.mesh;
  const Sheets sheets = orient_sheets(faces.triangles, mesh.vertices.size(), soup.monitor);
  std::vector<Defect> of_shells;
  orient_shells(soup, faces, sheets, of_shells);
  std::vector<Defect> errors;
  find_open_edges(mesh.vertices, faces, errors, few_defects, soup.monitor);
  if (!errors.empty()) soup.refuse(std::move(errors));
  note_reversed(soup.notes, sheets);
  soup.notes.insert(soup.notes.end(), of_shells.begin(), of_shells.end());
}

Vertex middle_of(MeshView mesh, const Hole& hole) {
  Vertex p{};
  const auto n = static_cast<double>(hole.loop.size());
  for (const std::uint32_t v : hole.loop)
    for (std::size_t i = 0; i < 3; ++i) p[i] += mesh.vertices[v][i] / n;
  return p;
}

/// Adds what is missing for a closed chain, or throws where a loop has more edges than wanted.
void fill(Soup& soup, SourcedTriangles& faces, std::size_t most_edges, RepeatedEdges repeated_edges) {
  const MeshView mesh = soup.mesh;
  const std::vector<Hole> holes = find_holes(mesh.vertices, faces, soup.monitor);
  DefectList filled(DefectKind::open_edge, Severity::note, "it was filled: add what is missing there");
  DefectList refused(DefectKind::open_edge, Severity::error,
                     "add what is missing there, or allow holes of so many edges to be filled");
  for (const Hole& hole : holes)
    (hole.loop.size() > most_edges ? refused : filled).add(middle_of(mesh, hole), {hole.face_beside}, [&] {
      return "a hole is bounded by " + std::to_string(hole.loop.size()) + " open edges";
    });
  filled.append_to(soup.notes);
  if (refused.count() > 0) {
    std::vector<Defect> errors;
    refused.append_to(errors);
    soup.refuse(std::move(errors));
  }
  fill_holes(mesh.vertices, holes, faces, repeated_edges, soup.monitor);
}

int volume_sign(const Soup& soup, std::span<const Triangle> triangles) {
  return to_int(orientation(ExactMeshView(MeshView(soup.mesh.vertices, triangles), {}), soup.monitor));
}

/// Reverses the sheets that are not closed by themselves, and together are, where their volume is negative.
void orient_rest(const Soup& soup, SourcedTriangles& faces, const Sheets& sheets) {
  std::vector<std::uint32_t> rest;
  std::vector<Triangle> triangles;
  for (std::size_t s = 0; s < sheets.triangles.size(); ++s)
    if (!sheets.closed[s]) rest.insert(rest.end(), sheets.triangles[s].begin(), sheets.triangles[s].end());
  for (const std::uint32_t t : rest) triangles.push_back(faces.triangles[t]);
  if (volume_sign(soup, triangles) >= 0) return;
  for (const std::uint32_t t : rest) std::swap(faces.triangles[t][1], faces.triangles[t][2]);
}

/// Makes the chain of faces closed. Faces are reversed only where that leaves less open. A sheet in which none was is
/// trusted: it stays if it faces outwards, and if it is the wall of a cavity; inside out and in no other, it is
/// reversed. Other sheets are oriented by what they lie in, as where holes are refused. Does it enclose something?
bool closes(Soup& soup, SourcedTriangles& faces, std::size_t most_edges, RepeatedEdges repeated_edges) {
  const MeshView mesh = soup.mesh;
  const Monitor& monitor = soup.monitor;
  std::vector<Triangle> given = faces.triangles;
  if (const std::uint64_t open = open_uses(mesh.vertices, given, monitor); open != 0) {
    const Sheets sheets = orient_sheets(faces.triangles, mesh.vertices.size(), monitor);
    if (open_uses(mesh.vertices, faces.triangles, monitor) < open)
      note_reversed(soup.notes, sheets);
    else
      faces.triangles = given;
    fill(soup, faces, most_edges, repeated_edges);
  }
  if (volume_sign(soup, faces.triangles) < 0) {  // inside out as a whole
    for (Triangle& t : faces.triangles) std::swap(t[1], t[2]);
    for (Triangle& t : given) std::swap(t[1], t[2]);
    add_note(soup.notes, DefectKind::inside_out, faces.triangles.size(),
             "all faces were reversed: the mesh was inside out",
             "nothing to do, or orient faces where the mesh is made");
  }
  const Sheets sheets = orient_sheets(faces.triangles, mesh.vertices.size(), monitor);
  std::vector<bool> trusted;
  for (const auto& sheet : sheets.triangles)
    trusted.push_back(std::all_of(sheet.begin(), sheet.end(), [&](std::uint32_t t) {
      return t >= given.size() || faces.triangles[t] == given[t];
    }));
  orient_shells(soup, faces, sheets, soup.notes, trusted);
  orient_rest(soup, faces, sheets);
  return volume_sign(soup, faces.triangles) > 0;
}

/// How faces are made a closed chain. Each way is for what the one before makes nothing of.
struct Closing {
  OppositePairs opposite;
  RepeatedEdges repeated_edges;
};
constexpr std::array closings{
    Closing{OppositePairs::dropped, RepeatedEdges::allowed},
    // Two triangles that are folded: the filling of least area is the fold itself, turned round.
    Closing{OppositePairs::dropped, RepeatedEdges::avoided},
    // A model whose faces are all listed twice, to be seen from both sides.
    Closing{OppositePairs::one_kept, RepeatedEdges::allowed},
};

/// Faces without repeated vertices become a closed chain that encloses something, or it throws.
void close(Soup& soup, SourcedTriangles& faces, std::size_t most_edges) {
  const SourcedTriangles given = faces;
  const std::vector<Defect> noted = soup.notes;
  for (const auto& [opposite, repeated_edges] : closings) {
    drop_duplicates(soup, opposite, faces);
    drop_loose_flat_sheets(soup, faces);
    if (closes(soup, faces, most_edges, repeated_edges)) return;
    faces = given;
    soup.notes = noted;
  }
  Defect nothing;
  nothing.kind = DefectKind::empty_mesh;
  nothing.message = "the faces enclose no volume, even with all holes filled";
  nothing.remedy = "give a mesh whose faces surround something";
  soup.refuse({nothing});
}

}  // namespace

Prepared prepare_soup(MeshView mesh, Holes holes, std::size_t operand, std::size_t most_edges, const Monitor& monitor) {
  Prepared result;
  if (mesh.triangles.empty()) return result;
  Soup soup{mesh, operand, monitor, {}};
  SourcedTriangles faces = sound_faces(mesh, Severity::note, soup.notes, few_defects, monitor);
  const bool open = !screen({mesh.vertices, faces.triangles}, monitor).chain_closed;
  const std::uint64_t welded = weld(mesh.vertices, faces.triangles, monitor);
  if (open && welded > 0) soup.notes.push_back(weld_note(welded));
  drop_repeated_vertices(soup, faces);
  if (holes == Holes::filled) {
    close(soup, faces, most_edges);
  } else {
    drop_duplicates(soup, OppositePairs::dropped, faces);
    drop_loose_flat_sheets(soup, faces);
    orient(soup, faces);
  }
  const Removal removal = remove_zero_area(mesh.vertices, faces, monitor);
  if (!removal.removed.empty()) soup.notes.push_back(removal_note(mesh, removal));
  result.notes = std::move(soup.notes);
  result.mesh = Mesh{{mesh.vertices.begin(), mesh.vertices.end()}, std::move(faces.triangles)};
  result.source_face = std::move(faces.sources);
  return result;
}

}  // namespace strata
