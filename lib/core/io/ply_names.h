#pragma once
#include <array>
#include <span>
#include <string_view>
#include <utility>

#include "strata/attributes.h"

namespace strata::io {

/// The properties that make a channel in the PLY files of many programs, in the order of its components.
struct PlyKnownNames {
  std::string_view channel;
  Interpolation interpolation;
  std::size_t least;                           ///< components without the opacity
  std::array<std::string_view, 4> properties;  ///< as many as components, at most

  [[nodiscard]] std::span<const std::string_view> names(std::size_t components) const {
    return std::span(properties).first(components);
  }
};

/// The first of a channel is the one that is written.
inline constexpr std::array<PlyKnownNames, 7> ply_known_names{
    {{channel_names::normal, Interpolation::spherical, 3, {"nx", "ny", "nz"}},
     {channel_names::texcoord, Interpolation::linear, 2, {"s", "t"}},
     {channel_names::texcoord, Interpolation::linear, 2, {"u", "v"}},
     {channel_names::texcoord, Interpolation::linear, 2, {"texture_u", "texture_v"}},
     {channel_names::color, Interpolation::linear, 3, {"red", "green", "blue", "alpha"}},
     {channel_names::color, Interpolation::linear, 3, {"r", "g", "b", "a"}},
     {channel_names::color,
      Interpolation::linear,
      3,
      {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"}}}};

/// The list on faces with two numbers for each corner.
inline constexpr std::string_view ply_texcoord_list = "texcoord";

/// What comes before the name of a channel, where a channel of the other element has the name: colours of vertices and
/// of faces are "color" and "face_color".
[[nodiscard]] constexpr std::string_view ply_prefix(Element element) {
  return element == Element::vertex ? "vertex_" : "face_";
}

/// The words for interpolations in comments that announce channels.
inline constexpr std::array<std::pair<std::string_view, Interpolation>, 3> ply_interpolations{
    {{"linear", Interpolation::linear}, {"spherical", Interpolation::spherical}, {"nearest", Interpolation::nearest}}};

}  // namespace strata::io
