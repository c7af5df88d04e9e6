#include <algorithm>

#include "strata/csg/expression.h"
#include "strata/csg/expression_grammar.h"
#include "strata/csg/expression_node.h"

namespace strata {
namespace {

using Node = Expression::Node;
using Kind = Node::Kind;

/// How strongly the outermost operator of a text binds.
enum class Binding : std::uint8_t { unite, exclude, intersect, subtract, complement, atom };

struct Text {
  std::string text;
  Binding binding = Binding::atom;
  bool is_complement = false;  ///< of `text`, whose binding it is
};

std::string enclosed(const Text& t, Binding least) {
  if (!t.is_complement) return t.binding >= least ? t.text : "(" + t.text + ")";
  const std::string text = std::string("~").append(enclosed({t.text, t.binding, false}, Binding::complement));
  return Binding::complement >= least ? text : "(" + text + ")";
}

std::string joined(const std::vector<Text>& terms, const char* between, Binding least) {
  std::string text;
  for (const Text& t : terms) {
    if (&t != terms.data()) text += between;
    text += enclosed(t, least);
  }
  return text;
}

Text text_of(Kind kind, const std::vector<Text>& terms) {
  if (terms.empty()) return {kind == Kind::all ? "everything" : "nothing", Binding::atom, false};
  if (terms.size() == 1) return terms.front();
  if (kind == Kind::any) return {joined(terms, " | ", Binding::exclude), Binding::unite, false};
  if (kind == Kind::odd) return {joined(terms, " ^ ", Binding::intersect), Binding::exclude, false};
  const bool subtracts = !terms.front().is_complement &&
                         std::all_of(terms.begin() + 1, terms.end(), [](const Text& t) { return t.is_complement; });
  if (!subtracts) return {joined(terms, " & ", Binding::subtract), Binding::intersect, false};
  std::string text = enclosed(terms.front(), Binding::subtract);
  for (auto t = terms.begin() + 1; t != terms.end(); ++t)
    text += " - " + enclosed({t->text, t->binding, false}, Binding::complement);
  return {text, Binding::subtract, false};
}

}  // namespace

ParseError::ParseError(const std::string& what, std::size_t position)
    : std::runtime_error("column " + std::to_string(position + 1) + ": " + what), position_(position) {}

Expression parse_expression(std::string_view text, const std::function<Solid(const std::string&)>& solid_of) {
  const auto leaf = [&solid_of](const std::string& name) { return Expression(solid_of(name), name); };
  return ExpressionGrammar<Expression, decltype(leaf)>(text, leaf).parse();
}

std::string Expression::text() const {
  const Text t = fold<Text>(
      *node_,
      [](const Occurrence& o) {
        return Text{o.leaf->name.empty() ? "?" : o.leaf->name, Binding::atom, false};
      },
      [](Text inner) {
        if (inner.is_complement) return Text{inner.text, inner.binding, false};
        inner.is_complement = true;
        return inner;
      },
      [](Kind kind, const std::vector<Text>& terms) { return text_of(kind, terms); });
  return enclosed(t, Binding::unite);
}

}  // namespace strata
