#include "extensions/bsp/piece.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "strata/errors.h"

namespace strata::bsp {
namespace {

using Signs = boost::container::small_vector<Sign, 8>;

template <int D>
Signs sides_of(const HyperplaneTable<D>& table, const Piece<D>& piece, std::uint32_t hyperplane) {
  Signs signs;
  for (const HyperplaneMeet<D>& c : piece.corners) signs.push_back(table.side(hyperplane, c));
  return signs;
}

Lie lie_of(const Signs& signs) {
  bool minus = false, plus = false;
  for (const Sign s : signs) {
    minus |= s == Sign::negative;
    plus |= s == Sign::positive;
  }
  return bsp::lie_of(minus, plus);
}

/// The points in which the sides of a piece cross a hyperplane that has corners on both sides, in their order: one
/// point of a segment, two on the rim of a polygon unless corners lie in it.
template <int D>
using Crossings = boost::container::small_vector<HyperplaneMeet<D>, 2>;

Crossings<1> crossings(const HyperplaneTable<1>&, const Piece<1>&, std::uint32_t, const Signs&) {
  throw LogicError("a point of the line has two sides");
}

Crossings<2> crossings(const HyperplaneTable<2>& table, const Piece<2>& piece, std::uint32_t hyperplane, const Signs&) {
  return {table.meet({piece.hyperplane, hyperplane})};
}

Crossings<3> crossings(const HyperplaneTable<3>& table, const Piece<3>& piece, std::uint32_t hyperplane,
                       const Signs& signs) {
  Crossings<3> corners;
  for (std::size_t i = 0; i < signs.size(); ++i)
    if (signs[i] * signs[i + 1 == signs.size() ? 0 : i + 1] == Sign::negative)
      corners.push_back(table.meet({piece.hyperplane, piece.walls[i], hyperplane}));
  return corners;
}

/// The part on one side.
Piece<1> part_on(const Piece<1>& piece, std::uint32_t, const Signs&, const Crossings<1>&, Sign) { return piece; }

Piece<2> part_on(const Piece<2>& piece, std::uint32_t, const Signs& signs, const Crossings<2>& crossings, Sign side) {
  Piece<2> part = piece;
  part.corners[signs[0] == side ? 1 : 0] = crossings[0];
  return part;
}

Piece<3> part_on(const Piece<3>& piece, std::uint32_t hyperplane, const Signs& signs, const Crossings<3>& crossings,
                 Sign side) {
  Piece<3> part;
  part.hyperplane = piece.hyperplane;
  const std::size_t n = piece.corners.size();
  auto crossing = crossings.begin();
  for (std::size_t i = 0; i < n; ++i) {
    const Sign here = signs[i], there = signs[i + 1 == n ? 0 : i + 1];
    const bool is_leaving = here != -side && there == -side;  // the new side begins
    if (here != -side) {
      part.corners.push_back(piece.corners[i]);
      part.walls.push_back(here == Sign::zero && is_leaving ? hyperplane : piece.walls[i]);
    }
    if (here * there != Sign::negative) continue;
    part.corners.push_back(*crossing++);
    part.walls.push_back(is_leaving ? hyperplane : piece.walls[i]);
  }
  return part;
}

constexpr BoxPlanes frame_planes() {
  BoxPlanes frame{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    frame[axis] = {HyperplaneTable<3>::frame(axis, false), HyperplaneTable<3>::frame(axis, true)};
  return frame;
}

/// The rectangle that four sides of a box cut out of a plane, counter-clockwise as seen from the positive end of
/// `axis`.
Piece<3> rectangle(const HyperplaneTable<3>& table, std::uint32_t plane, std::size_t axis, const BoxPlanes& box) {
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  const std::array<std::uint32_t, 4> around{box[j][0], box[i][1], box[j][1], box[i][0]};
  Piece<3> piece;
  piece.hyperplane = plane;
  for (std::size_t k = 0; k < 4; ++k) {
    piece.corners.push_back(table.meet({plane, around[(k + 3) % 4], around[k]}));
    piece.walls.push_back(around[k]);
  }
  return piece;
}

void turn_round(Piece<3>& piece) {
  std::reverse(piece.corners.begin(), piece.corners.end());
  std::reverse(piece.walls.begin(), piece.walls.end() - 1);
}

Piece<2> stretch(const HyperplaneTable<2>& table, std::uint32_t line, std::size_t axis, bool is_upwards) {
  constexpr auto frame = HyperplaneTable<2>::frame;
  Piece<2> piece;
  piece.hyperplane = line;
  piece.corners = {table.meet({line, frame(axis, !is_upwards)}), table.meet({line, frame(axis, is_upwards)})};
  return piece;
}

Piece<1> point(const HyperplaneTable<1>& table, std::uint32_t number) {
  Piece<1> piece;
  piece.hyperplane = number;
  piece.corners = {table.meet({number})};
  return piece;
}

}  // namespace

template <>
Piece<1> whole(const HyperplaneTable<1>& table, std::uint32_t hyperplane) {
  return point(table, hyperplane);
}

template <>
Piece<2> whole(const HyperplaneTable<2>& table, std::uint32_t hyperplane) {
  // The plus side is on the left of the direction (n_y, -n_x).
  const Hyperplane<2>& line = table[hyperplane];
  const std::size_t steep = line.longest_axis();
  const bool is_upwards = (line.exact()[steep] > 0) == (steep == 1);
  return stretch(table, hyperplane, 1 - steep, is_upwards);
}

template <>
Piece<3> whole(const HyperplaneTable<3>& table, std::uint32_t hyperplane) {
  return whole_between(table, hyperplane, frame_planes());
}

Piece<3> whole_between(const HyperplaneTable<3>& table, std::uint32_t plane, const BoxPlanes& box) {
  const std::size_t axis = table[plane].longest_axis();
  Piece<3> piece = rectangle(table, plane, axis, box);
  if (table[plane].exact()[axis] < 0) turn_round(piece);
  return piece;
}

template <>
Piece<1> side_of_frame(const HyperplaneTable<1>& table, std::size_t axis, bool is_upper) {
  return point(table, HyperplaneTable<1>::frame(axis, is_upper));
}

template <>
Piece<2> side_of_frame(const HyperplaneTable<2>& table, std::size_t axis, bool is_upper) {
  return stretch(table, HyperplaneTable<2>::frame(axis, is_upper), 1 - axis, true);
}

template <>
Piece<3> side_of_frame(const HyperplaneTable<3>& table, std::size_t axis, bool is_upper) {
  return rectangle(table, HyperplaneTable<3>::frame(axis, is_upper), axis, frame_planes());
}

template <int D>
Lie lie_of(const HyperplaneTable<D>& table, const Piece<D>& piece, std::uint32_t hyperplane) {
  if (piece.hyperplane == hyperplane) return Lie::on;
  return lie_of(sides_of(table, piece, hyperplane));
}

template <int D>
Lie estimated_lie(const HyperplaneTable<D>& table, const Piece<D>& piece, std::uint32_t hyperplane) {
  if (piece.hyperplane == hyperplane) return Lie::on;
  const auto& form = table[hyperplane].bounded();
  bool minus = false, plus = false;
  for (const HyperplaneMeet<D>& c : piece.corners) {
    double value = c.is_far ? 0 : form[D].value, size = std::abs(value);
    for (std::size_t i = 0; i < D; ++i) {
      const double product = form[i].value * c.at[i].value;
      value += product;
      size += std::abs(product);
    }
    constexpr double nearly = 0x1p-40;
    minus |= value < -size * nearly;
    plus |= value > size * nearly;
  }
  return lie_of(minus, plus);
}

template <int D>
Split<D> split(const HyperplaneTable<D>& table, const Piece<D>& piece, std::uint32_t hyperplane) {
  if (piece.hyperplane == hyperplane) return {};
  const Signs signs = sides_of(table, piece, hyperplane);
  Split<D> result{lie_of(signs), {}, {}};
  if (result.lie == Lie::both) {
    const Crossings<D> corners = crossings(table, piece, hyperplane, signs);
    result.minus = part_on(piece, hyperplane, signs, corners, Sign::negative);
    result.plus = part_on(piece, hyperplane, signs, corners, Sign::positive);
  }
  return result;
}

template <int D>
bool clip(const HyperplaneTable<D>& table, Piece<D>& piece, HalfSpace half_space) {
  const Signs signs = sides_of(table, piece, half_space.hyperplane);
  const Lie lie = lie_of(signs);
  if (lie == Lie::both) {
    piece = part_on(piece, half_space.hyperplane, signs, crossings(table, piece, half_space.hyperplane, signs),
                    half_space.side);
    return true;
  }
  return lie == (half_space.side == Sign::positive ? Lie::plus : Lie::minus);
}

template <int D>
Piece<D> part_within(const HyperplaneTable<D>& table, std::uint32_t hyperplane, std::span<const HalfSpace> path) {
  Piece<D> piece = whole(table, hyperplane);
  for (std::size_t i = path.size(); i-- > 0;)
    if (!clip(table, piece, path[i])) throw LogicError("a hyperplane does not divide the part of space of its node");
  return piece;
}

#define STRATA_INSTANTIATE(D)                                                            \
  template Lie lie_of(const HyperplaneTable<D>&, const Piece<D>&, std::uint32_t);        \
  template Lie estimated_lie(const HyperplaneTable<D>&, const Piece<D>&, std::uint32_t); \
  template Split<D> split(const HyperplaneTable<D>&, const Piece<D>&, std::uint32_t);    \
  template bool clip(const HyperplaneTable<D>&, Piece<D>&, HalfSpace);                   \
  template Piece<D> part_within(const HyperplaneTable<D>&, std::uint32_t, std::span<const HalfSpace>);
STRATA_INSTANTIATE(1)
STRATA_INSTANTIATE(2)
STRATA_INSTANTIATE(3)
#undef STRATA_INSTANTIATE

}  // namespace strata::bsp
