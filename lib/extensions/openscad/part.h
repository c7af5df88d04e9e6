#pragma once
#include <optional>
#include <span>
#include <utility>

#include "strata/expression.h"
#include "strata/planar.h"
#include "strata/shared.h"
#include "strata/solid.h"
#include "strata/transform.h"

namespace strata::openscad {

/// What a node makes: nothing, a shape in the plane, or a solid, which is an expression. Nobody has evaluated it yet,
/// except where several nodes need its value. Empty shapes are nothing. A value; copies share what they hold.
class Part {
 public:
  /// The image of `solid` under `map` is the value of the expression.
  struct Value {
    Solid solid;
    Transform map;
  };

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

  /// The same solid, whose value is known. Requires is_solid().
  [[nodiscard]] Part with_value(Solid value) const { return with_value({std::move(value), Transform()}); }
  /// The image of a solid. Vertices that are rounded are those of its primitives, so that its value is not known then.
  [[nodiscard]] Part moved(const Transform& map, Placement placement) const {
    const Part image = of(solid_->transformed(map, placement), is_union_);
    if (!value_ || placement != Placement::exact) return image;
    return image.with_value({value_->solid, map * value_->map});
  }

  [[nodiscard]] bool is_shape() const { return static_cast<bool>(shape_); }
  [[nodiscard]] bool is_solid() const { return solid_.has_value(); }
  [[nodiscard]] bool is_empty() const { return !is_shape() && !is_solid(); }
  [[nodiscard]] const planar::Region& shape() const { return *shape_; }  ///< requires is_shape()
  [[nodiscard]] const Expression& solid() const { return *solid_; }      ///< requires is_solid()
  [[nodiscard]] bool is_union() const { return is_union_; }
  [[nodiscard]] const std::optional<Value>& value() const { return value_; }

 private:
  [[nodiscard]] Part with_value(Value value) const {
    Part part = *this;
    part.value_ = std::move(value);
    return part;
  }

  Shared<planar::Region> shape_;
  std::optional<Expression> solid_;
  bool is_union_ = false;
  std::optional<Value> value_;
};

}  // namespace strata::openscad
