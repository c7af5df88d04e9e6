// The .csg reader, with what it evaluates when reading; models that ask for much are passed over, since a short text
// may ask for millions of corners.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "extensions/openscad/model.h"
#include "extensions/openscad/node_kind.h"
#include "extensions/openscad/syntax.h"
#include "fuzz.h"
#include "strata/openscad.h"

namespace strata::fuzz {
namespace {

using openscad::SyntaxNode;
constexpr const char* file_name = "fuzz.csg";

bool is_costly(const openscad::Argument& a) {
  constexpr double most_sides = 48;
  const openscad::Value& v = a.value;
  if (a.name == "$fn") return v.number > most_sides;
  if (a.name == "$fa") return v.number < 360 / most_sides;
  if (a.name == "slices" || a.name == "segments" || a.name == "twist") return std::abs(v.number) > 8 * most_sides;
  return false;
}

/// Primitives of many corners, or very many of them, very deep transforms, or many operations: slow, as documented.
bool is_costly(const std::vector<SyntaxNode>& nodes) {
  constexpr std::ptrdiff_t most_round = 16, most_maps = 64, most_operations = 4;
  const auto is_round = [](const SyntaxNode& n) {
    return n.name == "sphere" || n.name == "cylinder" || n.name == "circle";
  };
  const auto is_map = [](const SyntaxNode& n) { return n.name == "multmatrix"; };
  const auto is_operation = [](const SyntaxNode& n) {
    const auto kind = openscad::kind_of(n.name);
    return kind >= openscad::NodeKind::hull && kind < openscad::NodeKind::unknown;
  };
  const auto asks_much = [](const SyntaxNode& n) {
    return std::any_of(n.arguments.begin(), n.arguments.end(), [](const auto& a) { return is_costly(a); });
  };
  return std::count_if(nodes.begin(), nodes.end(), is_round) > most_round ||
         std::count_if(nodes.begin(), nodes.end(), is_map) > most_maps ||
         std::count_if(nodes.begin(), nodes.end(), is_operation) > most_operations ||
         std::any_of(nodes.begin(), nodes.end(), asks_much);
}

void check(const CsgError& error, std::string_view text) {
  const auto lines =
      static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }));
  require(error.file() == file_name, "errors name the file");
  require(!error.reason().empty(), "errors have a reason");
  require(error.line() >= 1 && error.line() <= lines + 1, "errors have a line of the text");
  require(error.column() >= 1 && error.column() <= text.size() + 1, "errors have a column");
}

/// The nodes are well nested, or there are none.
std::optional<std::vector<SyntaxNode>> parse(std::string_view text) {
  try {
    const openscad::Report report(file_name);
    auto nodes = openscad::parse(text, report);
    for (std::size_t n = 0; n < nodes.size(); ++n)
      require(nodes[n].end > n && nodes[n].end <= nodes.size(), "nodes end behind their start");
    return nodes;
  } catch (const CsgError& error) {
    check(error, text);
    return std::nullopt;
  }
}

void check(std::string_view text) {
  const auto nodes = parse(text);
  if (!nodes || is_costly(*nodes)) return;
  try {
    const CsgModel model = read_csg(text, file_name);
    require(model.expression.size() <= nodes->size(), "solids are nodes");
    require(!model.expression.text().empty(), "models have a text");
    for (const auto& primitive : model.expression.primitives()) {
      require(!primitive.name.empty(), "primitives have names");
      require(primitive.solid.volume() > 0, "primitives are solids");
    }
  } catch (const CsgError& error) {
    check(error, text);
  }
}

}  // namespace
}  // namespace strata::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return strata::fuzz::run(data, size, [](std::string_view text) { strata::fuzz::check(text); });
}
