#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "core/exact/finite.h"
#include "core/exact/pace.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/prepare.h"
#include "core/mesh/product_sum.h"
#include "core/mesh/zero_area.h"

namespace strata {
namespace {

// The work is divided into at most 256 chunks whose bounds depend on the input alone, and partial results are added in
// order. So the result does not depend on threads.
constexpr std::size_t max_chunks = 256;
constexpr std::size_t min_chunk = 4096;

struct Chunks {
  std::size_t items;
  std::size_t size;
  std::size_t count;

  explicit Chunks(std::size_t n)
      : items(n), size(std::max(min_chunk, (n + max_chunks - 1) / max_chunks)), count((n + size - 1) / size) {}

  template <class Visit>
  void for_each(const Monitor& monitor, Visit visit) const {  // visit(chunk, first, last)
    const auto one = [&](std::size_t k) {
      monitor.check();
      visit(k, k * size, std::min(items, (k + 1) * size));
    };
    if (count == 1) return one(0);
    tbb::parallel_for(std::size_t{0}, count, one);
  }
};

using Sum = __int128;

/// A fixed random number of 60 bits and a sign per edge, negated for the reversed edge. For independent numbers, a
/// chain that is not closed sums to zero with probability <= 2^-61: given all others, at most one value of one number
/// leads to zero (sums do not wrap around). The mixer multiplies, folds and multiplies, as the finalizers of MurmurHash
/// do; the upper bits of the last product depend on all of the key. An edge from a vertex to itself has a number too.
inline std::int64_t edge_number(std::uint32_t from, std::uint32_t to) {
  const std::uint64_t low = std::min(from, to), high = std::max(from, to);
  std::uint64_t h = (low << 32 | high) * 0x9E3779B97F4A7C15U;
  h = (h ^ h >> 32) * 0xBF58476D1CE4E5B9U;
  const std::int64_t reversed = -static_cast<std::int64_t>(from > to);
  return ((static_cast<std::int64_t>(h) >> 3) ^ reversed) - reversed;
}

/// The sum over the sides of a triangle; below 2^62 in size.
inline std::int64_t boundary_number(const Triangle& t) {
  return edge_number(t[0], t[1]) + edge_number(t[1], t[2]) + edge_number(t[2], t[0]);
}

/// The box of a triangle. Its corners are compared with each other first, because comparisons with the box of the whole
/// run depend on the previous ones.
Box box_of(const Vertex& p, const Vertex& q, const Vertex& r) {
  Box box;
  for (std::size_t i = 0; i < 3; ++i) {
    box.lower[i] = std::min(std::min(p[i], q[i]), r[i]);
    box.upper[i] = std::max(std::max(p[i], q[i]), r[i]);
  }
  return box;
}

/// The sums over a run of triangles.
struct Tally {
  Sum chain = 0;      ///< sum of edge numbers
  double volume = 0;  ///< sum of det(a-o, b-o, c-o), rounded
  double size = 0;    ///< sum of |b-a| |c-a| in the maximum norm: the scale of rounding errors
  Box box;            ///< of the vertices, if they are finite
  bool finite = true;
  bool indices_valid = true;
  bool degenerate = false;

  void add(const Tally& other) {
    chain += other.chain;
    volume += other.volume;
    size += other.size;
    box.include(other.box);
    finite = finite && other.finite;
    indices_valid = indices_valid && other.indices_valid;
    degenerate = degenerate || other.degenerate;
  }
};

/// Coordinates that are not finite make the normal uncertain.
Tally tally_of(MeshView mesh, std::size_t first, std::size_t last, const Vertex& o, const ZeroAreaTest& is_zero) {
  Tally tally;
  std::uint32_t largest = 0;
  for (std::size_t f = first; f < last; ++f) {
    const Triangle& t = mesh.triangles[f];
    largest = std::max(std::max(largest, t[0]), std::max(t[1], t[2]));
  }
  tally.indices_valid = largest < mesh.vertices.size();
  if (!tally.indices_valid) return tally;
  for (std::size_t f = first; f < last; ++f) {
    const Triangle& t = mesh.triangles[f];
    tally.chain += boundary_number(t);
    const Vertex &p = mesh.vertices[t[0]], &q = mesh.vertices[t[1]], &r = mesh.vertices[t[2]];
    const auto [n, scale, certain] = filtered_normal(p, q, r);
    tally.volume += (p[0] - o[0]) * n[0] + (p[1] - o[1]) * n[1] + (p[2] - o[2]) * n[2];
    tally.size += scale;
    tally.box.include(box_of(p, q, r));
    if (certain) continue;
    if (repeats_vertex(t)) tally.chain -= boundary_number(t);  // it has no boundary
    if (!is_finite(p) || !is_finite(q) || !is_finite(r)) {
      tally.finite = false;
    } else if (!tally.degenerate) {
      tally.degenerate = is_zero.exactly(f);
    }
  }
  return tally;
}

/// Sign of the sum of det(a, b, c) over a closed chain.
///
/// With U, V, e and n as in zero_area.h, det(a-o, b-o, c-o) = (a-o) . n has the same sum for every o. With R >= |a-o|
/// in every component, each term has an error below 3 R (8.01 e U V) + 3 R (2 U V)(4e) + underflow <= 49 e R U V +
/// (R+1) 2^-1070, and is at most 7 R U V in size. Adding m terms in sequence and then k partial sums adds an error of
/// at most (m + k) e times the sum of sizes.
int orientation(MeshView mesh, const Tally& total, const Vertex& o, const Chunks& chunks, const Monitor& monitor) {
  double radius = 0;
  for (int i = 0; i < 3; ++i) radius = std::max(radius, std::max(total.box.upper[i] - o[i], o[i] - total.box.lower[i]));
  const auto terms = static_cast<double>(chunks.size + chunks.count);
  const double error = 1.01 * (radius * total.size * (49 + 7 * terms) * 0x1p-53 +
                               static_cast<double>(chunks.items) * (radius + 1) * 0x1p-1060);
  if (total.volume > error) return 1;
  if (total.volume < -error) return -1;
  ProductSum exact;
  Pace pace(monitor);
  for (const Triangle& t : mesh.triangles) {
    pace.step();
    exact.add_determinant(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
  }
  return exact.sign();
}

}  // namespace

bool chain_is_closed(MeshView mesh, const Monitor& monitor) {
  const Chunks chunks(mesh.triangles.size());
  std::vector<Sum> parts(chunks.count);
  chunks.for_each(monitor, [&](std::size_t k, std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f)
      if (!repeats_vertex(mesh.triangles[f])) parts[k] += boundary_number(mesh.triangles[f]);
  });
  return std::accumulate(parts.begin(), parts.end(), Sum{0}) == 0;
}

Screening screen(MeshView mesh, const Monitor& monitor) {
  Screening result;
  if (mesh.triangles.empty()) return result;
  const std::uint32_t somewhere = mesh.triangles[0][0];
  const Vertex o = somewhere < mesh.vertices.size() ? mesh.vertices[somewhere] : Vertex{};
  const Chunks chunks(mesh.triangles.size());
  const ZeroAreaTest is_zero(mesh);
  std::vector<Tally> parts(chunks.count);
  chunks.for_each(monitor, [&](std::size_t k, std::size_t first, std::size_t last) {
    parts[k] = tally_of(mesh, first, last, o, is_zero);
  });
  Tally total;
  for (const Tally& part : parts) total.add(part);
  result.finite = total.finite || !total.indices_valid;
  result.indices_valid = total.indices_valid;
  result.degenerate = total.degenerate;
  result.bounds = total.box;
  result.chain_closed = total.indices_valid && total.chain == 0;
  if (result.finite && result.chain_closed) result.orientation = orientation(mesh, total, o, chunks, monitor);
  return result;
}

}  // namespace strata
