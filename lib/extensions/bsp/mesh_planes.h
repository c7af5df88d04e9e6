#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/kernel/homogeneous.h"
#include "core/kernel/hyperplane_table.h"
#include "strata/mesh.h"

namespace strata::bsp {

/// Planes through vertices of a mesh. They are added to a table, and vertices that are doubles are noted there. Table
/// and mesh must outlive it. Every result is exact, and O(1) expected.
class MeshPlanes {
 public:
  MeshPlanes(HyperplaneTable<3>& table, ExactMeshView mesh);

  struct Plane {
    std::uint32_t number = 0;
    bool is_reversed = false;  ///< the vertices are seen clockwise from its plus side
  };
  /// The plane through three vertices; nullopt if they are collinear.
  [[nodiscard]] std::optional<Plane> through(const Triangle& vertices);

  /// The plane through two vertices and parallel to an axis, to which their line must not be parallel.
  [[nodiscard]] std::uint32_t along_axis(std::uint32_t p, std::uint32_t q, int axis);

  /// True when the lines of two pairs of different vertices are parallel or equal.
  [[nodiscard]] bool are_parallel(std::array<std::uint32_t, 2> p, std::array<std::uint32_t, 2> q) const;

  /// Notes a vertex that lies in a plane, if it consists of three doubles.
  void note(std::uint32_t plane, std::uint32_t vertex);

  /// True when a vertex consists of three doubles.
  [[nodiscard]] bool is_given(std::uint32_t vertex) const;

  [[nodiscard]] HyperplaneTable<3>& table() const { return table_; }
  [[nodiscard]] ExactMeshView mesh() const { return mesh_; }

 private:
  using Narrow = WideInt<4>;
  static constexpr int most_bits_of_narrow = 83;  ///< of coordinates b: coefficients have at most 3 b + 5, and a sign

  template <class Int>
  [[nodiscard]] std::vector<HPoint<Int>> on_lattice(const Lattice& lattice) const;
  [[nodiscard]] HPoint<Integer> place_of(const RationalPoint& p) const;
  /// Evaluates `find` with the positions of vertices, of either type.
  template <class Find>
  [[nodiscard]] auto found(const Find& find) const {
    return narrow_.empty() ? find(wide_) : find(narrow_);
  }
  template <class Int>
  [[nodiscard]] OrientedHyperplane<3> oriented(const HPlane<Int>& plane) const;

  HyperplaneTable<3>& table_;
  ExactMeshView mesh_;
  int unit_ = 0;                        ///< of the lattice, as an exponent
  std::vector<HPoint<Narrow>> narrow_;  ///< of vertices, in its units; empty if the lattice is too fine
  std::vector<HPoint<Integer>> wide_;   ///< the same, if that is empty
  std::array<std::unordered_map<std::uint64_t, std::uint32_t>, 3> along_;  ///< by axis and edge
};

}  // namespace strata::bsp
