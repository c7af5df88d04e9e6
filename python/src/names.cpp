#include "names.h"

#include <strata/bsp.h>
#include <strata/query.h>

namespace strata::python {

Operation OperationName::value() const {
  std::string text;
  if (nb::try_cast(object, text) && text == "xor") return Operation::symmetric_difference;
  return named(object, "operation", all_operations, [](Operation o) { return name(o); });
}
InputClass InputName::value() const {
  return named(object, "input", all_input_classes, [](InputClass i) { return name(i); });
}
Inside InsideName::value() const {
  return named(object, "inside", all_insides, [](Inside i) { return name(i); });
}
ClipTo ClipName::value() const {
  return named(object, "keep", all_clips, [](ClipTo c) { return name(c); });
}

Element ElementName::value() const {
  return named(object, "element", std::array{Element::vertex, Element::corner, Element::face},
               [](Element e) { return name_of(e); });
}
Interpolation InterpolationName::value() const {
  using enum Interpolation;
  return named(object, "interpolation", std::array{linear, spherical, nearest},
               [](Interpolation i) { return name_of(i); });
}
CutFaces CutFacesName::value() const {
  return named(object, "cut_faces", std::array{CutFaces::turned, CutFaces::of_later_operands},
               [](CutFaces f) { return f == CutFaces::turned ? "turned" : "of-later-operands"; });
}
Unit UnitName::value() const {
  if (object.is_none()) return Unit::none;
  std::string text;
  if (nb::try_cast(object, text))
    if (const auto unit = unit_named(text)) return *unit;
  using enum Unit;
  return named(object, "unit", std::array{micron, millimeter, centimeter, inch, foot, meter},
               [](Unit u) { return std::string(name(u)); });
}

const char* name_of(Element element) {
  constexpr std::array names{"vertex", "corner", "face"};
  return names[static_cast<std::size_t>(element)];
}
const char* name_of(Interpolation interpolation) {
  constexpr std::array names{"linear", "spherical", "nearest"};
  return names[static_cast<std::size_t>(interpolation)];
}
nb::object name_of(Unit unit) {
  if (unit == Unit::none) return nb::none();
  return nb::cast(std::string(name(unit)));
}

std::optional<CoordinateGrid> Grid::value() const {
  if (object.is_none()) return std::nullopt;
  if (!nb::isinstance<nb::str>(object)) {
    CoordinateGrid grid{.step = to_rational(object, "rounding")};
    if (grid.step <= 0) throw nb::value_error("rounding: expected a positive step");
    return grid;
  }
  using Format = CoordinateGrid::Format;
  const Format format = named(object, "rounding", std::array{Format::float64, Format::float32},
                              [](Format f) { return f == Format::float64 ? "float64" : "float32"; });
  return CoordinateGrid{.format = format};
}

Plane PlanePair::value() const {
  if (!nb::hasattr(object, "__len__") || nb::len(object) != 2)
    throw nb::type_error("plane: expected a pair (normal, offset) of three numbers and one");
  return {Point{nb::object(object[0])}.value("plane: normal"), to_rational(nb::object(object[1]), "plane: offset")};
}

namespace {

std::array<Rational, 4> row_of(nb::handle row) {
  std::array<Rational, 4> entries;
  std::size_t count = 0;
  for (const nb::handle entry : row) {
    if (count < entries.size()) entries[count] = to_rational(entry, "matrix");
    ++count;
  }
  if (count != entries.size()) throw nb::value_error("matrix: expected 3 or 4 rows of 4 numbers");
  return entries;
}

}  // namespace

Transform Matrix::value() const {
  const std::size_t rows = nb::hasattr(object, "__len__") ? nb::len(object) : 0;
  if (rows != 3 && rows != 4) throw nb::value_error("matrix: expected 3 or 4 rows of 4 numbers");
  std::array<std::array<Rational, 4>, 3> above;
  for (std::size_t i = 0; i < above.size(); ++i) above[i] = row_of(nb::object(object[i]));
  if (rows == 4) {
    const auto last = row_of(nb::object(object[3]));
    if (last[0] != 0 || last[1] != 0 || last[2] != 0 || last[3] == 0)
      throw nb::value_error("matrix: expected a multiple of (0, 0, 0, 1) as the last row: other maps are not affine");
    for (auto& row : above)
      for (Rational& entry : row) entry /= last[3];
  }
  return Transform(std::move(above));
}

const Engine* engine_named(nb::handle name) {
  if (name.is_none()) return nullptr;
  return named(name, "engine", std::array{&bsp_engine, &layer_engine}, [](const Engine* e) { return e->name; });
}

std::vector<Solid> SolidList::value(const char* role) const {
  std::vector<Solid> solids;
  if (!nb::hasattr(object, "__iter__"))
    throw nb::type_error((std::string(role) + ": expected a list of solids").c_str());
  for (const nb::handle member : object) {
    if (!nb::isinstance<Solid>(member))
      throw nb::type_error((std::string(role) + ": expected solids, found " + nb::cast<std::string>(nb::repr(member)) +
                            "; Solid(mesh) makes one, boolean(operation, meshes) takes arrays")
                               .c_str());
    solids.push_back(nb::cast<Solid>(member));
  }
  return solids;
}

}  // namespace strata::python
