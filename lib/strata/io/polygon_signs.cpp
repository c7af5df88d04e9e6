#include "strata/io/polygon_signs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "strata/exact/lattice.h"

namespace strata::io {
namespace {

constexpr double unit_roundoff = 0x1p-53;

/// A product that underflows is off by 2^-1075; where the magnitudes reach this, bounds are far above that.
constexpr double safe_magnitude = 0x1p-900;

/// Asks a question of exact integers on the lattice of the points, in the least width that `width(bits)` fits.
template <class Points, class Width, class Question>
Sign decide(const Points& points, const Width& width, const Question& question) {
  Lattice lattice;
  for (const auto& p : points)
    for (const double x : p) lattice.add(x);
  const int bits = std::max(width(lattice.bits()), lattice.bits() + 64);
  const auto ask = [&]<class Int>(const Int*) { return question([&](double x) { return lattice.integer<Int>(x); }); };
  if (bits < 256) return ask(static_cast<const WideInt<4>*>(nullptr));
  if (bits < 512) return ask(static_cast<const WideInt<8>*>(nullptr));
  return ask(static_cast<const Integer*>(nullptr));
}

/// Side of d relative to the plane of a, b, c, up to a fixed factor of -1. Exact.
Sign side_of_plane(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) {
  const double ux = b[0] - a[0], uy = b[1] - a[1], uz = b[2] - a[2];
  const double vx = c[0] - a[0], vy = c[1] - a[1], vz = c[2] - a[2];
  const double wx = d[0] - a[0], wy = d[1] - a[1], wz = d[2] - a[2];
  const double yz = uy * vz, zy = uz * vy, zx = uz * vx, xz = ux * vz, xy = ux * vy, yx = uy * vx;
  const double value = (yz - zy) * wx + (zx - xz) * wy + (xy - yx) * wz;
  const double magnitude = (std::abs(yz) + std::abs(zy)) * std::abs(wx) + (std::abs(zx) + std::abs(xz)) * std::abs(wy) +
                           (std::abs(xy) + std::abs(yx)) * std::abs(wz);
  // Shewchuk 1997, bound A of orient3d: (7 + 56 u) u; products that underflow are off by less than 2^-1000 (1 + |w|).
  const double bound = 8 * unit_roundoff * magnitude + 0x1p-1000 * (1 + std::abs(wx) + std::abs(wy) + std::abs(wz));
  if (value > bound) return Sign::positive;
  if (-value > bound) return Sign::negative;
  return decide(
      std::array{a, b, c, d}, [](int bits) { return 3 * bits + 6; },
      [&](const auto& integer) {
        using Int = decltype(integer(0.0));
        const auto difference = [&](const Vertex& p, std::size_t i) { return Int(integer(p[i]) - integer(a[i])); };
        const Int bx = difference(b, 0), by = difference(b, 1), bz = difference(b, 2);
        const Int cx = difference(c, 0), cy = difference(c, 1), cz = difference(c, 2);
        const Int nx = by * cz - bz * cy, ny = bz * cx - bx * cz, nz = bx * cy - by * cx;
        return sign_of_integer(Int(nx * difference(d, 0) + ny * difference(d, 1) + nz * difference(d, 2)));
      });
}

bool is_collinear(const Vertex& a, const Vertex& b, const Vertex& c) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (turn({a[i], a[j]}, {b[i], b[j]}, {c[i], c[j]}) != Sign::zero) return false;
  }
  return true;
}

bool lies_in_axis_plane(std::span<const Vertex> loop) {
  for (std::size_t i = 0; i < 3; ++i)
    if (std::all_of(loop.begin(), loop.end(), [&](const Vertex& p) { return p[i] == loop[0][i]; })) return true;
  return false;
}

}  // namespace

Sign turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  const double left = (a[0] - c[0]) * (b[1] - c[1]), right = (a[1] - c[1]) * (b[0] - c[0]);
  const double value = left - right, magnitude = std::abs(left) + std::abs(right);
  // Each product is off by a relative 3u + 3u^2, the difference by u more; 8u leaves room for rounding the bound.
  if (magnitude > safe_magnitude) {
    if (value > 8 * unit_roundoff * magnitude) return Sign::positive;
    if (-value > 8 * unit_roundoff * magnitude) return Sign::negative;
  }
  return decide(
      std::array{a, b, c}, [](int bits) { return 2 * bits + 4; },
      [&](const auto& integer) {
        using Int = decltype(integer(0.0));
        const Int cx = integer(c[0]), cy = integer(c[1]);
        return sign_of_integer(
            Int(Int(integer(a[0]) - cx) * Int(integer(b[1]) - cy) - Int(integer(a[1]) - cy) * Int(integer(b[0]) - cx)));
      });
}

Sign area_sign(std::span<const PlanePoint> loop) {
  const auto [x0, y0] = loop[0];
  double value = 0, magnitude = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    const double left = (loop[i][0] - x0) * (loop[i + 1][1] - y0), right = (loop[i][1] - y0) * (loop[i + 1][0] - x0);
    value += left - right;
    magnitude += std::abs(left) + std::abs(right);
  }
  // Each product is off by a relative 3u + 3u^2, a sum of n differences by n u more.
  const double bound = (static_cast<double>(loop.size()) + 8) * 2 * unit_roundoff * magnitude;
  if (magnitude > safe_magnitude) {
    if (value > bound) return Sign::positive;
    if (-value > bound) return Sign::negative;
  }
  // At most 2^32 corners.
  return decide(
      loop, [](int bits) { return 2 * bits + 4 + 32; },
      [&](const auto& integer) {
        using Int = decltype(integer(0.0));
        Int sum = 0;
        for (std::size_t i = 0; i < loop.size(); ++i) {
          const auto &p = loop[i], &q = loop[i + 1 < loop.size() ? i + 1 : 0];
          sum = sum + Int(integer(p[0]) * integer(q[1]) - integer(p[1]) * integer(q[0]));
        }
        return sign_of_integer(sum);
      });
}

bool is_planar(std::span<const Vertex> loop) {
  if (loop.size() < 4 || lies_in_axis_plane(loop)) return true;
  const Vertex& a = loop[0];
  const auto b = std::find_if(loop.begin(), loop.end(), [&](const Vertex& p) { return p != a; });
  if (b == loop.end()) return true;
  const auto c = std::find_if(b + 1, loop.end(), [&](const Vertex& p) { return !is_collinear(a, *b, p); });
  if (c == loop.end()) return true;
  return std::all_of(b + 1, loop.end(),
                     [&](const Vertex& p) { return &p == &*c || side_of_plane(a, *b, *c, p) == Sign::zero; });
}

}  // namespace strata::io
