#include "strata/workpiece/workpiece.h"

#include <array>

#include "strata/mesh/measure.h"

namespace strata {

struct Workpiece::Data {
  Solid solid;
};

Workpiece::Workpiece() : data_(std::make_shared<const Data>()) {}

Workpiece::Workpiece(const Solid& solid) : data_(std::make_shared<const Data>(Data{solid})) {}

Workpiece Workpiece::with(Operation operation, const Solid& tool, const Options& options) const {
  const std::array<Solid, 2> both{data_->solid, tool};
  return Workpiece(combine_solids(operation, both, options));
}

Solid Workpiece::solid() const { return data_->solid; }
bool Workpiece::is_empty() const { return data_->solid.is_empty(); }
std::size_t Workpiece::triangle_count() const { return data_->solid.mesh().triangles.size(); }
double Workpiece::volume() const { return data_->solid.volume().convert_to<double>(); }

}  // namespace strata
