#include "core/round/surface_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "core/containers/box_cover.h"
#include "core/containers/box_tree.h"
#include "core/containers/collect.h"
#include "core/containers/for_each_index.h"
#include "core/exact/double_double.h"
#include "core/exact/vector.h"
#include "core/kernel/box.h"
#include "core/round/distances.h"

namespace strata {
namespace {

using Place = std::array<DoubleDouble, 3>;
using Corners = std::array<Place, 3>;
/// The corners of a convex polygon, in their order.
using Piece = std::vector<Place>;

constexpr double infinity = Box::infinity;

/// Coordinates of about 1 in place of huge or tiny ones, whose squares overflow or underflow. It divides by a power of
/// two: what is rounded is far below the last place of the largest.
class Scale {
 public:
  explicit Scale(double largest) : exponent_(largest > 0 ? std::ilogb(largest) : 0) {}

  [[nodiscard]] Vertex down(const Vertex& v) const {
    return {std::ldexp(v[0], -exponent_), std::ldexp(v[1], -exponent_), std::ldexp(v[2], -exponent_)};
  }
  [[nodiscard]] double down(double length) const { return std::ldexp(length, -exponent_); }
  /// At least the length that is that long when it is divided.
  [[nodiscard]] double up(double length) const {
    constexpr double rounded = 0x1p-1000;
    return std::nextafter(std::ldexp(length + rounded, exponent_), infinity);
  }

 private:
  int exponent_;
};

Place place_of(const Vertex& v) { return {v[0], v[1], v[2]}; }

/// A number of [0, 1] near x, taken as exact.
DoubleDouble fraction(const DoubleDouble& x) {
  if (!(x.value > 0)) return 0.0;
  if (x.value > 1 || (x.value == 1 && x.low > 0)) return 1.0;
  return {x.value, x.low, 0};
}

/// About a / b: both may have errors as large as they are.
DoubleDouble quotient(const DoubleDouble& a, const DoubleDouble& b) {
  return DoubleDouble(a.value, a.low, 0) / DoubleDouble(b.value, b.low, 0);
}

Place between(const Place& a, const Place& b, const DoubleDouble& t) {
  Place p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = a[i] + t * (b[i] - a[i]);
  return p;
}

/// At least the distance, in the maximum norm; infinity where numbers overflow.
double distance(const Place& p, const Place& q) {
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Bounded way = (p[i] - q[i]).bounded();
    const double most = std::max(way.upper(), -way.lower());
    if (!(most < infinity)) return infinity;
    largest = std::max(largest, most);
  }
  return largest;
}

/// A face of the surface, its corners in their nearest doubles.
class Face {
 public:
  Face(const Corners& corners, const Box& box, double off) : corners_(corners), box_(box), off_(off) {}

  [[nodiscard]] const Corners& corners() const { return corners_; }

  /// At least the distance of a point from the face.
  [[nodiscard]] double from(const Place& p, std::size_t axis) const {
    double least = from_point_along(p, axis);
    for (std::size_t k = 0; k < 3; ++k) least = std::min(least, from_side(p, corners_[k], corners_[(k + 1) % 3]));
    return least + off_;
  }
  /// At least that of every point of a piece; infinity where it is not below `limit`.
  [[nodiscard]] double from(const Piece& piece, std::size_t axis, double limit = infinity) const {
    double largest = 0;
    for (const Place& p : piece) {
      if (from_box(p) >= limit) return infinity;
      largest = std::max(largest, from(p, axis));
      if (largest >= limit) return infinity;
    }
    return largest;
  }
  /// Positive where p is left of side k, seen along an axis.
  [[nodiscard]] DoubleDouble left_of_side(std::size_t k, const Place& p, std::size_t axis) const {
    return left(corners_[k], corners_[(k + 1) % 3], p, axis);
  }

 private:
  static DoubleDouble left(const Place& a, const Place& b, const Place& p, std::size_t axis) {
    const std::size_t x = (axis + 1) % 3, y = (axis + 2) % 3;
    return (b[x] - a[x]) * (p[y] - a[y]) - (b[y] - a[y]) * (p[x] - a[x]);
  }
  /// From the point of the face that is seen where p is; infinity if none is.
  [[nodiscard]] double from_point_along(const Place& p, std::size_t axis) const {
    std::array<double, 3> weights{};
    for (std::size_t k = 0; k < 3; ++k) weights[k] = left_of_side((k + 1) % 3, p, axis).value;  // opposite to corner k
    const auto [low, high] = std::minmax({weights[0], weights[1], weights[2]});
    if (low < 0 && high > 0) return infinity;
    const DoubleDouble b = left_of_side(2, p, axis), c = left_of_side(0, p, axis), a = left_of_side(1, p, axis);
    const DoubleDouble beyond = b + c, all = a + beyond;
    if (all.value == 0) return infinity;
    const Place across =
        beyond.value == 0 ? corners_[1] : between(corners_[1], corners_[2], fraction(quotient(c, beyond)));
    return distance(p, between(corners_[0], across, fraction(quotient(beyond, all))));
  }
  [[nodiscard]] double from_box(const Place& p) const {
    double largest = 0;
    for (std::size_t i = 0; i < 3; ++i)
      largest = std::max({largest, box_.lower[i] - p[i].value, p[i].value - box_.upper[i]});
    return largest;
  }
  static double from_side(const Place& p, const Place& a, const Place& b) {
    const Place side = minus(b, a);
    const DoubleDouble length = dot(side, side);
    const DoubleDouble along = length.value > 0 ? fraction(quotient(dot(minus(p, a), side), length)) : 0.0;
    return distance(p, between(a, b, along));
  }

  Corners corners_;
  Box box_;
  double off_;  ///< at least how far its points are from where they are without rounding
};

/// The parts of a convex polygon where a linear function is positive, and where it is negative; `at`: its values at the
/// corners. Parts without an area may be left out.
std::array<Piece, 2> divided(const Piece& piece, const std::vector<DoubleDouble>& at) {
  std::array<Piece, 2> parts;
  auto& [above, below] = parts;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const std::size_t j = (i + 1) % piece.size();
    const double here = at[i].value, there = at[j].value;
    if (here >= 0) above.push_back(piece[i]);
    if (here <= 0) below.push_back(piece[i]);
    if ((here < 0 && there > 0) || (here > 0 && there < 0)) {
      above.push_back(between(piece[i], piece[j], fraction(quotient(at[i], at[i] - at[j]))));
      below.push_back(above.back());
    }
  }
  for (Piece& part : parts)
    if (part.size() < 3) part.clear();
  return parts;
}

/// The parts of a convex polygon on both sides of the middle of its longest extent.
std::array<Piece, 2> halves(const Piece& piece) {
  Box box;
  for (const Place& p : piece) box.include(Vertex{p[0].value, p[1].value, p[2].value});
  std::size_t longest = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (box.upper[i] - box.lower[i] > box.upper[longest] - box.lower[longest]) longest = i;
  const double middle = box.lower[longest] + (box.upper[longest] - box.lower[longest]) / 2;
  std::vector<DoubleDouble> above;
  for (const Place& p : piece) above.push_back(p[longest] - middle);
  return divided(piece, above);
}

/// What of a convex polygon lies over a face, seen along an axis; what does not is added to `beside`. A face without an
/// area there has nothing over it.
Piece over(const Face& face, const Piece& piece, std::size_t axis, std::vector<Piece>& beside) {
  const double area = face.left_of_side(0, face.corners()[2], axis).value;
  const std::size_t before = beside.size();
  Piece rest = area == 0 ? Piece{} : piece;
  for (std::size_t side = 0; side < 3 && !rest.empty(); ++side) {
    std::vector<DoubleDouble> inside;
    for (const Place& p : rest) {
      const DoubleDouble left = face.left_of_side(side, p, axis);
      inside.push_back(area > 0 ? left : -left);
    }
    if (!std::ranges::all_of(inside, [](const DoubleDouble& d) { return std::isfinite(d.value); })) {
      rest.clear();  // numbers overflow
      break;
    }
    auto [in, out] = divided(rest, inside);
    rest = std::move(in);
    if (!out.empty()) beside.push_back(std::move(out));
  }
  if (rest.empty()) {
    beside.resize(before);
    beside.push_back(piece);
  }
  return rest;
}

/// The faces of a surface that are near some boxes.
class NearFaces {
 public:
  NearFaces(const NearestMesh& surface, std::vector<Box> boxes, const Scale& scale) : surface_(surface), scale_(scale) {
    const BoxCover cover(std::move(boxes));
    faces_ = collect(surface.mesh.triangles.size(), [&](std::uint32_t f) { return cover.meets(box_of(f)); });
    tree_ =
        BoxTree::by_surface_area(static_cast<std::uint32_t>(faces_.size()), [&](std::span<const std::uint32_t> some) {
          Box box;
          for (const std::uint32_t n : some) box.include(box_of(faces_[n]));
          return box;
        });
  }

  /// Those that meet a box, by increasing number, scaled down; none where there are more than `most`.
  [[nodiscard]] std::vector<Face> in(const Box& box, std::size_t most) const {
    std::vector<std::uint32_t> found;
    const bool are_all = tree_.for_each_near(box, [&](std::uint32_t n) {
      if (box_of(faces_[n]).overlaps(box)) found.push_back(faces_[n]);
      return found.size() <= most;
    });
    if (!are_all) return {};
    std::sort(found.begin(), found.end());
    std::vector<Face> faces;
    for (const std::uint32_t f : found) faces.push_back(face(f));
    return faces;
  }

 private:
  [[nodiscard]] Box box_of(std::uint32_t f) const {
    Box box;
    for (const std::uint32_t v : surface_.mesh.triangles[f]) box.include(surface_.mesh.vertices[v]);
    return box;
  }
  [[nodiscard]] Face face(std::uint32_t f) const {
    Corners corners;
    Box box;
    double off = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = surface_.mesh.triangles[f][k];
      const Vertex &at = surface_.mesh.vertices[v], scaled = scale_.down(at);
      corners[k] = place_of(scaled);
      box.include(scaled);
      if (std::binary_search(surface_.rounded.begin(), surface_.rounded.end(), v))
        off = std::max(off, scale_.down(half_unit(at)));
    }
    return {corners, box, off};
  }

  const NearestMesh& surface_;
  const Scale& scale_;
  std::vector<std::uint32_t> faces_;
  BoxTree tree_;
};

/// The axis along which most of a triangle is seen.
std::size_t axis_of(const std::array<Vertex, 3>& t) {
  const std::array<double, 3> normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
  std::size_t axis = 0;
  for (const std::size_t i : {std::size_t{1}, std::size_t{2}})
    if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
  return axis;
}

/// How far a triangle is from faces.
class TriangleDistance {
 public:
  TriangleDistance(const std::vector<Face>& faces, const std::array<Vertex, 3>& triangle)
      : faces_(faces),
        axis_(axis_of(triangle)),
        whole_{place_of(triangle[0]), place_of(triangle[1]), place_of(triangle[2])} {}

  /// At least the distance of any point of it, as near as can be found in so many steps, or `enough`.
  [[nodiscard]] double measure(double enough) {
    const double from_one = from_one_face(whole_);
    if (from_one <= enough) return from_one;
    steps_ = 0;
    const double by_pieces = measure_pieces(enough);
    return is_too_long() ? from_one : std::min(from_one, by_pieces);
  }

 private:
  static constexpr std::size_t most_steps = 1 << 15;
  static constexpr int most_halvings = 40;

  [[nodiscard]] bool is_too_long() const { return steps_ > most_steps; }

  /// Faces take what lies over them, those first over which it is nearest. Beyond `enough`, a piece may be nearer to
  /// faces that it is not over: where it sticks out beyond the surface, or lies between faces. Without meaning once it
  /// takes too long.
  [[nodiscard]] double measure_pieces(double enough) {
    double largest = 0;
    std::vector<Piece> left{whole_};
    for (const auto& [far, face] : by_distance()) {
      std::vector<Piece> still_left;
      for (const Piece& piece : left) {
        ++steps_;
        if (is_too_long()) return infinity;
        const double good = std::max(largest, enough);
        if (far > good) {
          if (const double beside = distance(piece, good, far); beside <= far) {
            largest = std::max(largest, beside);
            continue;
          }
        }
        const Piece there = over(*face, piece, axis_, still_left);
        if (!there.empty()) largest = std::max(largest, face->from(there, axis_));
      }
      left = std::move(still_left);
    }
    for (const Piece& piece : left) {
      if (is_too_long()) return infinity;
      largest = std::max(largest, distance(piece, std::max(largest, enough), infinity));
    }
    return largest;
  }

  /// The faces, and how far the part of the triangle over each is from it.
  [[nodiscard]] std::vector<std::pair<double, const Face*>> by_distance() const {
    std::vector<Piece> beside;
    std::vector<std::pair<double, const Face*>> result;
    for (const Face& face : faces_)
      if (const Piece piece = over(face, whole_, axis_, beside); !piece.empty())
        result.emplace_back(face.from(piece, axis_), &face);
    std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return result;
  }

  /// At least that of any point of a piece, of which each part has the face that is nearest to all of it. Parts are
  /// halved until that is `good`, or about as near as their corners are. Infinity where it is above `most`, and once it
  /// takes too long.
  [[nodiscard]] double distance(const Piece& piece, double good, double most, int halvings = most_halvings) {
    constexpr double about = 1.25;
    steps_ += faces_.size();
    if (is_too_long()) return infinity;
    const double least = from_one_face(piece);
    if (least <= good || halvings == 0) return least;
    double of_corners = 0;
    for (const Place& p : piece) of_corners = std::max(of_corners, from_one_face({p}));
    if (of_corners > most) return infinity;
    if (least <= about * of_corners) return least;
    double largest = 0;
    for (const Piece& half : halves(piece)) {
      largest = std::max(largest, distance(half, good, most, halvings - 1));
      if (largest > most) return infinity;
    }
    return std::min(largest, least);
  }
  [[nodiscard]] double from_one_face(const Piece& piece) const {
    double least = infinity;
    for (const Face& face : faces_) least = std::min(least, face.from(piece, axis_, least));
    return least;
  }

  const std::vector<Face>& faces_;
  std::size_t axis_;
  Piece whole_;
  std::size_t steps_ = 0;
};

}  // namespace

void tighten_distances(const NearestMesh& surface, MeshView mesh, double enough, const Monitor& monitor,
                       std::vector<double>& distances) {
  const std::vector<std::uint32_t> far =
      collect(distances.size(), [&](std::uint32_t f) { return distances[f] > enough && distances[f] < infinity; });
  if (far.empty()) return;
  const auto corners = [&](std::uint32_t f) -> std::array<Vertex, 3> {
    const auto& [a, b, c] = mesh.triangles[f];
    return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
  };
  std::vector<Box> boxes;
  double largest = 0;
  for (const std::uint32_t f : far) {
    Box box;
    for (const Vertex& v : corners(f)) {
      box.include(v);
      largest = std::max(largest, size(v));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      box.lower[i] -= distances[f];
      box.upper[i] += distances[f];
    }
    boxes.push_back(box);
  }
  const Scale scale(largest);
  const NearFaces near(surface, boxes, scale);
  for_each_index(far.size(), 1, monitor, [&](std::size_t n) {
    constexpr std::size_t most_faces = 512;
    const std::vector<Face> faces = near.in(boxes[n], most_faces);
    if (faces.empty()) return;
    const auto [a, b, c] = corners(far[n]);
    double& known = distances[far[n]];
    TriangleDistance distance(faces, {scale.down(a), scale.down(b), scale.down(c)});
    for (const double good : {scale.down(enough), 0.0})
      if (known > enough) known = std::min(known, scale.up(distance.measure(good)));
  });
}

}  // namespace strata
