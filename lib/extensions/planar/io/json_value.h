#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "extensions/planar/io/scanner.h"

namespace strata::planar {

/// A JSON value, as far as GeoJSON needs it: numbers are their nearest doubles.
struct JsonValue {
  enum class Kind { null, truth, number, text, array, object };

  Kind kind = Kind::null;
  std::size_t offset = 0;  ///< in the file: of its last character, or of a bracket that opens it
  double number = 0;
  std::string text;
  std::vector<JsonValue> items;    ///< of an array or an object
  std::vector<std::string> names;  ///< of an object's items

  /// The first member of a name, or null.
  [[nodiscard]] const JsonValue* find(std::string_view name) const;
};

/// The value that a text is. Throws io::Malformed, also for values nested more than 512 deep.
[[nodiscard]] JsonValue read_json(std::string_view text);

}  // namespace strata::planar
