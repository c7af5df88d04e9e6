#include "face_colors.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>

#include "strata/srgb.h"

namespace {

using strata::Channel;
using strata::Element;

double value_of(const Channel& c, std::size_t element, std::size_t component) {
  const auto value = [&]<class T>(const std::vector<T>& values) {
    const auto x = static_cast<double>(values[element * c.components + component]);
    return std::is_same_v<T, std::uint8_t> ? x / 255 : std::isfinite(x) ? std::clamp(x, 0.0, 1.0) : 0;
  };
  return std::visit(value, c.values);
}

}  // namespace

FaceColors::FaceColors(const strata::Solid& solid) : solid_(solid) {
  const strata::Attributes& attributes = solid.attributes();
  const Channel* const color = attributes.find(strata::channel_names::color);
  if (color != nullptr && color->components >= 3) color_ = color;
  const Channel* const material = attributes.find(strata::channel_names::material);
  if (material != nullptr && material->element == Element::face && material->components == 1)
    material_ = std::get_if<std::vector<std::int32_t>>(&material->values);
}

ScreenColor FaceColors::painted(std::uint32_t face) const {
  ScreenColor sum{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t element = color_->element == Element::face     ? face
                                : color_->element == Element::corner ? 3 * std::size_t{face} + k
                                                                     : solid_.mesh().triangles[face][k];
    for (std::size_t i = 0; i < 3; ++i) sum[i] += value_of(*color_, element, i) / 3;
  }
  return sum;
}

std::optional<ScreenColor> FaceColors::of(std::uint32_t face) const {
  const std::vector<strata::Material>& materials = solid_.attributes().materials;
  const auto number = material_ == nullptr ? std::size_t{0} : static_cast<std::size_t>((*material_)[face]);
  const bool has_material = material_ != nullptr && (*material_)[face] >= 0 && number < materials.size();
  if (color_ == nullptr && !has_material) return std::nullopt;
  ScreenColor color{1, 1, 1};
  if (color_ != nullptr) color = painted(face);
  if (has_material)
    for (std::size_t i = 0; i < 3; ++i) color[i] *= strata::srgb_of_light(materials[number].color[i]);
  return color;
}
