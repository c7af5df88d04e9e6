#pragma once
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/io/input.h"
#include "strata/attributes.h"

namespace strata::io {

enum class PlyScalar { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

[[nodiscard]] std::size_t size_of(PlyScalar type);
[[nodiscard]] inline bool is_integer(PlyScalar type) {
  return type != PlyScalar::float32 && type != PlyScalar::float64;
}
/// True when an integer type has the number.
[[nodiscard]] bool has_number(PlyScalar type, double number);
/// The number at `bytes`, converted to double without loss.
[[nodiscard]] double load_scalar(const char* bytes, PlyScalar type, std::endian order);

struct PlyProperty {
  std::string name;
  PlyScalar type = PlyScalar::float32;  ///< of the value, or of the items of a list
  std::optional<PlyScalar> list_count;  ///< type of the number of items; nothing: no list
};

/// A comment `channel COMPONENTS INTERPOLATION NAME`: the properties after it make this channel.
struct PlyAnnouncement {
  std::size_t property = 0;  ///< the first one after it
  std::uint32_t components = 1;
  Interpolation interpolation = Interpolation::linear;
  std::string name;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  std::vector<PlyAnnouncement> announcements;  ///< in order of properties

  [[nodiscard]] bool has_lists() const;
  [[nodiscard]] std::size_t least_size() const;  ///< bytes of a binary record whose lists are empty
  [[nodiscard]] std::optional<std::size_t> find(std::string_view property) const;
};

/// The header of a PLY file.
struct PlyHeader {
  std::optional<std::endian> order;  ///< of binary data; nothing: ASCII
  std::vector<PlyElement> elements;
  std::vector<std::string> textures;  ///< files of images: comments `TextureFile NAME`
  std::size_t data = 0;               ///< offset of the first byte after the header
};

/// Throws IoError with the line.
[[nodiscard]] PlyHeader read_ply_header(const Input& input);

}  // namespace strata::io
