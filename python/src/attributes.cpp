#include "attributes.h"

#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <strata/carry_attributes.h>

#include <algorithm>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "channel.h"
#include "material.h"
#include "module.h"
#include "text.h"

namespace strata::python {

namespace {

using namespace nb::literals;

template <class T>
nb::tuple tuple_of(const std::vector<T>& list) {
  nb::list entries;
  for (const T& entry : list) {
    if constexpr (std::is_same_v<T, std::string>)
      entries.append(decoded(entry));
    else
      entries.append(to_python(entry));
  }
  return nb::tuple(entries);
}

std::vector<std::string> names_of(nb::handle list, const char* role) {
  if (nb::isinstance<nb::str>(list)) throw_type_error(std::string(role) + ": expected names in a list, found one str");
  std::vector<std::string> names;
  for (const nb::handle name : list) names.push_back(encoded(name, role));
  return names;
}

/// Adds the channels of a mapping of names to arrays, or of None.
void add_arrays(Attributes& attributes, nb::handle arrays, Element element) {
  if (arrays.is_none()) return;
  if (!nb::hasattr(arrays, "items"))
    throw_type_error(std::string(name_of(element)) + ": expected a mapping of names to arrays, found " +
                     type_of(arrays));
  for (const nb::handle item : nb::object(arrays.attr("items")()))
    attributes.channels.push_back(
        channel_of(encoded(nb::object(item[0]), name_of(element)), nb::object(item[1]), element, {}));
}

Attributes attributes_of(nb::handle channels, nb::handle vertex, nb::handle corner, nb::handle face,
                         nb::handle materials, nb::handle images, nb::handle objects, nb::handle groups) {
  Attributes attributes;
  for (const nb::handle channel : channels) attributes.channels.push_back(channel_in(channel));
  add_arrays(attributes, vertex, Element::vertex);
  add_arrays(attributes, corner, Element::corner);
  add_arrays(attributes, face, Element::face);
  for (const nb::handle material : materials) attributes.materials.push_back(material_of(material, "materials"));
  for (const nb::handle image : images) attributes.images.push_back(image_of(image));
  attributes.objects = names_of(objects, "objects");
  attributes.groups = names_of(groups, "groups");
  check_alone(attributes);
  return attributes;
}

Attributes with_channels(const Attributes& attributes, const nb::args& channels) {
  Attributes all = attributes;
  for (const nb::handle object : channels) {
    const Channel& channel = channel_in(object);
    const auto same = std::ranges::find(all.channels, channel.name, &Channel::name);
    if (same == all.channels.end())
      all.channels.push_back(channel);
    else
      *same = channel;
  }
  check_alone(all);
  return all;
}

nb::tuple channels_of(const AttributesHandle& attributes) {
  nb::list channels;
  for (const Channel& channel : attributes->channels)
    channels.append(nb::cast(std::shared_ptr<const Channel>(attributes, &channel)));
  return nb::tuple(channels);
}

nb::dict arrays_on(const Attributes& attributes, Element element) {
  nb::dict arrays;
  for (const Channel& channel : attributes.channels)
    if (channel.element == element) arrays[decoded(channel.name)] = array_of(channel, nb::find(attributes));
  return arrays;
}

template <Element element>
nb::dict arrays(const Attributes& attributes) {
  return arrays_on(attributes, element);
}

nb::list names(const Attributes& attributes) {
  nb::list names;
  for (const Channel& channel : attributes.channels) names.append(decoded(channel.name));
  return names;
}

/// The values of a channel, or `otherwise`; a name that is no str has none.
nb::object get(const Attributes& attributes, nb::handle name, nb::object otherwise) {
  if (!nb::isinstance<nb::str>(name)) return otherwise;
  const Channel* const channel = attributes.find(encoded(name, "name"));
  return channel == nullptr ? otherwise : array_of(*channel, nb::find(attributes));
}

nb::object item(const Attributes& attributes, nb::handle name) {
  nb::object array = get(attributes, name, nb::object());
  if (array.is_valid()) return array;
  const std::string message = "no channel " + nb::cast<std::string>(nb::repr(name)) + names_in(attributes);
  throw nb::key_error(message.c_str());
}

std::string describe(const Attributes& attributes) {
  std::vector<std::string> parts;
  for (const Channel& channel : attributes.channels) parts.push_back(channel.name + ": " + describe_values(channel));
  const auto count = [&](std::size_t number, const char* what) {
    if (number != 0) parts.push_back(std::to_string(number) + " " + what + (number == 1 ? "" : "s"));
  };
  count(attributes.materials.size(), "material");
  count(attributes.images.size(), "image");
  count(attributes.objects.size(), "object");
  count(attributes.groups.size(), "group");
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return "Attributes(" + text + ")";
}

nb::tuple reduce(const AttributesHandle& attributes) {
  return nb::make_tuple(
      nb::module_::import_("strata_csg._pickle").attr("attributes"),
      nb::make_tuple(channels_of(attributes), tuple_of(attributes->materials), tuple_of(attributes->images),
                     tuple_of(attributes->objects), tuple_of(attributes->groups)));
}

void bind_access(nb::class_<Attributes>& type) {
  type.def_prop_ro("channels", channels_of, nb::sig("def channels(self) -> tuple[Channel, ...]"),
                   "All channels in their order, with element and interpolation.")
      .def_prop_ro("vertex", arrays<Element::vertex>,
                   nb::sig("def vertex(self) -> dict[str, numpy.typing.NDArray[typing.Any]]"),
                   "The arrays of the channels on vertices, by name.")
      .def_prop_ro("corner", arrays<Element::corner>,
                   nb::sig("def corner(self) -> dict[str, numpy.typing.NDArray[typing.Any]]"),
                   "The arrays of the channels on corners, by name: three values per triangle.")
      .def_prop_ro("face", arrays<Element::face>,
                   nb::sig("def face(self) -> dict[str, numpy.typing.NDArray[typing.Any]]"),
                   "The arrays of the channels on faces, by name.")
      .def_prop_ro(
          "materials", [](const Attributes& a) { return tuple_of(a.materials); },
          nb::sig("def materials(self) -> tuple[Material, ...]"), "What the channel \"material\" refers to.")
      .def_prop_ro(
          "images", [](const Attributes& a) { return tuple_of(a.images); },
          nb::sig("def images(self) -> tuple[Image, ...]"), "What materials refer to. O(bytes).")
      .def_prop_ro(
          "objects", [](const Attributes& a) { return tuple_of(a.objects); },
          nb::sig("def objects(self) -> tuple[str, ...]"), "Names, which the channel \"object\" refers to.")
      .def_prop_ro(
          "groups", [](const Attributes& a) { return tuple_of(a.groups); },
          nb::sig("def groups(self) -> tuple[str, ...]"), "Names, which the channel \"group\" refers to.")
      .def("__getitem__", item, nb::sig("def __getitem__(self, name: str, /) -> numpy.typing.NDArray[typing.Any]"))
      .def(
          "__contains__", [](const Attributes& a, nb::object name) { return get(a, name, nb::object()).is_valid(); },
          nb::sig("def __contains__(self, name: object, /) -> bool"))
      .def(
          "__iter__", [](const Attributes& a) { return nb::iter(names(a)); },
          nb::sig("def __iter__(self) -> collections.abc.Iterator[str]"))
      .def("__len__", [](const Attributes& a) { return a.channels.size(); })
      .def("__bool__", [](const Attributes& a) { return !a.empty(); })
      .def("keys", names, nb::sig("def keys(self) -> list[str]"), "The names of the channels in their order.")
      .def("get", get, "name"_a, "default"_a = nb::none(),
           nb::sig("def get(self, name: str, default: typing.Any = None) -> typing.Any"),
           "The values of a channel, or the default where there is none of that name.");
}

}  // namespace

AttributesHandle handle_of(Attributes attributes) {
  return attributes.empty() ? nullptr : std::make_shared<const Attributes>(std::move(attributes));
}

AttributesHandle attributes_of(const Solid& solid) {
  if (solid.attributes().empty()) return nullptr;
  const auto kept = std::make_shared<const Solid>(solid);
  return {kept, &kept->attributes()};
}

AttributesHandle AttributesOption::value() const {
  if (object.is_none()) return nullptr;
  if (!nb::isinstance<Attributes>(object))
    throw_type_error("attributes: expected Attributes or None, found " + type_of(object));
  const auto attributes = nb::cast<AttributesHandle>(object);
  return attributes->empty() ? nullptr : attributes;
}

std::optional<Material> MaterialOption::value(const char* role) const {
  if (object.is_none()) return std::nullopt;
  return material_of(object, role);
}

std::string names_in(const Attributes& attributes) {
  std::string text;
  for (const Channel& channel : attributes.channels) text += (text.empty() ? ", with " : ", ") + channel.name;
  return text;
}

void bind_attributes(nb::module_& m) {
  nb::class_<Attributes> type(m, "Attributes", nb::is_weak_referenceable(),
                              R"(What a mesh carries beside its shape: channels of numbers, materials, images and names.

Like a mapping of names of channels to arrays: ``attributes["color"]``. Immutable: arrays are read-only, and own their
memory. Equal where everything is, in the same order.

Parameters
----------
channels : iterable of Channel
vertex, corner, face : mapping of str to array_like, optional
    More channels, on these elements, with the usual interpolation; see Channel.
materials : iterable of Material
    What the integers of a channel "material" on faces refer to; -1 is none.
images : iterable of Image
    What materials refer to.
objects, groups : iterable of str
    Names that the channels "object" and "group" on faces refer to, in the same way.

Raises
------
TypeError, ValueError
    With the name of the channel: where two have one name, where numbers of elements disagree, for an index beyond its
    list, and for what Channel refuses.

Examples
--------
>>> attributes = Attributes(
...     vertex={"temperature": [20.0, 25.0, 22.5, 21.0]},
...     face={"material": [0, 0, 1, -1]},
...     materials=[Material("steel", metallic=1), Material("paint", color=(0.8, 0, 0))],
... )
>>> attributes
Attributes(temperature: (4,) float64 per vertex, material: (4,) int32 per face, 2 materials)
>>> attributes["material"].tolist(), attributes.materials[1].name
([0, 0, 1, -1], 'paint')
>>> tetrahedron_of = Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
...                       attributes=attributes)
>>> part = Solid(tetrahedron_of) - box((0, 0, 0), (1, 1, 0.5))
>>> sorted(set(part.attributes["material"].tolist()))
[-1, 0, 1]
)");
  const auto nothing = nb::make_tuple();
  type.def(
          "__init__",
          [](Attributes* self, nb::object channels, nb::object vertex, nb::object corner, nb::object face,
             nb::object materials, nb::object images, nb::object objects, nb::object groups) {
            new (self) Attributes(attributes_of(channels, vertex, corner, face, materials, images, objects, groups));
          },
          "channels"_a = nothing, nb::kw_only(), "vertex"_a = nb::none(), "corner"_a = nb::none(),
          "face"_a = nb::none(), "materials"_a = nothing, "images"_a = nothing, "objects"_a = nothing,
          "groups"_a = nothing,
          nb::sig("def __init__(self, channels: collections.abc.Iterable[Channel] = (), *, "
                  "vertex: collections.abc.Mapping[str, numpy.typing.ArrayLike] | None = None, "
                  "corner: collections.abc.Mapping[str, numpy.typing.ArrayLike] | None = None, "
                  "face: collections.abc.Mapping[str, numpy.typing.ArrayLike] | None = None, "
                  "materials: collections.abc.Iterable[Material] = (), "
                  "images: collections.abc.Iterable[Image] = (), "
                  "objects: collections.abc.Iterable[str] = (), "
                  "groups: collections.abc.Iterable[str] = ()) -> None"))
      .def("with_channels", with_channels, "channels"_a,
           nb::sig("def with_channels(self, *channels: Channel) -> Attributes"),
           R"(The same with more channels; one of a name that there is already takes its place.

Examples
--------
>>> Attributes(face={"id": [0, 1]}).with_channels(Channel("id", [5, 6], "face"), Channel("heat", [0.5, 1.5], "face"))
Attributes(id: (2,) int32 per face, heat: (2,) float64 per face)
)")
      .def(
          "only", [](const Attributes& a, nb::object names) { return only(a, names_of(names, "names")); }, "names"_a,
          nb::sig("def only(self, names: collections.abc.Iterable[str]) -> Attributes"),
          R"(The channels with these names, and the lists that they refer to.

Examples
--------
>>> Attributes(face={"id": [0, 1], "heat": [0.5, 1.5]}).only(["heat"])
Attributes(heat: (2,) float64 per face)
)")
      .def(
          "__eq__", [](const Attributes& a, const Attributes& b) { return a == b; }, nb::is_operator(),
          nb::sig("def __eq__(self, other: object, /) -> bool"))
      .def("__hash__", [](const Attributes& a) { return nb::hash(nb::tuple(names(a))); })
      .def("__repr__", describe)
      .def("__reduce__", reduce, nb::sig("def __reduce__(self) -> tuple[typing.Any, ...]"));
  bind_access(type);
}

}  // namespace strata::python
