#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "strata/attributes.h"
#include "strata/solid.h"

/// Red, green and blue from 0 to 1, as screens show them.
using ScreenColor = std::array<double, 3>;

/// The colors of a solid's faces in pictures that have one for each: the average of the channel "color" at its corners,
/// times the color of its material. Images are not looked at. The solid must outlive it.
class FaceColors {
 public:
  explicit FaceColors(const strata::Solid& solid);

  /// None for a face that has neither.
  [[nodiscard]] std::optional<ScreenColor> of(std::uint32_t face) const;

 private:
  [[nodiscard]] ScreenColor painted(std::uint32_t face) const;

  const strata::Solid& solid_;
  const strata::Channel* color_ = nullptr;
  const std::vector<std::int32_t>* material_ = nullptr;
};
