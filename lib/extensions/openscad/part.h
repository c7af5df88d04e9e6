#pragma once
#include <optional>
#include <span>
#include <utility>

#include "strata/expression.h"
#include "strata/planar.h"
#include "strata/shared.h"

namespace strata::openscad {

/// What a node makes: nothing, a shape in the plane, or a solid, which is an expression that nobody has evaluated yet.
/// Empty shapes are nothing. A value; copies share what they hold.
class Part {
 public:
  Part() = default;
  static Part of(planar::Region shape) {
    Part part;
    if (!shape.empty()) part.shape_ = Shared<planar::Region>::make(std::move(shape));
    return part;
  }
  /// `is_union`: it is a union of its primitives, so that its hull is that of their vertices.
  static Part of(Expression solid, bool is_union) {
    Part part;
    part.solid_ = std::move(solid);
    part.is_union_ = is_union;
    return part;
  }

  [[nodiscard]] bool is_shape() const { return static_cast<bool>(shape_); }
  [[nodiscard]] bool is_solid() const { return solid_.has_value(); }
  [[nodiscard]] bool is_empty() const { return !is_shape() && !is_solid(); }
  [[nodiscard]] const planar::Region& shape() const { return *shape_; }  ///< requires is_shape()
  [[nodiscard]] const Expression& solid() const { return *solid_; }      ///< requires is_solid()
  [[nodiscard]] bool is_union() const { return is_union_; }

 private:
  Shared<planar::Region> shape_;
  std::optional<Expression> solid_;
  bool is_union_ = false;
};

}  // namespace strata::openscad
