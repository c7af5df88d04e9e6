#include "extensions/planar/extract.h"
#include "extensions/planar/gather.h"
#include "extensions/planar/labels.h"
#include "extensions/planar/thinning.h"
#include "strata/planar.h"

namespace strata::planar {
namespace {

template <class Holds>
Region combine_where(std::span<const Operand> operands, const Holds& holds, const Monitor& monitor) {
  Inside outside;
  outside.is_in.resize(operands.size());
  if (holds(outside)) throw UnboundedResult();
  Thinned thinned = thin(operands);
  Gathered gathered = gather(thinned);
  const Arrangement arrangement = arrange(std::move(gathered.segments), monitor);
  monitor.report(0.5);
  const Subdivision subdivision = subdivide(arrangement, gathered.first_segment);
  monitor.check();
  const std::vector<std::uint8_t> label = Labels(gathered, subdivision, operands).evaluate(holds);
  monitor.check();
  monitor.report(0.8);
  return extract(arrangement, subdivision, label);
}

}  // namespace

Region combine(std::span<const Operand> operands, Operation operation, const Monitor& monitor) {
  return combine_where(
      operands, [operation](const Inside& inside) { return holds(operation, inside); }, monitor);
}

Region combine(std::span<const Operand> operands, const Combination& combination, const Monitor& monitor) {
  return combine_where(operands, combination, monitor);
}

Region union_(const Operand& a, const Operand& b) { return combine(std::array{a, b}, Operation::union_); }
Region intersection(const Operand& a, const Operand& b) { return combine(std::array{a, b}, Operation::intersection); }
Region difference(const Operand& a, const Operand& b) { return combine(std::array{a, b}, Operation::difference); }
Region symmetric_difference(const Operand& a, const Operand& b) {
  return combine(std::array{a, b}, Operation::symmetric_difference);
}
Region fill(const Operand& a) { return combine(std::span(&a, 1), Operation::union_); }

}  // namespace strata::planar
