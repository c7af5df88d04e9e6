#include "core/io/face_list.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

#include "core/containers/huge_pages.h"
#include "core/io/tally.h"
#include "core/io/triangulate.h"

namespace strata::io {
namespace {

/// The faces that require a note.
struct Findings {
  Tally dropped, bent, crossing;

  void add(const Findings& later) {
    dropped.add(later.dropped);
    bent.add(later.bent);
    crossing.add(later.crossing);
  }
  void note(MeshFile& file) const {
    dropped.note_dropped(file);
    bent.note(file, "polygon", "polygons", "not planar in doubles, triangulated as seen along an axis");
    crossing.note(file, "polygon", "polygons",
                  "not simple (sides that cross or double back), triangulated all the same");
  }
};

/// One start per list, and the totals at the end.
std::vector<ListStart> starts_of(std::span<const FaceList> lists) {
  std::vector<ListStart> starts{{}};
  for (const FaceList& list : lists)
    starts.push_back({starts.back().face + list.count(), starts.back().triangle + list.triangle_count()});
  return starts;
}

bool has_three_different(std::span<const std::uint32_t> c) {
  const auto second = std::find_if(c.begin(), c.end(), [&](std::uint32_t v) { return v != c[0]; });
  return std::any_of(second, c.end(), [&](std::uint32_t v) { return v != c[0] && v != *second; });
}

/// Writes the triangles of one list to their position in the file.
class ListWriter {
 public:
  ListWriter(MeshFile& file, ListStart start) : file_(file), face_(start.face), triangle_(start.triangle) {}

  Findings write(const FaceList& list) {
    write_triangles(list.triangles());
    std::span<const std::uint32_t> corners = list.corners();
    for (const std::uint32_t size : list.sizes()) {
      if (size == 0)
        findings_.dropped.add(face_);
      else
        write_polygon(corners.first(size));
      corners = corners.subspan(size);
      ++face_;
    }
    return findings_;
  }

 private:
  void write_triangles(std::span<const Triangle> triangles) {
    std::copy(triangles.begin(), triangles.end(), file_.mesh.triangles.data() + triangle_);
    if (!file_.polygon_of_triangle.empty()) {
      const auto faces = std::span(file_.polygon_of_triangle).subspan(triangle_, triangles.size());
      std::iota(faces.begin(), faces.end(), static_cast<std::uint32_t>(face_));
    }
    face_ += triangles.size();
    triangle_ += triangles.size();
  }
  void write_polygon(std::span<const std::uint32_t> corners) {
    const auto own = std::span(file_.mesh.triangles).subspan(triangle_, corners.size() - 2);
    std::fill_n(file_.polygon_of_triangle.data() + triangle_, own.size(), static_cast<std::uint32_t>(face_));
    triangle_ += own.size();
    if (corners.size() == 3)
      own[0] = {corners[0], corners[1], corners[2]};
    else
      divide(corners, own);
  }
  void divide(std::span<const std::uint32_t> corners, std::span<Triangle> own) {
    loop_.clear();
    for (const std::uint32_t v : corners) loop_.push_back(file_.mesh.vertices[v]);
    const PolygonShape shape = triangulate(loop_, own);
    for (Triangle& t : own) t = {corners[t[0]], corners[t[1]], corners[t[2]]};
    if (!shape.planar) findings_.bent.add(face_);
    if (!shape.simple) findings_.crossing.add(face_);
  }

  MeshFile& file_;
  std::uint64_t face_;
  std::uint64_t triangle_;
  std::vector<Vertex> loop_;
  Findings findings_;
};

}  // namespace

void FaceList::add_sized(std::span<const std::uint32_t> corners) {
  const std::size_t first = corners_.size();
  for (const std::uint32_t v : corners)
    if (corners_.size() == first || corners_.back() != v) corners_.push_back(v);
  while (corners_.size() > first + 1 && corners_.back() == corners_[first]) corners_.pop_back();
  const std::span<const std::uint32_t> kept(corners_.begin() + static_cast<std::ptrdiff_t>(first), corners_.end());
  if (!has_three_different(kept)) corners_.resize(first);
  const std::size_t size = corners_.size() - first;
  sizes_.push_back(static_cast<std::uint32_t>(size));
  if (size > 0) triangles_of_polygons_ += size - 2;
}

void FaceList::shift(std::uint32_t by) {
  for (Triangle& t : triangles_) t = {t[0] + by, t[1] + by, t[2] + by};
  for (std::uint32_t& v : corners_) v += by;
}

void gather_faces(std::span<const FaceList> lists, MeshFile& file, const std::string& name) {
  const auto starts = starts_of(lists);
  const auto [faces, triangles] = starts.back();
  if (std::max({faces, triangles, std::uint64_t{file.mesh.vertices.size()}}) > most_items)
    throw IoError(name, {}, "more than 2^32 - 2 vertices or triangles");
  const bool plain = std::all_of(lists.begin(), lists.end(), [](const auto& l) { return l.sizes().empty(); });
  resize_fresh(file.mesh.triangles, triangles);
  if (!plain) resize_fresh(file.polygon_of_triangle, triangles);
  std::vector<Findings> findings(lists.size());
  tbb::parallel_for(std::size_t{0}, lists.size(),
                    [&](std::size_t i) { findings[i] = ListWriter(file, starts[i]).write(lists[i]); });
  Findings all;
  for (const Findings& f : findings) all.add(f);
  all.note(file);
}

}  // namespace strata::io
