#pragma once
/// Point sets that need not be regular, as marked cells: selective geometric complexes (SGC), which represent the same
/// sets as Nef polyhedra with bounded facets.
///
/// All functions are exact and may be called from many threads at once.
#include <array>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "strata/expression.h"
#include "strata/formula.h"
#include "strata/function.h"
#include "strata/mesh.h"
#include "strata/options.h"
#include "strata/rational.h"
#include "strata/shared.h"
#include "strata/solid.h"

namespace strata::complex {

inline constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// A cell by dimension and number: a vertex, an edge, a face or a volume.
struct Cell {
  int dimension = 0;
  std::uint32_t index = 0;

  friend auto operator<=>(const Cell&, const Cell&) = default;
};

/// An incidence of a face and an edge on its boundary, with the side. An edge has two wings of one face where that face
/// lies on both of its sides.
struct Wing {
  std::uint32_t edge = 0, face = 0;
  bool left = false;  ///< of the edge, looking from its lower vertex to its higher one, with the face's upper side up

  friend auto operator<=>(const Wing&, const Wing&) = default;
};

/// A vertex or edge whose neighbourhood is in one cell of higher dimension: it lies on no edge (or face) of it.
struct Isolated {
  std::uint32_t cell = 0, in = 0;

  friend auto operator<=>(const Isolated&, const Isolated&) = default;
};

/// The cells of a linear complex and how they bound one another, as plain arrays. Cells are open in their affine hulls,
/// connected and pairwise disjoint, and cover the plane (z = 0) or all of space.
///
/// The upper side of a face is the one to which the normal with a positive first non-zero coordinate points; in the
/// plane it is that of z. Vertices are in lexicographic order of exact positions, so the first end of an edge is its
/// lower one, and collinear edges run the same way.
struct Cells {
  int dimension = 3;  ///< of the space: 2 or 3
  std::vector<Vertex> points;
  std::vector<ExactVertex> exact;                   ///< those that are not three doubles, by increasing vertex
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< lower, higher vertex
  std::vector<std::uint32_t> plane;                 ///< per face; at one edge, faces in one plane have equal numbers
  std::vector<std::array<std::uint32_t, 2>> sides;  ///< per face: volumes above and below; in space
  std::vector<Wing> wings;                          ///< sorted
  std::vector<Isolated> vertices_in_faces, vertices_in_volumes, edges_in_volumes;  ///< sorted
  std::array<std::vector<std::uint8_t>, 4> marks;                                  ///< 1 in the set; per dimension

  [[nodiscard]] std::uint32_t count(int d) const {
    return static_cast<std::uint32_t>(marks[static_cast<std::size_t>(d)].size());
  }
  [[nodiscard]] RationalPoint position(std::uint32_t vertex) const;  ///< O(log exact.size())

  /// All arrays but `plane` are compared: its numbers only distinguish planes.
  friend bool operator==(const Cells& a, const Cells& b);
};

/// Lists of numbers in one array.
class Lists {
 public:
  Lists() = default;
  /// `count` lists. `visit(add)` calls `add(list, entry)` for every entry, in order; it is called twice. Internal.
  template <class Visit>
  Lists(std::uint32_t count, const Visit& visit);
  /// The transitive closure: per list, the entries of its entries' lists, and so on, each once, increasing. Requires
  /// that there are no cycles.
  [[nodiscard]] Lists followed() const;

  [[nodiscard]] std::span<const std::uint32_t> operator[](std::uint32_t list) const {
    return std::span(entries_).subspan(first_[list], first_[list + 1] - first_[list]);
  }
  [[nodiscard]] std::size_t size() const { return entries_.size(); }  ///< of all lists

 private:
  std::vector<std::uint32_t> first_{0};
  std::vector<std::uint32_t> entries_;
};

/// The incidence relation of cells of all dimensions. Cells have one numbering here: vertices first, volumes last.
class Incidences {
 public:
  Incidences() = default;
  explicit Incidences(const Cells& cells);  ///< O(k log d) for k incidences and at most d at a cell below volumes

  [[nodiscard]] std::uint32_t number(Cell c) const { return first_[static_cast<std::size_t>(c.dimension)] + c.index; }
  [[nodiscard]] Cell cell(std::uint32_t number) const;
  [[nodiscard]] std::uint32_t count() const { return first_[4]; }  ///< cells
  /// The cells that a cell lies in the boundary of.
  [[nodiscard]] std::span<const std::uint32_t> star(std::uint32_t number) const { return star_[number]; }
  /// The cells that make up its boundary.
  [[nodiscard]] std::span<const std::uint32_t> boundary(std::uint32_t number) const { return boundary_[number]; }
  [[nodiscard]] std::size_t size() const { return star_.size(); }  ///< pairs of cells

 private:
  std::array<std::uint32_t, 5> first_{};
  Lists star_, boundary_;
};

/// A point set of the plane or of space as a selective geometric complex: cells that are pairwise disjoint and cover
/// all of it, each in the set or not. The set may be open, closed or neither, of mixed dimension, bounded or not; its
/// boundary is bounded: finitely many polygons, segments and points.
///
/// Law: always the minimal complex of its set, so two sets are equal exactly when their cells are. An immutable value:
/// copying is O(1), reading is thread-safe.
/// Source: Rossignac and O'Connor 1989; lib/extensions/complex/theory.md.
class SelectiveComplex {
 public:
  explicit SelectiveComplex(int dimension = 3);                  ///< the empty set of the plane (2) or of space (3)
  [[nodiscard]] static SelectiveComplex all(int dimension = 3);  ///< the whole plane, or space
  /// Of cells that fulfil what Cells says, minimal or not; they are simplified. Not checked.
  [[nodiscard]] static SelectiveComplex of(const Cells& cells);

  [[nodiscard]] int dimension() const { return cells().dimension; }
  [[nodiscard]] const Cells& cells() const;
  [[nodiscard]] const Incidences& incidences() const;
  [[nodiscard]] std::uint32_t count(int d) const { return cells().count(d); }  ///< cells of one dimension
  [[nodiscard]] bool mark(Cell c) const { return cells().marks[static_cast<std::size_t>(c.dimension)][c.index] != 0; }
  [[nodiscard]] std::vector<std::uint8_t> marks() const;  ///< of all cells, by their numbers in `incidences`
  /// Another set over the same cells, by numbers in `incidences`, simplified. Throws std::invalid_argument for a wrong
  /// number of marks. O(n log n).
  [[nodiscard]] SelectiveComplex with_marks(std::span<const std::uint8_t> marks) const;
  [[nodiscard]] SelectiveComplex with_marks(FunctionRef<bool(Cell)> mark) const;

  [[nodiscard]] bool is_empty() const;
  [[nodiscard]] bool is_all() const;
  /// True when the unbounded cell of the highest dimension is not in the set: all others are bounded.
  [[nodiscard]] bool is_bounded() const { return !mark({dimension(), 0}); }

  friend bool operator==(const SelectiveComplex& a, const SelectiveComplex& b);  ///< as point sets, exactly

 private:
  struct Data;
  explicit SelectiveComplex(Shared<Data> data) : data_(std::move(data)) {}
  Shared<Data> data_;
};

/// The points for which a closed formula about operands holds: not regularized, in one overlay of all operands. Throws
/// std::invalid_argument if their number is not the formula's or their dimensions differ, Cancelled, std::length_error.
[[nodiscard]] SelectiveComplex combine(const Formula& formula, std::span<const SelectiveComplex> operands,
                                       const Monitor& monitor = {});

[[nodiscard]] SelectiveComplex union_(std::span<const SelectiveComplex> operands, const Monitor& monitor = {});
[[nodiscard]] SelectiveComplex operator|(const SelectiveComplex& a, const SelectiveComplex& b);
[[nodiscard]] SelectiveComplex operator&(const SelectiveComplex& a, const SelectiveComplex& b);
[[nodiscard]] SelectiveComplex operator-(const SelectiveComplex& a, const SelectiveComplex& b);
[[nodiscard]] SelectiveComplex operator^(const SelectiveComplex& a, const SelectiveComplex& b);
[[nodiscard]] SelectiveComplex operator~(const SelectiveComplex& a);  ///< the complement. O(n)

/// Whether the boundary of a set, relative to its affine hull, belongs to the set.
enum class Border : std::uint8_t { closed, open };

/// A solid, with its boundary or without. O(n log n).
[[nodiscard]] SelectiveComplex of_solid(const Solid& solid, Border border = Border::closed);

/// The convex hull of one to `dimension` + 1 affinely independent points: a point, segment, triangle or tetrahedron.
/// An open one is its relative interior; a point is the same either way. In the plane z must be 0.
/// Throws InputError for coordinates that are not finite and for corners that are not independent.
[[nodiscard]] SelectiveComplex simplex(int dimension, std::span<const Vertex> corners, Border border = Border::closed);

/// Closed triangles, segments and points, which may meet one another anywhere.
struct Simplices {
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  std::vector<std::array<std::uint32_t, 2>> segments;
  std::vector<std::uint32_t> points;
};

/// Their union in space, in one arrangement. Throws InputError for coordinates that are not finite, indices out of
/// range, triangles of zero area and segments of no length.
[[nodiscard]] SelectiveComplex unite_closed(const Simplices& simplices);

/// A point of the plane.
using Point2 = std::array<double, 2>;

/// The points of the plane about which loops wind an odd number of times in all (even-odd rule), as a closed or an open
/// regularized set. Loops may cross themselves and each other. Throws InputError for coordinates that are not finite.
[[nodiscard]] SelectiveComplex polygon(std::span<const std::vector<Point2>> loops, Border border = Border::closed);

/// The value of an expression in which complexes take the places of solids: one per primitive (Expression::primitives),
/// in that order. Not regularized, in one overlay of all. Throws as `combine` does.
[[nodiscard]] SelectiveComplex evaluate(const Expression& expression, std::span<const SelectiveComplex> primitives,
                                        const Monitor& monitor = {});

/// True when a point is in a union of intersections of complexes. Every complex is located in at most once.
[[nodiscard]] bool contains(const Expression::Products& products, std::span<const SelectiveComplex> primitives,
                            const Vertex& p);

// --- The operators of point set topology, by marks and incidences alone: O(incidences), and the simplification. S.i,
// S.c and so on are Rossignac's notation (lib/extensions/complex/theory.md). ---

[[nodiscard]] SelectiveComplex interior(const SelectiveComplex& s);  ///< S.i, the points with a neighbourhood in S
[[nodiscard]] SelectiveComplex closure(const SelectiveComplex& s);  ///< S.c, the points whose neighbourhoods all meet S
[[nodiscard]] SelectiveComplex boundary(
    const SelectiveComplex& s);  ///< S.b, the points whose neighbourhoods all meet S and its complement
[[nodiscard]] SelectiveComplex exterior(const SelectiveComplex& s);          ///< S.e, the interior of the complement
[[nodiscard]] SelectiveComplex regularized(const SelectiveComplex& s);       ///< S.r = S.i.c
[[nodiscard]] SelectiveComplex open_regularized(const SelectiveComplex& s);  ///< S.o = S.c.i

/// The parts that a set divides the plane or space into: exclusive and exhaustive. The membrane is the common boundary
/// of interior and exterior, the dangle is the rest of the boundary.
enum class Part : std::uint8_t {
  interior,
  exterior,
  skin,   ///< of the membrane, in the set
  wound,  ///< of the membrane, not in the set
  hair,   ///< of the dangle, in the set
  cut,    ///< of the dangle, not in the set
};
// Hair mostly touches the exterior only, and a cut the interior only, but not always: theory.md, section 5.

/// The part of each cell, by its number in `Incidences`. O(incidences).
[[nodiscard]] std::vector<Part> parts_of(const SelectiveComplex& s);

[[nodiscard]] SelectiveComplex part(const SelectiveComplex& s, Part which);
[[nodiscard]] SelectiveComplex membrane(const SelectiveComplex& s);  ///< S.m, S.i.b n S.e.b: skin and wound
[[nodiscard]] SelectiveComplex dangle(const SelectiveComplex& s);    ///< S.d, S.b \ S.m: hair and cut

/// Tests of one cell c by its mark c.m and the marks f.m of the cells f of its star c.s. O(|c.s|).
[[nodiscard]] bool lies_in_interior(const SelectiveComplex& s, Cell c);  ///< c.m, and every f of c.s has f.m
[[nodiscard]] bool lies_in_exterior(const SelectiveComplex& s, Cell c);  ///< neither c.m nor any f.m
[[nodiscard]] bool lies_in_boundary(const SelectiveComplex& s, Cell c);  ///< neither of these
/// Of the cells f of c.s that have no star themselves, one has f.m and one has not.
[[nodiscard]] bool lies_in_membrane(const SelectiveComplex& s, Cell c);
[[nodiscard]] bool lies_in_dangle(const SelectiveComplex& s, Cell c);  ///< in the boundary, and not in the membrane

/// The connected components of a set or of its complement, by cells.
struct Components {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> of_cell;  ///< by number in `Incidences`; `none` for cells that are not in it
};

/// The connected components of the set, or of its complement: cells are adjacent where one lies in the boundary of the
/// other. Numbered in the order of their lowest cells.
/// O(incidences).
[[nodiscard]] Components components(const SelectiveComplex& s, bool of_the_set = true);

/// The components as sets of their own, in that order. O(components * n).
[[nodiscard]] std::vector<SelectiveComplex> separate(const SelectiveComplex& s);

/// The union of the bounded components of the complement, also of sets that are not bounded themselves.
[[nodiscard]] SelectiveComplex holes(const SelectiveComplex& s);
[[nodiscard]] std::uint32_t count_holes(const SelectiveComplex& s);

[[nodiscard]] bool is_connected(const SelectiveComplex& s);  ///< at most one component
/// True when a bounded set has no holes: its complement is connected. Throws std::invalid_argument for unbounded sets.
[[nodiscard]] bool is_simply_connected(const SelectiveComplex& s);

[[nodiscard]] bool is_open(const SelectiveComplex& s);                ///< S = S.i
[[nodiscard]] bool is_closed(const SelectiveComplex& s);              ///< S = S.c
[[nodiscard]] bool is_closed_regularized(const SelectiveComplex& s);  ///< S = S.r
[[nodiscard]] bool is_open_regularized(const SelectiveComplex& s);    ///< S = S.o

/// The exact volume of a cell of dimension 3; no value where it is unbounded. O(size of its boundary + faces).
[[nodiscard]] std::optional<Rational> volume_of_cell(const SelectiveComplex& s, std::uint32_t volume);

/// The exact volume of the set; no value where it is unbounded; 0 in the plane. O(n).
[[nodiscard]] std::optional<Rational> volume(const SelectiveComplex& s);

/// The area of the faces of the set, correct to a few units in the last place; no value where one is unbounded. (In a
/// minimal complex no face lies between two volumes of the set, so in space these are parts of its boundary.)
[[nodiscard]] std::optional<double> area(const SelectiveComplex& s);
/// In the plane, exact.
[[nodiscard]] std::optional<Rational> exact_area(const SelectiveComplex& s);

/// The length of the edges of the set, correct to a few units in the last place. O(n).
[[nodiscard]] double length(const SelectiveComplex& s);
/// The exact square of the length of one edge.
[[nodiscard]] Rational squared_length_of_cell(const SelectiveComplex& s, std::uint32_t edge);

/// The cells of the boundary whose points are not manifold: around these the boundary is no curve in the plane, no
/// surface in space. In the plane vertices without exactly two edges; in space edges without exactly two wings, and
/// vertices around which faces and edges do not form one cycle. By dimension and number. In a minimal complex every
/// cell but those of full dimension lies in the boundary: lib/extensions/complex/theory.md, section 3. O(n), and exact
/// arithmetic where a face has several corners at one vertex.
[[nodiscard]] std::vector<Cell> non_manifold_cells(const SelectiveComplex& s);

/// True when there are none.
[[nodiscard]] bool is_manifold(const SelectiveComplex& s);

/// The cell that a point lies in. In the plane z must be 0. Exact, O(n), by ray casting with symbolic perturbation.
[[nodiscard]] Cell locate(const SelectiveComplex& s, const RationalPoint& p);
[[nodiscard]] Cell locate(const SelectiveComplex& s, const Vertex& p);  ///< throws std::invalid_argument if not finite

[[nodiscard]] bool contains(const SelectiveComplex& s, const RationalPoint& p);
[[nodiscard]] bool contains(const SelectiveComplex& s, const Vertex& p);

/// Writes a complex as text; the format is in lib/extensions/complex/sgc.md. Law: equal sets give equal bytes.
void write_sgc(std::ostream& out, const SelectiveComplex& s);
/// The same to a file, which is written beside the target and renamed when complete. Throws IoError.
void write_sgc(const std::string& path, const SelectiveComplex& s);

/// Reads such a text, and checks that cells and incidences are right by arranging them anew. Throws IoError with the
/// line. `name` stands for the file in messages.
[[nodiscard]] SelectiveComplex read_sgc(std::istream& in, const std::string& name);
[[nodiscard]] SelectiveComplex read_sgc(const std::string& path);

}  // namespace strata::complex
