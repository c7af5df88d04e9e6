#include "face_colors.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
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

/// The place in 0 .. size - 1 of a coordinate of an image that repeats.
std::uint32_t texel(double x, std::uint32_t size) {
  const double within = x - std::floor(x);
  return std::isfinite(within) ? std::min(static_cast<std::uint32_t>(within * size), size - 1) : 0;
}

}  // namespace

FaceColors::FaceColors(const strata::Solid& solid) : solid_(solid) {
  const strata::Attributes& attributes = solid.attributes();
  const Channel* const color = attributes.find(strata::channel_names::color);
  if (color != nullptr && color->components >= 3) color_ = color;
  const Channel* const material = attributes.find(strata::channel_names::material);
  if (material != nullptr && material->element == Element::face && material->components == 1)
    material_ = std::get_if<std::vector<std::int32_t>>(&material->values);
  const Channel* const texcoord = attributes.find(strata::channel_names::texcoord);
  if (texcoord == nullptr || texcoord->components < 2 || texcoord->element == Element::face || material_ == nullptr)
    return;
  texcoord_ = texcoord;
  images_.resize(attributes.images.size());
  for (std::size_t i = 0; i < images_.size(); ++i) {
    const auto has_it = [&](const strata::Material& m) { return m.image == i; };
    if (std::none_of(attributes.materials.begin(), attributes.materials.end(), has_it)) continue;
    try {
      images_[i] = pixels_of(attributes.images[i]);
    } catch (const std::runtime_error& error) {
      notes_.emplace_back(error.what());
    }
  }
}

std::size_t FaceColors::element(const Channel& channel, std::uint32_t face, std::size_t corner) const {
  switch (channel.element) {
    case Element::face:
      return face;
    case Element::corner:
      return 3 * std::size_t{face} + corner;
    case Element::vertex:
      break;
  }
  return solid_.mesh().triangles[face][corner];
}

ScreenColor FaceColors::painted(std::uint32_t face) const {
  ScreenColor sum{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i) sum[i] += value_of(*color_, element(*color_, face, k), i) / 3;
  return sum;
}

const strata::Material* FaceColors::material_of(std::uint32_t face) const {
  const std::vector<strata::Material>& materials = solid_.attributes().materials;
  if (material_ == nullptr || (*material_)[face] < 0) return nullptr;
  const auto number = static_cast<std::size_t>((*material_)[face]);
  return number < materials.size() ? &materials[number] : nullptr;
}

const ImagePixels* FaceColors::image_of(std::uint32_t face) const {
  const strata::Material* const material = material_of(face);
  if (texcoord_ == nullptr || material == nullptr || !material->image) return nullptr;
  const std::optional<ImagePixels>& image = images_[*material->image];
  return image ? &*image : nullptr;
}

std::optional<ScreenColor> FaceColors::of(std::uint32_t face) const {
  const strata::Material* const material = material_of(face);
  if (color_ == nullptr && material == nullptr) return std::nullopt;
  ScreenColor color{1, 1, 1};
  if (color_ != nullptr) color = painted(face);
  if (material != nullptr)
    for (std::size_t i = 0; i < 3; ++i) color[i] *= strata::srgb_of_light(material->color[i]);
  return color;
}

ScreenColor FaceColors::at(std::uint32_t face, const Weights& place) const {
  const ImagePixels& image = *image_of(face);
  std::array<double, 2> uv{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 2; ++i)
      uv[i] +=
          place[k] * std::visit(
                         [&](const auto& values) {
                           return static_cast<double>(values[element(*texcoord_, face, k) * texcoord_->components + i]);
                         },
                         texcoord_->values);
  const std::size_t row = image.height - 1 - texel(uv[1], image.height), column = texel(uv[0], image.width);
  ScreenColor color = of(face).value();
  for (std::size_t i = 0; i < 3; ++i) color[i] *= image.rgb[3 * (row * image.width + column) + i] / 255.0;
  return color;
}
