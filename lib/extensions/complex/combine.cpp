#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/cells/windings.h"
#include "core/exact/failure.h"
#include "extensions/complex/operands.h"
#include "extensions/complex/overlay.h"
#include "strata/complex.h"

namespace strata::complex {
namespace {

Overlay overlay_of(std::span<const SelectiveComplex> operands, const Monitor& monitor) {
  if (operands.front().dimension() == 2) {
    std::vector<Drawing> drawings;
    for (const SelectiveComplex& c : operands) drawings.push_back(drawing_of(c.cells()));
    return overlay(drawings, monitor);
  }
  std::vector<Soup> soups;
  for (const SelectiveComplex& c : operands) soups.push_back(soup_of(c.cells()));
  return overlay(soups, monitor);
}

/// Marks each cell of an overlay by the marks of the operands' cells that contain it.
void mark(Overlay& overlay, const Formula& formula, std::span<const SelectiveComplex> operands) {
  std::vector<std::vector<std::uint8_t>> marks;
  for (const SelectiveComplex& c : operands) marks.push_back(c.marks());
  for (std::size_t d = 0; d < 4; ++d)
    for (std::size_t i = 0; i < overlay.cells.marks[d].size(); ++i) {
      Windings in;
      for (std::uint32_t k = 0; k < operands.size(); ++k) {
        const std::uint32_t label = overlay.labels[d][i * operands.size() + k];
        if (label == none) throw LogicError("a cell of an overlay lies in no cell of an operand");
        if (marks[k][label] != 0) in.set(k, 1);
      }
      overlay.cells.marks[d][i] = formula.holds(in) ? 1 : 0;
    }
}

SelectiveComplex joined(Formula::Join join, std::span<const SelectiveComplex> operands, bool last_negated,
                        const Monitor& monitor = {}) {
  Formula formula(static_cast<std::uint32_t>(operands.size()));
  std::vector<Formula::Term> terms;
  for (std::uint32_t k = 0; k < operands.size(); ++k) terms.push_back(formula.operand(k));
  if (last_negated) terms.back() = !terms.back();
  formula.close(formula.join(join, terms));
  return combine(formula, operands, monitor);
}

}  // namespace

SelectiveComplex combine(const Formula& formula, std::span<const SelectiveComplex> operands, const Monitor& monitor) {
  if (formula.operands() != operands.size())
    throw std::invalid_argument("the formula is about " + std::to_string(formula.operands()) + " operands, not " +
                                std::to_string(operands.size()));
  if (operands.empty()) throw std::invalid_argument("a formula about no complex has no dimension");
  for (const SelectiveComplex& c : operands)
    if (c.dimension() != operands.front().dimension())
      throw std::invalid_argument("complexes of the plane and of space are combined");
  Overlay result = overlay_of(operands, monitor);
  mark(result, formula, operands);
  return SelectiveComplex::of(result.cells);
}

SelectiveComplex union_(std::span<const SelectiveComplex> operands, const Monitor& monitor) {
  return joined(Formula::Join::any, operands, false, monitor);
}
SelectiveComplex operator|(const SelectiveComplex& a, const SelectiveComplex& b) {
  return joined(Formula::Join::any, std::array{a, b}, false);
}
SelectiveComplex operator&(const SelectiveComplex& a, const SelectiveComplex& b) {
  return joined(Formula::Join::all, std::array{a, b}, false);
}
SelectiveComplex operator-(const SelectiveComplex& a, const SelectiveComplex& b) {
  return joined(Formula::Join::all, std::array{a, b}, true);
}
SelectiveComplex operator^(const SelectiveComplex& a, const SelectiveComplex& b) {
  return joined(Formula::Join::odd, std::array{a, b}, false);
}

SelectiveComplex operator~(const SelectiveComplex& a) {
  std::vector<std::uint8_t> marks = a.marks();
  for (std::uint8_t& m : marks) m ^= 1;
  return a.with_marks(marks);
}

}  // namespace strata::complex
