#include "core/cells/validate.h"

#include <algorithm>

#include "core/exact/invariants.h"

namespace strata {
namespace {

constexpr std::size_t face_sample = 64, cell_sample = 32, pair_sample = 8;

void check_list(const InputComplex& input, std::size_t c, const Cell& cell, Violations& violations) {
  if (!cell.mixed && (!cell.faces.empty() || !cell.numbers.empty()))
    violations.add("cell ", c, " is not mixed and lists faces");
  if (!cell.apart && !cell.numbers.empty()) violations.add("cell ", c, " is not apart and lists faces by number alone");
  if (!std::is_sorted(cell.numbers.begin(), cell.numbers.end()))
    violations.add("cell ", c, " lists faces by number out of order");
  for (std::size_t i = 0; i < cell.faces.size(); ++i) {
    const CellFace& f = cell.faces[i];
    if (f.face >= input.face_count()) {
      violations.add("cell ", c, " lists face ", f.face, ", which does not exist");
      continue;
    }
    if (i > 0 && cell.faces[i - 1].face >= f.face) violations.add("cell ", c, " lists faces out of order");
    if (!f.box.reaches_into(cell.box)) violations.add("cell ", c, " lists face ", f.face, ", which is not near");
  }
}

class CellCheck {
 public:
  CellCheck(const InputComplex& input, const CellTree& tree) : input_(input), tree_(tree) {}

  [[nodiscard]] std::vector<std::string> list() && {
    for (const std::string& v : validate(input_, tree_.cells())) violations_.add(v);
    if (violations_.empty()) {
      for_sample(input_.face_count(), face_sample, [&](std::size_t f) { check_face(static_cast<std::uint32_t>(f)); });
      for_sample(tree_.cells().size(), cell_sample, [&](std::size_t c) { check_pairs(tree_.cells()[c]); });
    }
    return std::move(violations_).list();
  }

 private:
  [[nodiscard]] GridBox box_of(std::uint32_t face) const {
    const auto v = input_.face(face);
    return tree_.grid().box(input_.vertex(v[0]), input_.vertex(v[1]), input_.vertex(v[2]));
  }
  /// In doubles: the grid may show faces in one place that are an ulp apart, whose pair no cell needs to own.
  [[nodiscard]] Box exact_box_of(std::uint32_t face) const {
    Box box;
    for (const std::uint32_t v : input_.face(face)) box.include(input_.vertex(v));
    return box;
  }
  [[nodiscard]] static const CellFace* listed(const Cell& cell, std::uint32_t face) {
    const CellFace* f = std::lower_bound(cell.faces.begin(), cell.faces.end(), face,
                                         [](const CellFace& g, std::uint32_t n) { return g.face < n; });
    return f != cell.faces.end() && f->face == face ? f : nullptr;
  }

  [[nodiscard]] static bool lists(const Cell& cell, std::uint32_t face) {
    return listed(cell, face) != nullptr || std::binary_search(cell.numbers.begin(), cell.numbers.end(), face);
  }

  void check_face(std::uint32_t face) {
    const GridBox box = box_of(face);
    bool is_thinned = false, is_listed = false;
    for (const Cell& cell : tree_.cells())
      if (const CellFace* f = listed(cell, face)) {
        is_listed = true;
        is_thinned = f->is_thinned;
        if (f->box.lower != box.lower || f->box.upper != box.upper)
          violations_.add("face ", face, " is listed with another box than that of its corners");
        break;
      }
    for (const std::uint32_t v : input_.face(face)) {
      const Cell& cell = tree_.cells()[tree_.cell_at(tree_.grid().at(input_.vertex(v)))];
      if (cell.mixed && !lists(cell, face))
        violations_.add("face ", face, " is not listed in the cell in which its corner ", v, " is");
    }
    if (!is_listed || is_thinned) return;
    for (const Cell& cell : tree_.cells())
      if (cell.mixed && box.reaches_into(cell.box) && !lists(cell, face))
        violations_.add("face ", face, " is not listed in a cell into which its box reaches");
  }

  void check_pairs(const Cell& cell) {
    for_sample(cell.faces.size(), pair_sample, [&](std::size_t i) {
      for_sample(cell.faces.size(), pair_sample, [&](std::size_t j) {
        const CellFace &a = cell.faces[i], &b = cell.faces[j];
        if (a.face >= b.face || a.is_thinned || b.is_thinned) return;
        if (input_.operand_of_face(a.face) != input_.operand_of_face(b.face)) check_owner(a.face, b.face);
      });
    });
  }

  void check_owner(std::uint32_t f, std::uint32_t g) {
    const GridBox a = box_of(f), b = box_of(g);
    if (!exact_box_of(f).overlaps(exact_box_of(g))) return;
    std::array<std::int32_t, 3> corner{};
    for (std::size_t i = 0; i < 3; ++i) corner[i] = std::max(a.lower[i], b.lower[i]);
    const Cell& owner = tree_.cells()[tree_.cell_at(corner)];
    if (owner.apart && lists(owner, f) && lists(owner, g)) return;
    const CellFace *in_f = listed(owner, f), *in_g = listed(owner, g);
    if (in_f == nullptr || in_g == nullptr || !tree_.owns(owner, *in_f, *in_g))
      violations_.add("no cell owns the faces ", f, " and ", g, ", whose boxes overlap");
  }

  const InputComplex& input_;
  const CellTree& tree_;
  Violations violations_;
};

}  // namespace

std::vector<std::string> validate(const InputComplex& input, std::span<const Cell> cells) {
  Violations violations;
  for (std::size_t c = 0; c < cells.size(); ++c) check_list(input, c, cells[c], violations);
  return std::move(violations).list();
}

std::vector<std::string> validate(const InputComplex& input, const CellTree& tree) {
  return CellCheck(input, tree).list();
}

}  // namespace strata
