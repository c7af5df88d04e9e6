#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "extensions/openscad/report.h"

namespace strata::openscad {

/// The value of an argument.
struct Value {
  enum class Kind : std::uint8_t { undefined, boolean, number, string, vector };
  Kind kind = Kind::undefined;
  bool truth = false;
  double number = 0;      ///< may be infinite or not a number: `inf`, `nan`
  std::string_view text;  ///< of a string, with its quotes, as in the file
  std::vector<Value> items;
};

/// What a string stands for: without quotes, with \n, \t, \r, \\, \", \xHH and \uHHHH replaced (in UTF-8).
[[nodiscard]] std::string text_of(const Value& string);

struct Argument {
  std::string_view name;  ///< empty: given by position
  Value value;
  Place place;
};

/// `%name(arguments) { children }`
struct SyntaxNode {
  std::string_view name;
  Place place;              ///< of the name
  std::string_view text;    ///< from the name to the end of the arguments, as in the file
  bool background = false;  ///< %
  bool disabled = false;    ///< *
  bool root = false;        ///< !
  std::vector<Argument> arguments;
  std::size_t end = 0;  ///< number of the first node after this one and its descendants
};

/// All nodes of a text, parents before their children, in order: the children of node n are n + 1, the end of that one,
/// and so on up to the end of n. The text must outlive them. Throws CsgError for everything that is not of that form,
/// for nodes nested deeper than `deepest`, and for vectors nested very deeply. Recursion for vectors only. O(size of
/// the text).
[[nodiscard]] std::vector<SyntaxNode> parse(std::string_view text, const Report& report);

/// The largest depth of nested nodes. OpenSCAD multiplies nested transforms, so its files are not this deep.
inline constexpr std::size_t deepest = 10'000;

}  // namespace strata::openscad
