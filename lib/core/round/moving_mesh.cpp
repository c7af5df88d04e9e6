#include "core/round/moving_mesh.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "core/containers/collect.h"
#include "core/containers/huge_pages.h"
#include "core/round/distances.h"

namespace strata {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint32_t run_length = 64;

/// Of a triangle, and, where doubles are rounded, of the points that they stand for. What is beyond the largest double
/// meets no other box.
Box box_around(MeshView mesh, std::uint32_t face) {
  constexpr double largest = std::numeric_limits<double>::max();
  Box box = box_of(mesh, face);
  for (std::size_t i = 0; i < 3; ++i) {
    box.lower[i] = std::nextafter(box.lower[i], -largest);
    box.upper[i] = std::nextafter(box.upper[i], largest);
  }
  return box;
}

/// To the last bit: 0 is not -0.
bool are_same(const Vertex& a, const Vertex& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

bool all_stay(MeshView mesh, std::span<const VertexMove> moves) {
  std::atomic<bool> stay = true;
  tbb::parallel_for(std::size_t{0}, moves.size(), [&](std::size_t n) {
    const VertexMove& m = moves[n];
    if (m.becomes != m.vertex || !are_same(m.to, mesh.vertices[m.vertex])) stay.store(false, std::memory_order_relaxed);
  });
  return stay;
}

void drop_unused_vertices(Mesh& mesh) {
  std::vector<std::uint32_t> number(mesh.vertices.size(), none);
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t) number[v] = 0;
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == none) continue;
    mesh.vertices[count] = mesh.vertices[v];
    number[v] = count++;
  }
  mesh.vertices.resize(count);
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& v : t) v = number[v];
}

}  // namespace

VertexMove move_to_grid(std::uint32_t vertex, const Vertex& at, bool is_rounded, const GridRounding& grid,
                        int bits_less) {
  const Vertex to = grid(at, bits_less);
  return {vertex, vertex, to, distance(at, to) + (is_rounded ? half_unit(at) : 0)};
}

MovingMesh::MovingMesh(Mesh mesh, std::vector<std::uint32_t> source_face, std::vector<double> moved)
    : mesh_(std::move(mesh)), source_face_(std::move(source_face)), moved_(std::move(moved)), swept_(std::in_place) {}

void MovingMesh::copy_given() {
  if (!boundary_) return;
  const MeshView from = *std::exchange(boundary_, std::nullopt);
  const std::vector<double> of_changed = std::move(moved_);
  moved_.clear();
  const auto reserve = [](auto& list, std::size_t size) { list.reserve(size + size / 8); };  // repairs add some
  tbb::parallel_invoke(
      [&] {
        reserve(mesh_.vertices, from.vertices.size());
        mesh_.vertices.assign(from.vertices.begin(), from.vertices.end());
      },
      [&] {
        reserve(mesh_.triangles, from.triangles.size());
        mesh_.triangles.assign(from.triangles.begin(), from.triangles.end());
      },
      [&] {
        reserve(source_face_, from.triangles.size());
        resize_fresh(source_face_, from.triangles.size());
        std::iota(source_face_.begin(), source_face_.end(), 0U);
        reserve(moved_, from.triangles.size());
        resize_fresh(moved_, from.triangles.size());
        for (std::size_t n = 0; n < changed_.size(); ++n) moved_[changed_[n]] = of_changed[n];
      });
}

std::vector<std::uint32_t> MovingMesh::faces_that_meet(const BoxCover& boxes) const {
  const auto meets = [&](std::uint32_t f) { return is_left(f) && boxes.meets(box(f)); };
  const auto count = static_cast<std::uint32_t>(mesh().triangles.size());
  if (runs_.empty()) return collect(count, meets);
  const std::vector<std::uint32_t> near =
      collect(runs_.size(), [&](std::uint32_t r) { return !runs_[r].empty() && boxes.meets(runs_[r]); });
  std::vector<std::vector<std::uint32_t>> found(near.size());
  tbb::parallel_for(std::size_t{0}, near.size(), [&](std::size_t n) {
    const std::uint32_t first = near[n] * run_length;
    for (std::uint32_t f = first; f < std::min(first + run_length, count); ++f)
      if (meets(f)) found[n].push_back(f);
  });
  std::vector<std::uint32_t> faces;
  for (const std::vector<std::uint32_t>& some : found) faces.insert(faces.end(), some.begin(), some.end());
  return faces;
}

void MovingMesh::include_in_run(std::uint32_t face) {
  if (runs_.empty()) return;
  runs_.resize(std::max<std::size_t>(runs_.size(), face / run_length + 1));
  runs_[face / run_length].include(box(face));
}

void MovingMesh::forget_stars(const Triangle& at) {
  if (!stars_) return;
  for (const std::uint32_t v : at) stars_->forget(v);
}

void MovingMesh::move(std::span<const VertexMove> moves) {
  if (moves.empty()) return;
  if (!changed_.empty() || !all_stay(this->mesh(), moves)) copy_given();
  const MeshView mesh = this->mesh();
  std::vector<std::uint32_t> move_at;  // per vertex
  resize_fresh(move_at, mesh.vertices.size(), none);
  tbb::parallel_for(std::size_t{0}, moves.size(),
                    [&](std::size_t n) { move_at[moves[n].vertex] = static_cast<std::uint32_t>(n); });
  const std::uint32_t first_to_move = moves.front().vertex;  // constructed vertices are the last ones of a result
  std::vector<std::uint32_t> touched = collect(mesh.triangles.size(), [&](std::uint32_t f) {
    const auto [a, b, c] = mesh.triangles[f];
    if (a < first_to_move && b < first_to_move && c < first_to_move) return false;
    return (move_at[a] != none || move_at[b] != none || move_at[c] != none) && !repeats_vertex(mesh.triangles[f]);
  });
  if (2 * touched.size() > mesh.triangles.size()) swept_.reset();
  if (is_as_given()) moved_.resize(touched.size());
  const std::size_t before = swept_ ? swept_->size() : 0;
  if (swept_) swept_->resize(before + touched.size());
  std::vector<char> is_elsewhere(touched.size(), 0);
  tbb::parallel_for(std::size_t{0}, touched.size(), [&](std::size_t n) {
    const std::uint32_t f = touched[n];
    const Triangle corners = mesh.triangles[f];
    if (swept_) (*swept_)[before + n] = box_around(mesh, f);
    double way = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = corners[i];
      if (move_at[v] == none) continue;
      const VertexMove& m = moves[move_at[v]];
      if (swept_) (*swept_)[before + n].include(m.to);
      way = std::max(way, m.way);
      if (m.way > 0 || m.to != mesh.vertices[v]) is_elsewhere[n] = 1;
      if (!is_as_given()) mesh_.triangles[f][i] = m.becomes;
    }
    if (is_elsewhere[n] != 0) forget_stars(corners);
    moved_[is_as_given() ? n : f] += way;
  });
  for (const VertexMove& m : moves) {
    if (is_as_given()) break;
    mesh_.vertices[m.vertex] = m.to;
    has_unused_ = has_unused_ || m.becomes != m.vertex;
    if (stars_ && m.becomes != m.vertex && !stars_->at(m.vertex)) stars_->forget(m.becomes);
  }
  for (std::size_t n = 0; n < touched.size() && !runs_.empty(); ++n)
    if (is_elsewhere[n] != 0) include_in_run(touched[n]);
  if (!swept_ && !is_as_given()) {  // names of edges do not matter then
    std::size_t kept = 0;
    for (std::size_t n = 0; n < touched.size(); ++n)
      if (is_elsewhere[n] != 0) touched[kept++] = touched[n];
    touched.resize(kept);
  }
  add_changed(std::move(touched));
}

void MovingMesh::flip(std::span<const FlatFlip> flips) {
  copy_given();
  std::vector<std::uint32_t> touched;
  for (const auto& [cap, base, corner, way] : flips) {
    const Triangle t = mesh_.triangles[cap], u = mesh_.triangles[base];
    const std::uint32_t c = t[corner], a = t[(corner + 1) % 3], b = t[(corner + 2) % 3];
    const std::uint32_t d = *std::find_if(u.begin(), u.end(), [&](std::uint32_t v) { return v != a && v != b; });
    Box passed = box(cap);
    passed.include(box(base));
    if (swept_) swept_->push_back(passed);
    mesh_.triangles[cap] = {a, d, c};
    mesh_.triangles[base] = {d, b, c};
    source_face_[cap] = source_face_[base];
    moved_[base] += way;
    moved_[cap] = moved_[base];
    include_in_run(cap);
    include_in_run(base);
    forget_stars(t);
    forget_stars(u);
    lose_side(a, b);
    touched.insert(touched.end(), {cap, base});
  }
  add_changed(std::move(touched));
}

void MovingMesh::cancel(std::span<const std::pair<std::uint32_t, std::uint32_t>> opposites) {
  copy_given();
  for (const auto& [face, opposite] : opposites) {
    const Triangle t = mesh_.triangles[face];
    forget_stars(t);
    for (std::size_t i = 0; i < 3; ++i) lose_side(t[i], t[(i + 1) % 3]);
    mesh_.triangles[face] = mesh_.triangles[opposite] = {t[0], t[0], t[0]};
  }
  has_unused_ = has_unused_ || !opposites.empty();
}

void MovingMesh::replace(std::span<const std::uint32_t> faces, std::span<const Triangle> by, double way) {
  copy_given();
  Box passed;
  double moved = 0;
  for (const std::uint32_t f : faces) {
    const Triangle t = mesh_.triangles[f];
    passed.include(box(f));
    moved = std::max(moved, moved_[f]);
    forget_stars(t);
    for (std::size_t i = 0; i < 3; ++i) lose_side(t[i], t[(i + 1) % 3]);
    mesh_.triangles[f] = {t[0], t[0], t[0]};
  }
  for (const Triangle& t : by)
    for (const std::uint32_t v : t) passed.include(mesh_.vertices[v]);
  if (swept_) swept_->push_back(passed);
  std::vector<std::uint32_t> added;
  for (const Triangle& t : by) {
    forget_stars(t);
    added.push_back(static_cast<std::uint32_t>(mesh_.triangles.size()));
    mesh_.triangles.push_back(t);
    source_face_.push_back(source_face_[faces.front()]);
    moved_.push_back(moved + way);
    include_in_run(added.back());
  }
  has_unused_ = true;
  add_changed(std::move(added));
}

void MovingMesh::resolve(std::span<const std::uint32_t> gone, std::span<const PartOfTriangle> parts) {
  copy_given();
  for (const PartOfTriangle& part : parts) {
    mesh_.triangles.push_back(part.corners);
    source_face_.push_back(source_face_[part.of]);
    moved_.push_back(moved_[part.of]);
    include_in_run(static_cast<std::uint32_t>(mesh_.triangles.size() - 1));
  }
  for (const std::uint32_t f : gone) mesh_.triangles[f].fill(mesh_.triangles[f][0]);
  has_unused_ = true;
  changed_.clear();
  swept_.emplace();
  stars_.reset();
  lost_sides_.clear();
}

std::uint32_t MovingMesh::add_vertex(const Vertex& at) {
  copy_given();
  mesh_.vertices.push_back(at);
  if (stars_) stars_->add_vertex();
  return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
}

void MovingMesh::lose_side(std::uint32_t a, std::uint32_t b) {
  if (swept_) lost_sides_.insert(std::minmax(a, b));
}

void MovingMesh::set_searched(const std::vector<std::uint32_t>& wrong) {
  if (swept_) return;
  copy_given();
  changed_ = wrong;
}

void MovingMesh::set_searched(const std::vector<std::uint32_t>& wrong, EmbeddedStars stars) {
  set_searched(wrong);
  if (swept_) return;
  stars_ = std::move(stars);
  const std::size_t count = mesh_.triangles.size();
  runs_.assign((count + run_length - 1) / run_length, Box());
  tbb::parallel_for(std::size_t{0}, runs_.size(), [&](std::size_t r) {
    for (std::size_t f = r * run_length; f < std::min(count, (r + 1) * run_length); ++f)
      if (is_left(static_cast<std::uint32_t>(f))) runs_[r].include(box(static_cast<std::uint32_t>(f)));
  });
}

void MovingMesh::add_changed(std::vector<std::uint32_t> faces) {
  if (!std::is_sorted(faces.begin(), faces.end())) std::sort(faces.begin(), faces.end());
  if (changed_.empty()) std::swap(changed_, faces);
  if (faces.empty()) return;
  std::vector<std::uint32_t> all;
  std::set_union(changed_.begin(), changed_.end(), faces.begin(), faces.end(), std::back_inserter(all));
  changed_ = std::move(all);
}

MovingMesh::Parts MovingMesh::take() && {
  copy_given();
  const auto gone = collect(mesh_.triangles.size(), [&](std::uint32_t f) { return !is_left(f); });
  const auto leave_out = [&gone](auto& list) {
    if (gone.empty()) return;
    auto to = list.begin() + gone.front();
    for (std::size_t n = 0; n < gone.size(); ++n)
      to = std::copy(list.begin() + gone[n] + 1, n + 1 < gone.size() ? list.begin() + gone[n + 1] : list.end(), to);
    list.erase(to, list.end());
  };
  tbb::parallel_invoke([&] { leave_out(mesh_.triangles); }, [&] { leave_out(source_face_); },
                       [&] { leave_out(moved_); });
  if (has_unused_) drop_unused_vertices(mesh_);
  return {std::move(mesh_), std::move(source_face_), std::move(moved_)};
}

}  // namespace strata
