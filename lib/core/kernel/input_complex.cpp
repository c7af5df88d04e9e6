#include "core/kernel/input_complex.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/exact/arithmetic.h"
#include "core/exact/big_integer.h"
#include "core/exact/lattice.h"
#include "core/kernel/disjoint_sets.h"
#include "core/kernel/rational_point.h"

namespace strata {

namespace {

const RationalPoint* rational_of(const ExactVertex& v) { return &v.position; }
const RationalPoint* rational_of(const PlacedVertex& v) { return v.rational; }

/// x - nearest, if that is a double, where x has a numerator of more than two limbs or the nearest double is subnormal.
std::optional<double> long_remainder_of(const Rational& x, double nearest) {
  const Rational rest = x - to_rational(nearest);
  const double remainder = to_nearest_double(rest);
  return to_rational(remainder) == rest ? std::optional(remainder) : std::nullopt;
}

/// x - nearest, if that is a double.
std::optional<double> remainder_of(const Rational& x, double nearest) {
  const std::span<const std::uint64_t> n = numerator_limbs(x), d = denominator_limbs(x);
  if (!is_dyadic(x) || !std::isfinite(nearest)) return std::nullopt;
  const auto shift = static_cast<int>(64 * (d.size() - 1)) + std::countr_zero(d.back());
  using Wide = unsigned __int128;
  const DoubleParts parts(nearest);
  // x = numerator / 2^shift, and the double is a multiple of 2^-shift unless it is x rounded to fewer bits.
  const int up = parts.exponent + shift;
  if (n.size() > 2 || shift > 1000 || up < 0 || up > 64) return long_remainder_of(x, nearest);
  const Wide numerator = Wide{limb_or_zero(n, 1)} << 64 | limb_or_zero(n, 0), rounded = Wide{parts.magnitude} << up;
  const bool is_above = numerator > rounded;
  const Wide rest = is_above ? numerator - rounded : rounded - numerator;
  const double size = static_cast<double>(rest);
  if (static_cast<Wide>(size) != rest) return std::nullopt;
  return std::ldexp(is_above != parts.negative ? size : -size, -shift);
}

/// exact - nearest, if that is three doubles.
std::optional<InputComplex::Coordinates> remainder_of(const RationalPoint& exact,
                                                      const InputComplex::Coordinates& nearest) {
  InputComplex::Coordinates remainder;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto rest = remainder_of(exact[i], nearest[i]);
    if (!rest) return std::nullopt;
    remainder[i] = *rest;
  }
  return remainder;
}

}  // namespace

template <class Listed>
std::shared_ptr<const InputComplex::Listing> InputComplex::listing_of(std::span<const Coordinates> points,
                                                                      std::span<const Listed> listed) {
  if (listed.empty()) return nullptr;
  auto listing = std::make_shared<Listing>(points.size(), listed.size());
  constexpr std::size_t at_once = 1024;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, listed.size(), at_once), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      const std::uint32_t vertex = listed[i].vertex;
      listing->place[vertex] = static_cast<std::uint32_t>(i);
      if (const RationalPoint* exact = rational_of(listed[i]))
        listing->remainder[i] = remainder_of(*exact, points[vertex]);
    }
  });
  return listing;
}

void InputComplex::add(std::span<const Coordinates> points, std::span<const Indices> faces,
                       std::span<const ExactVertex> exact, const std::optional<Box>& bounds) {
  add({points, faces, exact, {}, {}, listing_of(points, exact), vertex_end_, face_end_, bounds});
}

void InputComplex::add(std::span<const Coordinates> points, std::span<const Indices> faces,
                       std::span<const PlacedVertex> placed, std::span<const SourcePlane* const> planes,
                       const Box& bounds) {
  add({points, faces, {}, placed, planes, listing_of(points, placed), vertex_end_, face_end_, bounds});
}

void InputComplex::add(Block block) {
  ensure_ieee_arithmetic();
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max() - 1;
  if (block.points.size() > most - vertex_end_ || block.faces.size() > most - face_end_)
    throw std::length_error("more than 2^32 - 2 vertices or faces in one evaluation");
  vertex_end_ += static_cast<std::uint32_t>(block.points.size());
  face_end_ += static_cast<std::uint32_t>(block.faces.size());
  has_rationals_ = has_rationals_ || block.listing != nullptr;
  has_planes_ = has_planes_ || !block.planes.empty();
  blocks_.push_back(std::move(block));
  constexpr std::uint32_t many = 64;
  if (operand_count() == many) {
    stride_ = 3;
    operand_at_vertex_.clear();
    operand_at_face_.clear();
    for (std::uint32_t o = 0; o + 1 < many; ++o) list_operand(o);
  }
  list_operand(operand_count() - 1);
}

void InputComplex::list_operand(std::uint32_t operand) {
  const Block& b = blocks_[operand];
  while (operand_at_vertex_.size() << stride_ < b.first_vertex + b.points.size()) operand_at_vertex_.push_back(operand);
  while (operand_at_face_.size() << stride_ < b.first_face + b.faces.size()) operand_at_face_.push_back(operand);
}

void InputComplex::identify(std::span<const std::pair<std::uint32_t, std::uint32_t>> equal) {
  if (equal.empty()) return;
  shared_.resize(vertex_end_);
  DisjointSets<std::uint32_t> sets(vertex_end_);
  for (std::uint32_t v = 0; v < same_.size(); ++v) sets.unite(same_[v], v);
  for (const auto& [a, b] : equal) {
    sets.unite(a, b);
    shared_[a] = shared_[b] = true;
  }
  same_.resize(vertex_end_);
  for (std::uint32_t v = 0; v < vertex_end_; ++v) same_[v] = sets.find(v);
}

VertexPosition InputComplex::listed_place(std::uint32_t vertex) const {
  const Block& b = blocks_[find<true>(vertex)];
  const std::uint32_t i = vertex - b.first_vertex;
  VertexPosition place{&b.points[i]};
  if (b.listing == nullptr || b.listing->place[i] == not_listed) return place;
  const std::uint32_t at = b.listing->place[i];
  place.rational = b.exact.empty() ? b.placed[at].rational : &b.exact[at].position;
  if (b.exact.empty()) place.meet = b.placed[at].meet;
  if (const auto& remainder = b.listing->remainder[at]) place.remainder = &*remainder;
  return place;
}

const HPoint<Integer>& InputComplex::homogeneous(std::uint32_t vertex) const {
  const Block& b = blocks_[find<true>(vertex)];
  const std::uint32_t at = b.listing->place[vertex - b.first_vertex];
  return b.listing->homogeneous.get(
      at, [&] { return strata::homogeneous(b.exact.empty() ? *b.placed[at].rational : b.exact[at].position); });
}

}  // namespace strata
