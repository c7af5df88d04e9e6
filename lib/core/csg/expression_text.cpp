#include <algorithm>
#include <utility>

#include "core/csg/expression_grammar.h"
#include "core/csg/expression_node.h"
#include "strata/expression.h"

namespace strata {
namespace {

using Node = Expression::Node;
using Kind = Node::Kind;

/// The precedence of the outermost operator of a text.
enum class Binding : std::uint8_t { union_, symmetric_difference, intersection, difference, complement, atom };

struct Text {
  std::string text;
  Binding binding = Binding::atom;
  bool is_complement = false;  ///< the complement of `text`, whose binding it is
};

std::string enclosed(Text t, Binding least) {
  if (t.is_complement) {
    t.text = "~" + enclosed({std::move(t.text), t.binding, false}, Binding::complement);
    t.binding = Binding::complement;
  }
  return t.binding >= least ? std::move(t.text) : "(" + t.text + ")";
}

/// The first term may be long, as in chains, so it is moved and not copied.
std::string joined(std::vector<Text> terms, const char* between, Binding first, Binding others) {
  std::string text = enclosed(std::move(terms.front()), first);
  for (auto t = terms.begin() + 1; t != terms.end(); ++t) text += between + enclosed(std::move(*t), others);
  return text;
}

bool are_complements(std::vector<Text>::const_iterator first, std::vector<Text>::const_iterator last) {
  return std::all_of(first, last, [](const Text& t) { return t.is_complement; });
}

/// A difference and names: a - b + c, which needs no parentheses.
bool goes_on(const std::vector<Text>& terms) {
  return terms.front().binding == Binding::difference && !terms.front().is_complement &&
         std::all_of(terms.begin() + 1, terms.end(), [](const Text& t) { return t.binding >= Binding::complement; });
}

Text text_of(Kind kind, std::vector<Text> terms) {
  if (terms.empty()) return {kind == Kind::all ? "everything" : "nothing", Binding::atom, false};
  if (terms.size() == 1) return std::move(terms.front());
  if (kind == Kind::any && goes_on(terms))
    return {joined(std::move(terms), " + ", Binding::difference, Binding::complement), Binding::difference, false};
  if (kind == Kind::any)
    return {joined(std::move(terms), " | ", Binding::symmetric_difference, Binding::symmetric_difference),
            Binding::union_, false};
  if (kind == Kind::odd)
    return {joined(std::move(terms), " ^ ", Binding::intersection, Binding::intersection),
            Binding::symmetric_difference, false};
  if (terms.front().is_complement || !are_complements(terms.begin() + 1, terms.end()))
    return {joined(std::move(terms), " & ", Binding::difference, Binding::difference), Binding::intersection, false};
  for (auto t = terms.begin() + 1; t != terms.end(); ++t) t->is_complement = false;
  return {joined(std::move(terms), " - ", Binding::difference, Binding::complement), Binding::difference, false};
}

}  // namespace

ParseError::ParseError(const std::string& what, std::size_t position)
    : std::runtime_error("column " + std::to_string(position + 1) + ": " + what), position_(position) {}

Expression parse_expression(std::string_view text, FunctionRef<Solid(const std::string&)> solid_of) {
  const auto leaf = [&solid_of](const std::string& name) { return Expression(solid_of(name), name); };
  return ExpressionGrammar<Expression, decltype(leaf)>(text, leaf).parse();
}

std::string Expression::text() const {
  Text t = fold<Text>(
      *node_,
      [](const Occurrence& o) {
        return Text{o.leaf->name.empty() ? "?" : o.leaf->name, Binding::atom, false};
      },
      [](Text inner) {
        inner.is_complement = !inner.is_complement;
        return inner;
      },
      [](Kind kind, std::vector<Text> terms) { return text_of(kind, std::move(terms)); });
  return enclosed(std::move(t), Binding::union_);
}

}  // namespace strata
