#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <strata/solid.h>

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "arrays.h"
#include "module.h"
#include "text.h"

namespace strata::python {

namespace {

using namespace nb::literals;

/// Positions that are no doubles, as one text: what pickle keeps of them.
std::string text_of(std::span<const ExactVertex> exact) {
  std::string text;
  for (const ExactVertex& vertex : exact) {
    text += std::to_string(vertex.vertex);
    for (const Rational& x : vertex.position) text += ' ' + x.str();
    text += '\n';
  }
  return text;
}

std::vector<ExactVertex> exact_of(std::string_view text) {
  std::vector<ExactVertex> exact;
  const auto next = [&text] {
    const std::size_t end = text.find_first_of(" \n");
    if (end == std::string_view::npos) throw std::invalid_argument("the pickled solid is incomplete");
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(end + 1);
    return word;
  };
  while (!text.empty()) {
    ExactVertex vertex;
    vertex.vertex = static_cast<std::uint32_t>(Integer(next()).to_int64());
    for (Rational& x : vertex.position) x = Rational(next());
    exact.push_back(std::move(vertex));
  }
  return exact;
}

/// With the class, which may be derived from Solid in Python, and what that adds.
nb::tuple reduce(nb::object self) {
  const auto& solid = nb::cast<const Solid&>(self);
  return nb::make_tuple(
      nb::module_::import_("strata_csg._pickle").attr("solid"),
      nb::make_tuple(self.type(), rows_of(solid.mesh().vertices, self), rows_of(solid.mesh().triangles, self),
                     text_of(solid.exact_mesh().exact), operands_of(solid.sources(), self),
                     faces_of(solid.sources(), self), attributes_of(solid)),
      nb::getattr(self, "__dict__", nb::none()));
}

Solid restored(nb::object vertices, nb::object triangles, const std::string& exact, nb::object operands,
               nb::object faces, const AttributesOption& attributes) {
  ExactMesh mesh = mesh_of_arrays(vertices, triangles)->copy();
  mesh.exact = exact_of(exact);
  const MeshHandle held = copy_of(mesh_of(std::move(mesh)));
  std::vector<Source> sources = sources_of(operands, faces);
  if (sources.size() != held->view.triangles.size())
    throw std::invalid_argument("the pickled solid has not as many sources as triangles");
  const Solid solid = Solid::trusted(held->owned, std::move(sources));
  const AttributesHandle carried = attributes.value();
  return carried ? solid.with_attributes(*carried) : solid;
}

/// As an object of Solid, or of a class that is derived from it in Python.
nb::object object_of(nb::handle type, Solid solid) {
  nb::object object = nb::inst_alloc(type);
  new (nb::inst_ptr<Solid>(object)) Solid(std::move(solid));
  nb::inst_mark_ready(object);
  return object;
}

nb::object restored_as(nb::type_object type, nb::object vertices, nb::object triangles, const std::string& exact,
                       nb::object operands, nb::object faces, const AttributesOption& attributes) {
  if (!nb::cast<bool>(nb::module_::import_("builtins").attr("issubclass")(type, nb::type<Solid>())))
    throw_type_error("type: expected Solid, or a class derived from it");
  return object_of(type, restored(vertices, triangles, exact, operands, faces, attributes));
}

/// A solid is immutable, and its own copy; what a derived class adds need not be.
bool has_state(nb::handle self) { return nb::hasattr(self, "__dict__"); }

nb::object copied(nb::object self) {
  if (!has_state(self)) return self;
  nb::object copy = object_of(self.type(), nb::cast<const Solid&>(self));
  copy.attr("__dict__").attr("update")(self.attr("__dict__"));
  return copy;
}

nb::object deeply_copied(nb::object self, nb::object memo) {
  if (!has_state(self)) return self;
  nb::object copy = object_of(self.type(), nb::cast<const Solid&>(self));
  memo[nb::steal(PyLong_FromVoidPtr(self.ptr()))] = copy;  // the state may refer to its object
  copy.attr("__dict__").attr("update")(nb::module_::import_("copy").attr("deepcopy")(self.attr("__dict__"), memo));
  return copy;
}

}  // namespace

void bind_solid_copies(nb::module_& m) {
  nb::class_<Solid> type = nb::borrow<nb::class_<Solid>>(m.attr("Solid"));
  type.def("__copy__", copied, nb::sig("def __copy__(self) -> Solid"))
      .def("__deepcopy__", deeply_copied, "memo"_a, nb::sig("def __deepcopy__(self, memo: object) -> Solid"))
      .def("__reduce__", reduce, nb::sig("def __reduce__(self) -> tuple[typing.Any, ...]"));
  m.def("_solid_of", restored_as, "type"_a, "vertices"_a, "triangles"_a, "exact"_a, "operands"_a, "faces"_a,
        "attributes"_a.none(), "What pickle calls for a Solid.");
}

}  // namespace strata::python
