#include <algorithm>
#include <cctype>
#include <optional>

#include "strata/csg/expression.h"
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

class Parser {
 public:
  Parser(std::string_view text, const std::function<Solid(const std::string&)>& solid_of)
      : text_(text), solid_of_(solid_of) {}

  Expression parse() {
    Expression e = unions();
    if (at_ < text_.size()) fail(text_[at_] == ')' ? "a parenthesis that was not opened" : "an operator is missing");
    return e;
  }

 private:
  static constexpr int deepest = 1000;

  Expression unions() {
    Expression e = exclusions();
    while (take('|')) e = e | exclusions();
    return e;
  }
  Expression exclusions() {
    Expression e = intersections();
    while (take('^')) e = e ^ intersections();
    return e;
  }
  Expression intersections() {
    Expression e = sums();
    while (take('&')) e = e & sums();
    return e;
  }
  Expression sums() {
    Expression e = complements();
    while (true) {
      if (take('-')) {
        e = e - complements();
      } else if (take('+')) {
        e = e | complements();
      } else {
        return e;
      }
    }
  }
  Expression complements() {
    bool odd = false;
    while (take('~') || take('!')) odd = !odd;
    Expression e = atom();
    return odd ? ~e : e;
  }
  Expression atom() {
    skip_spaces();
    const std::size_t start = at_;
    if (take('(')) {
      if (++depth_ > deepest) fail("parentheses are nested too deeply");
      Expression e = unions();
      if (!take(')')) at_ < text_.size() ? fail("an operator or ')' is missing") : fail_at(start, "is never closed");
      --depth_;
      return e;
    }
    while (at_ < text_.size() && is_name(text_[at_])) ++at_;
    if (at_ == start) fail("a name or '(' is missing");
    std::string name(text_.substr(start, at_ - start));
    Expression e = named(name, start);
    skip_spaces();
    return e;
  }
  [[nodiscard]] Expression named(const std::string& name, std::size_t start) const {
    try {
      return {solid_of_(name), name};
    } catch (const std::out_of_range&) {
      fail_at(start, "no solid is called '" + name + "'");
    }
  }
  static bool is_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' ||
           static_cast<unsigned char>(c) >= 0x80;
  }
  void skip_spaces() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  bool take(char c) {
    skip_spaces();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    skip_spaces();
    return true;
  }
  [[noreturn]] void fail(const std::string& what) const { fail_at(at_, what); }
  [[noreturn]] static void fail_at(std::size_t position, const std::string& what) { throw ParseError(what, position); }

  std::string_view text_;
  const std::function<Solid(const std::string&)>& solid_of_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

ParseError::ParseError(const std::string& what, std::size_t position)
    : std::runtime_error("column " + std::to_string(position + 1) + ": " + what), position_(position) {}

Expression parse_expression(std::string_view text, const std::function<Solid(const std::string&)>& solid_of) {
  return Parser(text, solid_of).parse();
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
