#include "channel.h"

#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>
#include <strata/carry_attributes.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "arrays.h"
#include "module.h"
#include "numpy.h"
#include "text.h"

namespace strata::python {

namespace {

using namespace nb::literals;

std::string role_of(const std::string& channel) { return "channel \"" + channel + "\""; }

template <class T>
ChannelValues copied(const nb::object& array, const char* type) {
  using Flat = nb::ndarray<nb::numpy, const T, nb::ndim<1>, nb::c_contig>;
  const auto flat = nb::cast<Flat>(nb::object(contiguous(array, type).attr("ravel")()));
  return std::vector<T>(flat.data(), flat.data() + flat.shape(0));
}

void require_32_bits(const nb::object& array, const std::string& role) {
  if (size_of(array) == 0) return;
  using Limits = std::numeric_limits<std::int32_t>;
  const nb::object least = array.attr("min")(), most = array.attr("max")();
  if (least < nb::int_(Limits::min())) throw_value_error(role + ": " + text_of(least) + " is no integer of 32 bits");
  if (most > nb::int_(Limits::max())) throw_value_error(role + ": " + text_of(most) + " is no integer of 32 bits");
}

ChannelValues values_of(const nb::object& array, const std::string& role) {
  const std::string kind = kind_of(array);
  const std::size_t bytes = item_size(array);
  if (kind == "f" && bytes <= sizeof(float)) return copied<float>(array, "float32");
  if (kind == "f" && bytes == sizeof(double)) return copied<double>(array, "float64");
  if (kind == "u" && bytes == 1) return copied<std::uint8_t>(array, "uint8");
  if (kind != "i" && kind != "u")
    throw_type_error(role + ": expected floats of 32 or 64 bits, bytes or integers, found type " +
                     text_of(array.attr("dtype")));
  require_32_bits(array, role);
  return copied<std::int32_t>(array, "int32");
}

Interpolation usual_interpolation(const Channel& channel) {
  if (std::holds_alternative<std::vector<std::int32_t>>(channel.values)) return Interpolation::nearest;
  const bool is_bytes = std::holds_alternative<std::vector<std::uint8_t>>(channel.values);
  const bool is_normal = channel.name == channel_names::normal && channel.components == 3 && !is_bytes;
  return is_normal ? Interpolation::spherical : Interpolation::linear;
}

std::size_t elements_in(const Channel& channel) {
  const std::size_t count = std::visit([](const auto& values) { return values.size(); }, channel.values);
  return channel.components == 0 ? 0 : count / channel.components;
}

Channel checked(Channel channel) {
  Attributes alone;
  alone.channels.push_back(std::move(channel));
  check_alone(alone);
  return std::move(alone.channels.front());
}

}  // namespace

Channel channel_of(std::string name, nb::handle values, Element element, const InterpolationName& interpolation) {
  const std::string role = role_of(name);
  const nb::object array = array_from(values, role, "(n,) or (n, k)");
  const auto dimensions = nb::cast<std::size_t>(array.attr("ndim"));
  if (dimensions != 1 && dimensions != 2)
    throw_value_error(role + ": expected an array of shape (n,) or (n, k), found shape " +
                      text_of(array.attr("shape")));
  Channel channel{.name = std::move(name), .element = element, .values = values_of(array, role)};
  if (dimensions == 2) channel.components = nb::cast<std::uint32_t>(array.attr("shape")[1]);
  channel.interpolation = interpolation.object.is_none() ? usual_interpolation(channel) : interpolation.value();
  return channel;
}

nb::object array_of(const Channel& channel, nb::handle owner) {
  return std::visit(
      [&](const auto& values) {
        using T = typename std::decay_t<decltype(values)>::value_type;
        const std::array<std::size_t, 2> shape{elements_in(channel), channel.components};
        const std::size_t dimensions = channel.components == 1 ? 1 : 2;
        return nb::cast(nb::ndarray<nb::numpy, const T>(values.data(), dimensions, shape.data(), owner));
      },
      channel.values);
}

std::string describe_values(const Channel& channel) {
  constexpr std::array types{"float32", "float64", "uint8", "int32"};
  const std::string columns = channel.components == 1 ? "," : ", " + std::to_string(channel.components);
  return "(" + std::to_string(elements_in(channel)) + columns + ") " + types[channel.values.index()] + " per " +
         name_of(channel.element);
}

const Channel& channel_in(nb::handle object) {
  if (!nb::isinstance<Channel>(object)) throw_type_error("channels: expected Channel, found " + type_of(object));
  return nb::cast<const Channel&>(object);
}

void check_alone(const Attributes& attributes) {
  std::optional<std::size_t> vertices, faces;
  for (const Channel& channel : attributes.channels) {
    const std::size_t count = elements_in(channel);
    if (channel.element == Element::vertex)
      vertices = vertices.value_or(count);
    else
      faces = faces.value_or(channel.element == Element::face ? count : count / 3);
  }
  check_attributes(attributes, vertices.value_or(0), faces.value_or(0));
}

void bind_channel(nb::module_& m) {
  nb::class_<Channel>(m, "Channel", nb::is_weak_referenceable(),
                      R"(Named values on all vertices, corners or faces of a mesh. Immutable.

A corner is a vertex of one triangle: corner 3 t + k is the k-th of triangle t, so that neighbours may differ, as at the
seams of a texture.

Parameters
----------
name : str
    "normal", "texcoord", "color", "material", "object" and "group" are names that files know; others are free.
values : array_like, shape (n,) or (n, k), k from 1 to 4
    Copied: float32, float64, uint8, or integers that fit int32, which is what they become. float16 becomes float32.
element : {"vertex", "corner", "face"}
    What the values belong to, in the order of vertices or triangles.
interpolation : {"linear", "spherical", "nearest"}, optional
    How a value within a face follows from those at its corners: by barycentric coordinates; the same, scaled to length
    1, for directions; that of the nearest corner, for identifiers. Without: "nearest" for integers, "spherical" for
    three floats with the name "normal", else "linear".

Raises
------
TypeError, ValueError
    With the name of the channel: for other types and shapes, numbers beyond 32 bits, another element or interpolation
    than those above, integers that are not "nearest", bytes that are "spherical".

Examples
--------
>>> channel = Channel("temperature", [20.0, 25.0, 22.5])
>>> channel
Channel('temperature', (3,) float64 per vertex, linear)
>>> channel.values.tolist()
[20.0, 25.0, 22.5]
)")
      .def(
          "__init__",
          [](Channel* self, nb::object name, const ArrayLike& values, const ElementName& element,
             const InterpolationName& interpolation) {
            new (self)
                Channel(checked(channel_of(encoded(name, "name"), values.object, element.value(), interpolation)));
          },
          "name"_a, "values"_a, "element"_a = nb::str("vertex"), "interpolation"_a = nb::none(),
          nb::sig("def __init__(self, name: str, values: numpy.typing.ArrayLike, element: Element = 'vertex', "
                  "interpolation: Interpolation | None = None) -> None"))
      .def_prop_ro(
          "name", [](const Channel& c) { return decoded(c.name); }, nb::sig("def name(self) -> str"),
          "The name by which attributes find it.")
      .def_prop_ro(
          "values", [](const Channel& c) { return array_of(c, nb::find(c)); },
          nb::sig("def values(self) -> numpy.typing.NDArray[typing.Any]"),
          "Shape (n,) for one component, else (n, k). Read-only.")
      .def_prop_ro(
          "element", [](const Channel& c) { return name_of(c.element); }, nb::sig("def element(self) -> Element"),
          "What the values belong to.")
      .def_prop_ro(
          "interpolation", [](const Channel& c) { return name_of(c.interpolation); },
          nb::sig("def interpolation(self) -> Interpolation"), "How values between corners follow from theirs.")
      .def(
          "__eq__", [](const Channel& a, const Channel& b) { return a == b; }, nb::is_operator(),
          nb::sig("def __eq__(self, other: object, /) -> bool"))
      .def("__hash__", [](const Channel& c) { return nb::hash(decoded(c.name)); })
      .def("__repr__",
           [](const Channel& c) {
             return "Channel(" + nb::cast<std::string>(nb::repr(decoded(c.name))) + ", " + describe_values(c) + ", " +
                    name_of(c.interpolation) + ")";
           })
      .def(
          "__reduce__",
          [](const Channel& c) {
            const nb::object self = nb::find(c);
            return nb::make_tuple(self.type(), nb::make_tuple(decoded(c.name), array_of(c, self), name_of(c.element),
                                                              name_of(c.interpolation)));
          },
          nb::sig("def __reduce__(self) -> tuple[typing.Any, ...]"));
}

}  // namespace strata::python
