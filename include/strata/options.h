#pragma once
/// Operations, what is declared about operands, and how an operation is computed.
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>

#include "strata/coordinate_grid.h"
#include "strata/errors.h"
#include "strata/monitor.h"

namespace strata {

/// Regularized set operations on n >= 1 operands. The result is the closure of the interior of a set of points, so it
/// has no isolated faces, edges or points, and none are missing (Requicha 1980).
enum class Operation {
  union_,               ///< points in any operand
  intersection,         ///< points in all operands
  difference,           ///< points in the first operand and in no other
  symmetric_difference  ///< points in an odd number of operands
};

/// All of them. Verbs, documents and property tests iterate over this list.
inline constexpr std::array all_operations{Operation::union_, Operation::intersection, Operation::difference,
                                           Operation::symmetric_difference};

/// Its name, in files and on the command line: union, intersection, difference, symmetric-difference.
[[nodiscard]] constexpr const char* name(Operation operation) {
  constexpr std::array names{"union", "intersection", "difference", "symmetric-difference"};
  static_assert(names.size() == all_operations.size());
  return names[static_cast<std::size_t>(operation)];
}

/// The operation of that name, or of the short name xor; none if there is no such operation.
[[nodiscard]] constexpr std::optional<Operation> operation_named(std::string_view text) {
  for (const Operation operation : all_operations)
    if (text == name(operation)) return operation;
  if (text == "xor") return Operation::symmetric_difference;
  return std::nullopt;
}

/// Its sign between two operands in expressions: | & - ^. For more operands, signs are applied from left to right.
[[nodiscard]] constexpr char sign(Operation operation) {
  constexpr std::array signs{'|', '&', '-', '^'};
  static_assert(signs.size() == all_operations.size());
  return signs[static_cast<std::size_t>(operation)];
}

/// What the caller declares about the operands. The winding number of a point is how often the oriented surface goes
/// round it: 1 inside a simple closed surface that is oriented outwards.
enum class InputClass {
  /// Closed. Intersections of each operand with itself are searched, and winding numbers are computed: what bounds a
  /// solid is taken as `solid`, and else all operands as `overlapping`, with a note that says where. No result is other
  /// than the resolved one. The search takes some streaming passes over the faces, in parallel.
  automatic,
  /// Closed, with winding numbers 0 and 1 only, and faces that meet in common vertices and edges only: the caller's
  /// promise. Checked: every edge is used as often in one direction as in the other, the volume is not negative. Not
  /// searched: self-intersection. Where two operands cross in a place in which one of them crosses itself, it is found
  /// and refused. Elsewhere faces of an operand that crosses itself stay as they are, so the result crosses itself as
  /// well, and its volume counts some points twice. Slices of what crosses or touches itself have loops that do.
  solid,
  /// Closed, may cross and overlap itself: resolved completely; inside is where the winding number is positive.
  overlapping,
  /// Any triangles: equal vertices are welded, duplicate and degenerate faces dropped, orientation made consistent and
  /// outwards; what is then closed is taken as overlapping. No vertex moves, no hole is filled.
  repair,
  /// Any triangles, made a solid: as `repair`, and loops of open edges are filled with triangles between their
  /// vertices, of least area. The surface is then closed, so that winding numbers say what is inside, exactly. No
  /// vertex moves. A shell whose faces are oriented alike stays if it faces outwards, also inside another one, which
  /// then covers it. The notes list the loops. Refused: faces that enclose nothing even so. Triangles of results that
  /// are parts of fillings have as their source a face beside the loop.
  soup,
};

inline constexpr std::array all_input_classes{InputClass::automatic, InputClass::solid, InputClass::overlapping,
                                              InputClass::repair, InputClass::soup};

/// As it is written in files and on the command line: automatic, solid, overlapping, repair, soup.
[[nodiscard]] constexpr const char* name(InputClass input) {
  constexpr std::array names{"automatic", "solid", "overlapping", "repair", "soup"};
  return names[static_cast<std::size_t>(input)];
}

/// Where the inside of a closed mesh is. All three agree on the boundary of a solid.
enum class Inside {
  winding,   ///< where the winding number is positive: what is covered twice is inside, what is turned round is not
  even_odd,  ///< where the winding number is odd: what is covered twice is a cavity; orientation does not matter
  outer      ///< all that the mesh closes off from infinity: without cavities; orientation does not matter
};

inline constexpr std::array all_insides{Inside::winding, Inside::even_odd, Inside::outer};

/// As it is written on the command line: winding, even-odd, outer.
[[nodiscard]] constexpr const char* name(Inside inside) {
  constexpr std::array names{"winding", "even-odd", "outer"};
  return names[static_cast<std::size_t>(inside)];
}

struct Engine;    // combine.h
struct Material;  // attributes.h

/// How an operation is computed. Every field has a default: `{.threads = 1}` is enough.
struct Options {
  InputClass input = InputClass::automatic;
  /// Of class `soup`: holes of more edges are refused, by name.
  std::size_t most_hole_edges = std::numeric_limits<std::size_t>::max();
  const Engine* engine = nullptr;  ///< null: the arrangement, which also evaluates every formula
  unsigned threads = 0;            ///< 0: all cores. The result does not depend on it.
  bool exact_vertices = false;     ///< fill BooleanResult::exact (rationals; costs time per new vertex)
  /// If given, `combine` rounds the mesh to this grid such that it bounds a solid again (`round_to_solid`), and tells
  /// what moved in BooleanResult::rounding. Exact vertices, where they are asked for, go before: nothing is rounded
  /// then. Solids are exact; their functions do not look at it.
  std::optional<CoordinateGrid> rounding = {};
  /// Fill BooleanResult::measured with facts about the exact result, and, where rounding had to rearrange faces,
  /// RoundingReport::exact and rounded. Takes a few passes over the result; exact vertices need not be asked for.
  /// Functions of Solid do not look at it.
  bool measure = false;
  /// Where attributes are carried (carry_attributes.h): what cut faces are made of that have no material. Null:
  /// nothing.
  const Material* cut_material = nullptr;
  Progress progress = {};               ///< any callable that takes a double: the fraction done
  const CancelToken* cancel = nullptr;  ///< null: the operation cannot be cancelled
};

}  // namespace strata
