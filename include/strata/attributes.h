#pragma once
/// Data that a mesh carries beside its shape: named channels of numbers on vertices, corners and faces, and the
/// materials, images and objects that some of them refer to.
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace strata {

/// What the values of a channel belong to. A corner is a vertex of one triangle: corner 3 t + k is the k-th of triangle
/// t, so that neighbours may differ (seams of textures, creases of normals).
enum class Element { vertex, corner, face };

/// How a value within a face follows from those at its corners. For channels on faces it makes no difference.
enum class Interpolation {
  linear,     ///< by barycentric coordinates
  spherical,  ///< directions: linear, then scaled to length 1
  nearest,    ///< identifiers: that of the nearest corner, the first of several
};

/// Values of a channel, `components` of them per element, in the order of elements.
using ChannelValues =
    std::variant<std::vector<float>, std::vector<double>, std::vector<std::uint8_t>, std::vector<std::int32_t>>;

/// Named values on all elements of one kind. Required where a channel is used: 1 to 4 components, and as many values as
/// elements times components; `nearest` unless values are floating-point or bytes.
struct Channel {
  std::string name;
  Element element = Element::vertex;
  Interpolation interpolation = Interpolation::linear;
  std::uint32_t components = 1;
  ChannelValues values;

  friend bool operator==(const Channel&, const Channel&) = default;
};

/// Names of channels that files know. Other names are free.
namespace channel_names {
inline constexpr std::string_view normal = "normal";      ///< 3 components, spherical
inline constexpr std::string_view texcoord = "texcoord";  ///< 2 components, from the lower left; "texcoord1" and so on
inline constexpr std::string_view color = "color";        ///< 3 or 4 components: bytes, or floats from 0 to 1
inline constexpr std::string_view material = "material";  ///< on faces: an index into materials, -1 for none
inline constexpr std::string_view object = "object";      ///< on faces: an index into objects, -1 for none
inline constexpr std::string_view group = "group";        ///< on faces: a number, or an index into groups
}  // namespace channel_names

/// An encoded picture as files hold it; nothing looks into it.
struct Image {
  std::string name;        ///< a file name without folders
  std::string media_type;  ///< "image/png", "image/jpeg", ...
  std::vector<std::byte> bytes;

  friend bool operator==(const Image&, const Image&) = default;
};

/// How a surface looks, as far as glTF's metallic-roughness model, OBJ's materials and 3MF's base materials agree.
struct Material {
  std::string name;
  std::array<double, 4> color = {1, 1, 1, 1};  ///< red, green, blue (linear), opacity
  double metallic = 0;
  double roughness = 1;
  std::optional<std::uint32_t> image;  ///< index into images: multiplies `color`, at the channel "texcoord"

  friend bool operator==(const Material&, const Material&) = default;
};

/// All that a mesh carries. Indices of the channels "material", "object" and "group" refer to these lists.
struct Attributes {
  std::vector<Channel> channels;
  std::vector<Material> materials;
  std::vector<Image> images;
  std::vector<std::string> objects;
  std::vector<std::string> groups;

  [[nodiscard]] bool empty() const;
  [[nodiscard]] const Channel* find(std::string_view name) const;  ///< the first of that name, or null

  friend bool operator==(const Attributes&, const Attributes&) = default;
};

}  // namespace strata
