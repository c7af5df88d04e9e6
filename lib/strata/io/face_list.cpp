#include "strata/io/face_list.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace strata::io {
namespace {

/// How many faces, and which came first.
struct Tally {
  std::uint64_t count = 0;
  std::uint64_t first = 0;

  void add(std::uint64_t face) {
    if (count++ == 0) first = face;
  }
  void note(MeshFile& file, const char* one, const char* many, const char* what) const {
    if (count == 0) return;
    file.notes.push_back((count == 1 ? std::string("1 ") + one : std::to_string(count) + " " + many) + " " + what +
                         "; the first is face " + std::to_string(first) + " (counted from 0)");
  }
};

bool has_three_different(std::span<const std::uint32_t> c) {
  const auto second = std::find_if(c.begin(), c.end(), [&](std::uint32_t v) { return v != c[0]; });
  return std::any_of(second, c.end(), [&](std::uint32_t v) { return v != c[0] && v != *second; });
}

}  // namespace

void FaceList::drop() { polygons_.push_back({count_++, triangles_.size(), corners_.size(), 0}); }

void FaceList::add(std::span<const std::uint32_t> corners) {
  if (corners.size() == 3) return add(Triangle{corners[0], corners[1], corners[2]});
  const std::size_t first = corners_.size();
  for (const std::uint32_t v : corners)
    if (corners_.size() == first || corners_.back() != v) corners_.push_back(v);
  while (corners_.size() > first + 1 && corners_.back() == corners_[first]) corners_.pop_back();
  const std::span<const std::uint32_t> kept(corners_.begin() + static_cast<std::ptrdiff_t>(first), corners_.end());
  if (!has_three_different(kept)) {
    corners_.resize(first);
    return drop();
  }
  polygons_.push_back({count_++, triangles_.size(), first, kept.size()});
}

void FaceList::finish(MeshFile& file, const std::string& name) {
  std::uint64_t total = triangles_.size();
  for (const Polygon& p : polygons_) total += p.triangle_count();
  if (total > most_items || count_ > most_items || file.mesh.vertices.size() > most_items)
    throw IoError(name, {}, "more than 2^32 - 2 vertices or triangles");
  if (polygons_.empty())
    file.mesh.triangles = std::move(triangles_);
  else
    merge(file);
}

std::vector<std::size_t> FaceList::places() const {
  std::vector<std::size_t> place;
  place.reserve(polygons_.size() + 1);
  std::size_t from_polygons = 0;
  for (const Polygon& p : polygons_) {
    place.push_back(p.triangles_before + from_polygons);
    from_polygons += p.triangle_count();
  }
  place.push_back(triangles_.size() + from_polygons);
  return place;
}

PolygonShape FaceList::divide(const Polygon& p, MeshFile& file, std::size_t place) const {
  if (p.corners == 0) return {};
  const std::span<const std::uint32_t> corners(corners_.data() + p.first, p.corners);
  std::vector<Vertex> loop;
  loop.reserve(corners.size());
  for (const std::uint32_t v : corners) loop.push_back(file.mesh.vertices[v]);
  const std::span<Triangle> own(file.mesh.triangles.data() + place, p.triangle_count());
  const PolygonShape shape = triangulate(loop, own);
  for (Triangle& t : own) t = {corners[t[0]], corners[t[1]], corners[t[2]]};
  std::fill_n(file.polygon_of_triangle.data() + place, own.size(), static_cast<std::uint32_t>(p.face));
  return shape;
}

void FaceList::merge(MeshFile& file) const {
  const auto place = places();
  file.mesh.triangles.resize(place.back());
  file.polygon_of_triangle.resize(place.back());
  std::vector<PolygonShape> shapes(polygons_.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, polygons_.size(), 256), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) shapes[i] = divide(polygons_[i], file, place[i]);
  });
  // The triangles of the file between two polygons keep their order.
  std::size_t source = 0, target = 0;
  std::uint64_t face = 0;
  const auto copy_until = [&](std::size_t end) {
    for (; source < end; ++source, ++target, ++face) {
      file.mesh.triangles[target] = triangles_[source];
      file.polygon_of_triangle[target] = static_cast<std::uint32_t>(face);
    }
  };
  for (const Polygon& p : polygons_) {
    copy_until(p.triangles_before);
    target += p.triangle_count();
    ++face;
  }
  copy_until(triangles_.size());
  note_shapes(file, shapes);
}

void FaceList::note_shapes(MeshFile& file, std::span<const PolygonShape> shapes) const {
  Tally dropped, bent, crossing;
  for (std::size_t i = 0; i < polygons_.size(); ++i) {
    if (polygons_[i].corners == 0) dropped.add(polygons_[i].face);
    if (!shapes[i].planar) bent.add(polygons_[i].face);
    if (!shapes[i].simple) crossing.add(polygons_[i].face);
  }
  dropped.note(file, "face", "faces", "with fewer than three different vertices left out");
  bent.note(file, "polygon", "polygons", "not planar in doubles, triangulated as seen along an axis");
  crossing.note(file, "polygon", "polygons", "not simple (sides that cross or double back), triangulated all the same");
}

}  // namespace strata::io
