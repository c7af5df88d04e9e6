#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "strata/mesh.h"
#include "strata/rational.h"

namespace strata::oracle {

/// A set as CGAL's Nef polyhedron of the plane (2) or of space (3), without any code of the library.
template <int D>
class NefComplex {
 public:
  /// The closed or open simplex over independent corners, of which there are 1 to D + 1.
  static NefComplex simplex(std::span<const Vertex> corners, bool closed);
  /// A closed solid by one polyhedron of triangles; D = 3.
  static NefComplex solid(const Mesh& mesh);

  [[nodiscard]] NefComplex unite(const NefComplex& other) const;
  [[nodiscard]] NefComplex intersect(const NefComplex& other) const;
  [[nodiscard]] NefComplex subtract(const NefComplex& other) const;
  [[nodiscard]] NefComplex exclude(const NefComplex& other) const;
  [[nodiscard]] NefComplex complement() const;
  [[nodiscard]] NefComplex interior() const;
  [[nodiscard]] NefComplex closure() const;
  [[nodiscard]] NefComplex boundary() const;
  [[nodiscard]] NefComplex regularization() const;

  /// Cells of each dimension in CGAL's simplified complex.
  [[nodiscard]] std::array<std::size_t, 4> counts() const;
  [[nodiscard]] std::vector<RationalPoint> vertices() const;
  [[nodiscard]] bool contains(const RationalPoint& p) const;

  struct Data;

 private:
  explicit NefComplex(std::shared_ptr<Data> data) : data_(std::move(data)) {}
  std::shared_ptr<Data> data_;  ///< CGAL's queries change caches
};

}  // namespace strata::oracle
