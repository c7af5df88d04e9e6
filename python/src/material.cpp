#include "material.h"

#include <nanobind/stl/optional.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "text.h"

namespace strata::python {

namespace {

nb::object record(const char* type) { return nb::module_::import_("strata_csg._attributes").attr(type); }

void require_record(nb::handle object, const char* type, const char* role) {
  if (!nb::isinstance(object, record(type)))
    throw_type_error(std::string(role) + ": expected " + type + ", found " + type_of(object));
}

}  // namespace

Material material_of(nb::handle object, const char* role) {
  require_record(object, "Material", role);
  Material material{.name = encoded(object.attr("name"), "material: name"),
                    .metallic = nb::cast<double>(object.attr("metallic")),
                    .roughness = nb::cast<double>(object.attr("roughness")),
                    .image = nb::cast<std::optional<std::uint32_t>>(object.attr("image"))};
  const nb::object color = object.attr("color");
  for (std::size_t i = 0; i < material.color.size(); ++i) material.color[i] = nb::cast<double>(color[i]);
  return material;
}

nb::object to_python(const Material& m) {
  const nb::tuple color = nb::make_tuple(m.color[0], m.color[1], m.color[2], m.color[3]);
  return record("Material")(decoded(m.name), color, m.metallic, m.roughness, m.image);
}

Image image_of(nb::handle object) {
  require_record(object, "Image", "images");
  const auto data = nb::borrow<nb::bytes>(object.attr("data"));
  const auto* const first = static_cast<const std::byte*>(data.data());
  return {encoded(object.attr("name"), "image: name"),
          encoded(object.attr("media_type"), "image: media_type"),
          {first, first + data.size()}};
}

nb::object to_python(const Image& image) {
  const nb::bytes data(image.bytes.data(), image.bytes.size());
  return record("Image")(decoded(image.name), decoded(image.media_type), data);
}

}  // namespace strata::python
