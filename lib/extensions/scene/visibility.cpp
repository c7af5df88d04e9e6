#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "core/kernel/input_complex.h"
#include "extensions/scene/convex_cutting.h"
#include "extensions/scene/layer_decomposition_data.h"
#include "extensions/scene/pieces.h"
#include "extensions/scene/sight.h"
#include "extensions/scene/signed_covering.h"
#include "strata/query.h"

namespace strata {
namespace {

/// The part of [0, 1] that some stretches leave.
std::vector<Stretch> without(std::vector<Stretch> hidden) {
  std::sort(hidden.begin(), hidden.end(), [](const Stretch& a, const Stretch& b) { return a.from < b.from; });
  std::vector<Stretch> seen;
  Rational end = 0;
  for (const Stretch& h : hidden) {
    if (h.from > end) seen.push_back({end, h.from});
    if (h.to > end) end = h.to;
  }
  if (end < 1) seen.push_back({end, 1});
  return seen;
}

}  // namespace

struct Visibility::Data {
  explicit Data(LayerDecomposition decomposition);

  [[nodiscard]] std::vector<Stretch> seen_along(std::uint32_t face, std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] std::vector<ExactPolygon> seen_region(std::uint32_t face) const;

  [[nodiscard]] std::span<const std::uint32_t> before(std::uint32_t face) const {
    return std::span(before_).subspan(first_[face], first_[face + 1] - first_[face]);
  }
  bool hides(std::uint32_t piece, std::uint32_t face, std::uint32_t a, std::uint32_t b, Stretch& hidden) const;
  [[nodiscard]] std::vector<RationalPlane> shadow(std::uint32_t piece, std::uint32_t face) const;
  [[nodiscard]] bool covers(std::uint32_t piece, std::uint32_t face) const;

  LayerDecomposition decomposition_;
  Sight sight_;
  std::vector<std::uint32_t> first_, before_;  ///< per face, the pieces that come before some of it
};

Visibility::Data::Data(LayerDecomposition decomposition)
    : decomposition_(std::move(decomposition)), sight_(pieces_of(decomposition_).input(), decomposition_.origin()) {
  // The inverse of the dominators of a piece: for every face the pieces that one of its own pieces dominates.
  const LayerDecomposition& d = decomposition_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  pairs.reserve(d.domination_count());
  for (std::uint32_t p = 0; p < d.piece_count(); ++p)
    for (const std::uint32_t t : d.dominators(p)) pairs.emplace_back(d.face_of(t), p);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  first_.assign(d.scene().face_count() + 1, 0);
  for (const auto& [face, p] : pairs) {
    ++first_[face + 1];
    before_.push_back(p);
  }
  for (std::size_t f = 0; f + 1 < first_.size(); ++f) first_[f + 1] += first_[f];
}

/// The stretch of the edge ab of a face that a piece before some of the face hides: the part within its rim and beyond
/// its plane. Where the edge is seen along the rim, or lies in the plane, the face's own side of it decides.
bool Visibility::Data::hides(std::uint32_t piece, std::uint32_t face, std::uint32_t a, std::uint32_t b,
                             Stretch& hidden) const {
  const Pieces& pieces = pieces_of(decomposition_);
  const Corners q = pieces.corners(piece), f = pieces.corners(face);
  const std::uint32_t c = f[0] != a && f[0] != b ? f[0] : f[1] != a && f[1] != b ? f[1] : f[2];
  const Sign orientation = sight_.orientation(q);
  hidden = {0, 1};
  // Clips the stretch by a plane that is positive where the piece hides; false: nothing is left.
  const auto clip = [&](Sign at_a, Sign at_b, const auto& at_c, const auto& plane) {
    if (at_a == Sign::zero && at_b == Sign::zero) return at_c() == Sign::positive;
    if (at_a != Sign::positive && at_b != Sign::positive) return false;
    if (at_a * at_b != Sign::negative) return true;
    const RationalPlane exact = plane();
    const Rational x = value_at(exact, pieces.position(a)), y = value_at(exact, pieces.position(b)), t = x / (x - y);
    if (at_a == Sign::negative) {
      hidden.from = std::max(hidden.from, t);
    } else {
      hidden.to = std::min(hidden.to, t);
    }
    return true;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t from = q[i], to = q[(i + 1) % 3];
    const SightLine line(sight_, from, to);
    const auto plane = [&] { return pieces.plane_of_sight(decomposition_.origin(), from, to); };
    if (!clip(
            orientation * line.orientation(a), orientation * line.orientation(b),
            [&] { return orientation * line.orientation(c); }, plane))
      return false;
  }
  const auto depth = [&](std::uint32_t v) { return sight_.depth(q, orientation, v); };
  return clip(
             depth(a), depth(b), [&] { return depth(c); }, [&] { return pieces.plane_of(piece); }) &&
         hidden.from < hidden.to;
}

std::vector<Stretch> Visibility::Data::seen_along(std::uint32_t face, std::uint32_t a, std::uint32_t b) const {
  if (covering_of(decomposition_).orientation(face) == Sign::zero) return {};
  std::vector<Stretch> hidden;
  for (const std::uint32_t p : before(face)) {
    Stretch h;
    if (!hides(p, face, a, b, h)) continue;
    if (h.from == 0 && h.to == 1) return {};
    hidden.push_back(std::move(h));
  }
  return without(std::move(hidden));
}

/// Is all of the face within the rim of the piece, as seen, and beyond its plane?
bool Visibility::Data::covers(std::uint32_t piece, std::uint32_t face) const {
  const Pieces& pieces = pieces_of(decomposition_);
  const Corners q = pieces.corners(piece);
  const Sign orientation = sight_.orientation(q);
  for (std::size_t i = 0; i < 3; ++i) {
    const SightLine line(sight_, q[i], q[(i + 1) % 3]);
    for (const std::uint32_t v : pieces.corners(face))
      if (orientation * line.orientation(v) == Sign::negative) return false;
  }
  for (const std::uint32_t v : pieces.corners(face))
    if (sight_.depth(q, orientation, v) == Sign::negative) return false;
  return true;
}

/// The planes through the origin and a piece's edges, and its own plane if it cuts the face, positive where the piece
/// hides.
std::vector<RationalPlane> Visibility::Data::shadow(std::uint32_t piece, std::uint32_t face) const {
  const Pieces& pieces = pieces_of(decomposition_);
  const Corners q = pieces.corners(piece);
  const Sign orientation = sight_.orientation(q);
  std::vector<RationalPlane> planes;
  const auto add = [&](RationalPlane plane, const RationalPoint& inside) {
    planes.push_back(value_at(plane, inside) < 0 ? opposite(plane) : std::move(plane));
  };
  for (std::size_t i = 0; i < 3; ++i)
    add(pieces.plane_of_sight(decomposition_.origin(), q[i], q[(i + 1) % 3]), pieces.position(q[(i + 2) % 3]));
  std::optional<std::uint32_t> before, beyond;
  for (const std::uint32_t v : pieces.corners(face)) {
    const Sign depth = sight_.depth(q, orientation, v);
    if (depth == Sign::negative) before = v;
    if (depth == Sign::positive) beyond = v;
  }
  if (before && beyond) add(pieces.plane_of(piece), pieces.position(*beyond));
  return planes;
}

std::vector<ExactPolygon> Visibility::Data::seen_region(std::uint32_t face) const {
  if (covering_of(decomposition_).orientation(face) == Sign::zero) return {};
  for (const std::uint32_t p : before(face))
    if (covers(p, face)) return {};
  const Pieces& pieces = pieces_of(decomposition_);
  const Corners f = pieces.corners(face);
  std::vector<ExactPolygon> seen{{pieces.position(f[0]), pieces.position(f[1]), pieces.position(f[2])}};
  for (const std::uint32_t p : before(face)) {
    const std::vector<RationalPlane> hidden = shadow(p, face);
    std::vector<ExactPolygon> left;
    for (ExactPolygon& polygon : seen) cut_out(std::move(polygon), hidden, left);
    seen = std::move(left);
    if (seen.empty()) break;
  }
  return seen;
}

Visibility::Visibility(LayerDecomposition decomposition) : data_(Shared<Data>::make(std::move(decomposition))) {}

const LayerDecomposition& Visibility::decomposition() const { return data_->decomposition_; }

std::vector<Stretch> Visibility::seen_along(std::uint32_t face, std::uint32_t a, std::uint32_t b) const {
  return data_->seen_along(face, a, b);
}

std::vector<ExactPolygon> Visibility::seen_region(std::uint32_t face) const { return data_->seen_region(face); }

std::vector<std::uint32_t> Visibility::seen_faces() const {
  const std::uint32_t count = decomposition().scene().face_count();
  std::vector<std::uint8_t> seen(count);
  tbb::parallel_for(std::uint32_t{0}, count, [&](std::uint32_t f) { seen[f] = !seen_region(f).empty(); });
  std::vector<std::uint32_t> faces;
  for (std::uint32_t f = 0; f < count; ++f)
    if (seen[f] != 0) faces.push_back(f);
  return faces;
}

}  // namespace strata
