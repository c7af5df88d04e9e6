#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/kernel/predicates.h"
#include "extensions/scene/layer_decomposition_data.h"
#include "extensions/scene/scene_data.h"
#include "strata/query.h"

namespace strata {
namespace {

struct Side {
  std::uint32_t a, b, face;
  friend auto operator<=>(const Side&, const Side&) = default;
};

/// The sides of all faces, those of one edge together.
std::vector<Side> sorted_sides(const InputComplex& input) {
  std::vector<Side> sides(std::size_t{3} * input.face_count());
  tbb::parallel_for(std::uint32_t{0}, input.face_count(), [&](std::uint32_t f) {
    const auto v = input.face(f);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = v[i], b = v[(i + 1) % 3];
      sides[3 * std::size_t{f} + i] = {std::min(a, b), std::max(a, b), f};
    }
  });
  tbb::parallel_sort(sides.begin(), sides.end());
  return sides;
}

Vertex unit_normal(const InputComplex& input, std::uint32_t face) {
  const auto v = input.face(face);
  const Vertex &a = input.vertex(v[0]), &b = input.vertex(v[1]), &c = input.vertex(v[2]);
  const Vertex u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, w{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  const double x = u[1] * w[2] - u[2] * w[1], y = u[2] * w[0] - u[0] * w[2], z = u[0] * w[1] - u[1] * w[0];
  const double length = std::hypot(x, y, z);
  return length > 0 ? Vertex{x / length, y / length, z / length} : Vertex{};
}

bool are_coplanar(const InputComplex& input, std::uint32_t f, std::uint32_t g) {
  const auto v = input.face(f);
  for (const std::uint32_t p : input.face(g))
    if (orient3d(input, v[0], v[1], v[2], p) != Sign::zero) return false;
  return true;
}

/// The kind of an edge in a drawing, by the faces around it; nullopt for edges within a plane or a smooth surface.
std::optional<EdgeKind> kind_of(const Visibility& visibility, std::span<const Side> sides, double crease_cosine) {
  const SignedCovering& covering = covering_of(visibility.decomposition());
  const InputComplex& input = input_complex_of(covering.scene());
  if (sides.size() == 1) return EdgeKind::loop;
  const auto orientation = [&](std::size_t i) { return covering.orientation(sides[i].face); };
  if (sides.size() > 2) return EdgeKind::crease;
  if (are_coplanar(input, sides[0].face, sides[1].face)) return std::nullopt;
  if (orientation(0) == Sign::zero && orientation(1) == Sign::zero) return std::nullopt;
  if (orientation(0) != orientation(1)) return EdgeKind::loop;
  const Vertex n = unit_normal(input, sides[0].face), m = unit_normal(input, sides[1].face);
  if (n[0] * m[0] + n[1] * m[1] + n[2] * m[2] < crease_cosine) return EdgeKind::crease;
  return std::nullopt;
}

/// The visible stretches of an edge as the border of one face or the other, united.
std::vector<Stretch> united(std::vector<Stretch> stretches) {
  std::sort(stretches.begin(), stretches.end(), [](const Stretch& a, const Stretch& b) { return a.from < b.from; });
  std::vector<Stretch> all;
  for (Stretch& s : stretches) {
    if (!all.empty() && s.from <= all.back().to) {
      all.back().to = std::max(all.back().to, s.to);
    } else {
      all.push_back(std::move(s));
    }
  }
  return all;
}

}  // namespace

std::vector<SeenEdge> find_seen_edges(const Visibility& visibility, double crease_angle, const Monitor& monitor) {
  const double crease_cosine = std::cos(crease_angle * 3.14159265358979323846 / 180);
  const auto sides = sorted_sides(input_complex_of(visibility.decomposition().scene()));
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (i == 0 || sides[i].a != sides[i - 1].a || sides[i].b != sides[i - 1].b) first.push_back(i);
  const std::size_t count = first.size();
  first.push_back(sides.size());
  std::vector<SeenEdge> edges(count);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t e) {
    monitor.check();
    const std::span<const Side> around = std::span(sides).subspan(first[e], first[e + 1] - first[e]);
    const auto kind = kind_of(visibility, around, crease_cosine);
    if (!kind) return;
    std::vector<Stretch> seen;
    for (const Side& s : around)
      for (Stretch& stretch : visibility.seen_along(s.face, s.a, s.b)) seen.push_back(std::move(stretch));
    edges[e] = {around[0].a, around[0].b, *kind, united(std::move(seen))};
  });
  std::erase_if(edges, [](const SeenEdge& e) { return e.seen.empty(); });
  return edges;
}

}  // namespace strata
