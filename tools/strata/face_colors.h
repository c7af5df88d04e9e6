#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "image_pixels.h"
#include "strata/attributes.h"
#include "strata/solid.h"

/// Red, green and blue from 0 to 1, as screens show them.
using ScreenColor = std::array<double, 3>;

/// The colors of a solid's faces in pictures: the average of the channel "color" at the corners of a face, times the
/// color of its material, times what the material's image has at a place. The solid must outlive it.
class FaceColors {
 public:
  /// Weights of the three corners of a face, which add up to 1.
  using Weights = std::array<double, 3>;

  /// Decodes the images of all materials.
  explicit FaceColors(const strata::Solid& solid);

  /// None for a face that has neither color nor material. The image is not looked at.
  [[nodiscard]] std::optional<ScreenColor> of(std::uint32_t face) const;
  /// True for a face with an image and places in it: it has a color at each place.
  [[nodiscard]] bool has_image(std::uint32_t face) const { return image_of(face) != nullptr; }
  /// The color at a place, of a face with an image. Images repeat.
  [[nodiscard]] ScreenColor at(std::uint32_t face, const Weights& place) const;

  /// Images that cannot be shown, with reasons; faces have the colors of their materials then.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

 private:
  [[nodiscard]] const strata::Material* material_of(std::uint32_t face) const;
  [[nodiscard]] const ImagePixels* image_of(std::uint32_t face) const;
  [[nodiscard]] ScreenColor painted(std::uint32_t face) const;
  [[nodiscard]] std::size_t element(const strata::Channel& channel, std::uint32_t face, std::size_t corner) const;

  const strata::Solid& solid_;
  const strata::Channel* color_ = nullptr;
  const strata::Channel* texcoord_ = nullptr;
  const std::vector<std::int32_t>* material_ = nullptr;
  std::vector<std::optional<ImagePixels>> images_;  ///< as far as materials of faces have them
  std::vector<std::string> notes_;
};
