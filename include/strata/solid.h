#pragma once
/// Solids as values.
#include <array>
#include <span>
#include <vector>

#include "strata/combine.h"
#include "strata/measure.h"
#include "strata/mesh.h"
#include "strata/options.h"
#include "strata/rational.h"
#include "strata/shared.h"

namespace strata {

/// Axis-parallel box; lower > upper for an empty solid.
struct BoundingBox {
  Vertex lower;
  Vertex upper;
};

/// A bounded, closed, regular solid: an immutable value, cheap to copy, safe to read from many threads.
/// Results of operations keep their exact vertices and are exact operands in turn.
class Solid {
 public:
  Solid();                                                          ///< the empty solid
  explicit Solid(Mesh mesh, InputClass input = InputClass::solid);  ///< throws InputError
  /// The same for rational vertices, of which nothing is repaired.
  explicit Solid(ExactMesh mesh, InputClass input = InputClass::solid);

  /// A solid that is known to be one, such as a result: nothing is checked.
  [[nodiscard]] static Solid trusted(ExactMesh mesh);

  [[nodiscard]] const Mesh& mesh() const;  ///< coordinates rounded to nearest doubles
  [[nodiscard]] const ExactMesh& exact_mesh() const;
  [[nodiscard]] const std::vector<Source>& sources() const;  ///< per triangle; operand 0 and itself for an input
  [[nodiscard]] const std::vector<Defect>& notes() const;    ///< what was resolved when it was made
  [[nodiscard]] Rational volume() const;                     ///< exact
  [[nodiscard]] double area() const;
  [[nodiscard]] BoundingBox bounding_box() const;  ///< of the rounded mesh
  [[nodiscard]] bool is_empty() const;
  [[nodiscard]] CanonicalForm canonical() const;

  friend bool operator==(const Solid& a, const Solid& b);  ///< equal as point sets, exactly

  struct Data;

 private:
  friend Solid combine_solids(Operation, std::span<const Solid>, const Options&);
  friend Solid combine_solids(const Formula&, std::span<const Operand>, const Options&);
  Shared<Data> data_;
};

[[nodiscard]] Solid combine_solids(Operation operation, std::span<const Solid> operands, const Options& options = {});

/// The solid for which a formula about operands holds. Throws as `combine` does.
[[nodiscard]] Solid combine_solids(const Formula& formula, std::span<const Operand> operands,
                                   const Options& options = {});

[[nodiscard]] Solid union_(std::span<const Solid> operands);
[[nodiscard]] Solid intersection(std::span<const Solid> operands);
[[nodiscard]] Solid difference(std::span<const Solid> operands);            ///< the first minus all others
[[nodiscard]] Solid symmetric_difference(std::span<const Solid> operands);  ///< in an odd number

[[nodiscard]] Solid operator|(const Solid& a, const Solid& b);
[[nodiscard]] Solid operator&(const Solid& a, const Solid& b);
[[nodiscard]] Solid operator-(const Solid& a, const Solid& b);
[[nodiscard]] Solid operator^(const Solid& a, const Solid& b);

}  // namespace strata
