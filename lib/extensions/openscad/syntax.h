#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "extensions/openscad/report.h"

namespace strata::openscad {

/// The value of an argument. What a string says matters to nobody here.
struct Value {
  enum class Kind : std::uint8_t { undefined, boolean, number, string, vector };
  Kind kind = Kind::undefined;
  bool truth = false;
  double number = 0;  ///< may be infinite or not a number: `inf`, `nan`
  std::vector<Value> items;
};

struct Argument {
  std::string_view name;  ///< empty: told by its position
  Value value;
  Place place;
};

/// `%name(arguments) { children }`
struct SyntaxNode {
  std::string_view name;
  Place place;              ///< of the name
  bool background = false;  ///< %
  bool disabled = false;    ///< *
  bool root = false;        ///< !
  std::vector<Argument> arguments;
  std::size_t end = 0;  ///< number of the first node behind this one and all in it
};

/// All nodes of a text, parents before their children, in order: the children of node n are n + 1, the end of that one,
/// and so on up to the end of n. The text must outlive them.
/// Throws CsgError for everything that is not of that form, and for nodes or vectors in very many others: `deepest`.
/// No recursion but for vectors. O(size of the text).
[[nodiscard]] std::vector<SyntaxNode> parse(std::string_view text, const Report& report);

/// How deep nodes may be nested. Transforms within transforms are multiplied, so deeper ones are an attack.
inline constexpr std::size_t deepest = 10'000;

}  // namespace strata::openscad
