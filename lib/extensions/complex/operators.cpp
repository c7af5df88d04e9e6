#include <algorithm>

#include "strata/complex.h"

namespace strata::complex {
namespace {

using Index = std::uint32_t;

Part part_of(const SelectiveComplex& s, const std::vector<std::uint8_t>& marks, Index first_top, Index c) {
  bool all = marks[c] != 0, any = marks[c] != 0, in_top = false, out_top = false;
  for (const Index f : s.incidences().star(c)) {
    all = all && marks[f] != 0;
    any = any || marks[f] != 0;
    if (f >= first_top) (marks[f] != 0 ? in_top : out_top) = true;
  }
  if (all) return Part::interior;
  if (!any) return Part::exterior;
  if (in_top && out_top) return marks[c] != 0 ? Part::skin : Part::wound;
  return marks[c] != 0 ? Part::hair : Part::cut;
}

Part part_of(const SelectiveComplex& s, Cell c) {
  const Incidences& all = s.incidences();
  return part_of(s, s.marks(), all.number({s.dimension(), 0}), all.number(c));
}

SelectiveComplex where(const SelectiveComplex& s, std::initializer_list<Part> wanted) {
  std::vector<std::uint8_t> marks;
  for (const Part p : parts_of(s)) marks.push_back(std::find(wanted.begin(), wanted.end(), p) != wanted.end() ? 1 : 0);
  return s.with_marks(marks);
}

/// Marks a cell by a rule of two facts: some top of its star is in the set; some top is not.
template <class Rule>
SelectiveComplex by_tops(const SelectiveComplex& s, const Rule& rule) {
  std::vector<std::uint8_t> marks = s.marks();
  const Index first_top = s.incidences().number({s.dimension(), 0});
  for (Index c = 0; c < marks.size(); ++c) {
    bool in = c >= first_top && marks[c] != 0, out = c >= first_top && marks[c] == 0;
    for (const Index f : s.incidences().star(c))
      if (f >= first_top) (marks[f] != 0 ? in : out) = true;
    marks[c] = rule(in, out) ? 1 : 0;
  }
  return s.with_marks(marks);
}

}  // namespace

std::vector<Part> parts_of(const SelectiveComplex& s) {
  const std::vector<std::uint8_t> marks = s.marks();
  const Index first_top = s.incidences().number({s.dimension(), 0});
  std::vector<Part> parts(marks.size());
  for (Index c = 0; c < marks.size(); ++c) parts[c] = part_of(s, marks, first_top, c);
  return parts;
}

SelectiveComplex interior(const SelectiveComplex& s) { return where(s, {Part::interior}); }
SelectiveComplex closure(const SelectiveComplex& s) {
  return where(s, {Part::interior, Part::skin, Part::wound, Part::hair, Part::cut});
}
SelectiveComplex boundary(const SelectiveComplex& s) {
  return where(s, {Part::skin, Part::wound, Part::hair, Part::cut});
}
SelectiveComplex exterior(const SelectiveComplex& s) { return where(s, {Part::exterior}); }
SelectiveComplex regularized(const SelectiveComplex& s) {
  return by_tops(s, [](bool in, bool) { return in; });
}
SelectiveComplex open_regularized(const SelectiveComplex& s) {
  return by_tops(s, [](bool, bool out) { return !out; });
}
SelectiveComplex part(const SelectiveComplex& s, Part which) { return where(s, {which}); }
SelectiveComplex membrane(const SelectiveComplex& s) { return where(s, {Part::skin, Part::wound}); }
SelectiveComplex dangle(const SelectiveComplex& s) { return where(s, {Part::hair, Part::cut}); }

bool lies_in_interior(const SelectiveComplex& s, Cell c) { return part_of(s, c) == Part::interior; }
bool lies_in_exterior(const SelectiveComplex& s, Cell c) { return part_of(s, c) == Part::exterior; }
bool lies_in_boundary(const SelectiveComplex& s, Cell c) { return !lies_in_interior(s, c) && !lies_in_exterior(s, c); }
bool lies_in_membrane(const SelectiveComplex& s, Cell c) {
  const Part p = part_of(s, c);
  return p == Part::skin || p == Part::wound;
}
bool lies_in_dangle(const SelectiveComplex& s, Cell c) {
  const Part p = part_of(s, c);
  return p == Part::hair || p == Part::cut;
}

}  // namespace strata::complex
