#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/affine_map.h"
#include "core/io/scene_mesh.h"
#include "strata/unit.h"

namespace strata::io {

/// Surfaces that triangles of a 3MF file refer to by the number of a group and a number in it.
struct ThreemfGroup {
  enum class Kind { base, color, texture, multi, unknown };
  struct Base {
    std::string name;
    std::array<std::uint8_t, 4> color;
  };

  Kind kind = Kind::unknown;
  std::vector<Base> bases;
  std::vector<std::array<std::uint8_t, 4>> colors;
  std::vector<std::array<double, 2>> texcoords;
  std::uint32_t texture = 0;                    ///< number of the texture, of kind texture
  std::vector<std::uint32_t> layers;            ///< numbers of groups, of kind multi
  std::vector<std::uint32_t> multi;             ///< a number in each layer, one entry after the other
  std::optional<std::uint32_t> first_material;  ///< in the attributes, once it is used
};

struct ThreemfTexture {
  std::string path, media_type;
  std::optional<std::uint32_t> image;  ///< in the attributes, once it is used
};

/// What triangle `triangle` refers to, if it does.
struct ThreemfSurface {
  std::uint32_t group = 0;
  std::array<std::uint32_t, 3> corners{};
};

struct ThreemfComponent {
  std::string path;  ///< of another part; empty: this one
  std::uint32_t object = 0;
  ExactMap map;
};

struct ThreemfObject {
  std::string name;
  bool is_model = true;  ///< neither support nor other
  ScenePart part;
  std::vector<ThreemfSurface> surfaces;  ///< empty, or one per triangle; group 0: none
  std::vector<ThreemfComponent> components;
  bool is_component = false;
  bool is_entered = false;  ///< while it is placed: for cycles
};

/// One part of a 3MF file, as it stands there.
struct ThreemfModel {
  Unit unit = Unit::millimeter;
  std::map<std::uint32_t, ThreemfObject> objects;
  std::map<std::uint32_t, ThreemfGroup> groups;
  std::map<std::uint32_t, ThreemfTexture> textures;
  std::vector<ThreemfComponent> items;  ///< of the build
  std::uint64_t things = 0;             ///< vertices, triangles, components and objects
};

/// Parses a part. Throws Malformed with the offset in the text.
[[nodiscard]] ThreemfModel parse_3mf_model(std::string_view text);

}  // namespace strata::io
