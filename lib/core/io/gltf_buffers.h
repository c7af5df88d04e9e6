#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/file.h"
#include "core/io/gltf_json.h"

namespace strata::io {

/// Numbers of an accessor: one after the other, `components` for each element.
struct GltfNumbers {
  enum class Kind { floats, bytes, scaled, integers };
  Kind kind = Kind::floats;  ///< scaled: integers that were divided by `divisor`, as doubles
  std::size_t count = 0, components = 0;
  std::vector<double> values;
  double divisor = 1;  ///< of normalized integers: 127, 255, 32767 or 65535; values are before the division
};

/// The bytes that a glTF document refers to: buffers, views and accessors of them, images. Buffers are read when they
/// are used, from base64, from the chunk of a GLB file, or from files beneath the folder. All ranges are checked. What
/// accessors hold is decoded once, and all of it is no more than 8 million numbers and twice the bytes there are.
class GltfBuffers {
 public:
  GltfBuffers(const GltfValue& document, std::string_view chunk, const std::filesystem::path* folder);

  [[nodiscard]] const GltfNumbers& accessor(std::size_t index);
  /// Whole numbers from 0 on, of an accessor without sparse values, below `limit`.
  [[nodiscard]] std::vector<std::uint32_t> indices(std::size_t accessor, std::size_t limit);
  /// The bytes of a view, without stride.
  [[nodiscard]] std::string_view view(std::size_t index);
  /// What a URI refers to; none if it is no data and no file beneath the folder.
  [[nodiscard]] std::optional<std::string> resource(const std::string& uri);
  /// Takes numbers from what may be used. Throws Malformed when nothing is left.
  void use(std::uint64_t numbers);

 private:
  struct Layout;
  [[nodiscard]] std::string_view buffer(std::size_t index);
  [[nodiscard]] Layout layout(const GltfValue& accessor, std::size_t view, std::size_t offset, std::size_t count,
                              std::size_t type, std::size_t components);
  void read_plain(const GltfValue& accessor, GltfNumbers& numbers, std::size_t type);
  void read_sparse(const GltfValue& accessor, GltfNumbers& numbers, std::size_t type);

  GltfValue document_;
  std::string_view chunk_;
  const std::filesystem::path* folder_;
  std::map<std::size_t, std::string> buffers_;
  std::map<std::size_t, GltfNumbers> accessors_;
  std::uint64_t left_;
};

}  // namespace strata::io
