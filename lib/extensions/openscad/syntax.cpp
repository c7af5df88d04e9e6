#include "extensions/openscad/syntax.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "extensions/openscad/lexer.h"

namespace strata::openscad {
namespace {

class Parser {
 public:
  Parser(std::string_view text, const Report& report) : lexer_(text, report), report_(report) {}

  std::vector<SyntaxNode> parse() {
    while (lexer_.next().kind != Token::Kind::end) {
      if (lexer_.next().is('}')) {
        close_braces();
      } else if (!lexer_.take(';')) {
        begin_node();
      }
    }
    if (!open_.empty()) report_.fail(open_.back().place, "a '{' is never closed");
    return std::move(nodes_);
  }

 private:
  /// A node whose children are being read.
  struct Open {
    std::size_t node;
    Place place;  ///< of its brace
    bool has_braces;
  };

  void begin_node() {
    SyntaxNode node;
    read_modifiers(node);
    if (lexer_.next().kind != Token::Kind::name) lexer_.fail_expected("a node such as 'union()'");
    const Token name = lexer_.take();
    node.name = name.text;
    node.place = name.place;
    read_arguments(node);
    const std::size_t number = nodes_.size();
    nodes_.push_back(std::move(node));
    if (lexer_.take(';')) return end_node(number);
    if (open_.size() == deepest)
      report_.fail(name.place, "nodes are nested more than " + std::to_string(deepest) + " deep");
    const Place place = lexer_.next().place;
    const bool has_braces = lexer_.take('{');
    if (!has_braces && !starts_node(lexer_.next())) lexer_.fail_expected("';' or '{'");
    open_.push_back({number, place, has_braces});
  }
  static bool starts_node(const Token& t) {
    return t.kind == Token::Kind::name || t.is('!') || t.is('#') || t.is('%') || t.is('*');
  }
  void read_modifiers(SyntaxNode& node) {
    while (true) {
      if (lexer_.take('%')) {
        node.background = true;
      } else if (lexer_.take('*')) {
        node.disabled = true;
      } else if (lexer_.take('!')) {
        node.root = true;
      } else if (!lexer_.take('#')) {  // affects the preview only
        return;
      }
    }
  }
  void close_braces() {
    if (open_.empty()) report_.fail(lexer_.next().place, "a '}' without a '{'");
    const std::size_t number = open_.back().node;
    lexer_.expect('}');
    open_.pop_back();
    end_node(number);
  }
  /// Ends a node, and the nodes that have it as their only child without braces.
  void end_node(std::size_t number) {
    nodes_[number].end = nodes_.size();
    for (; !open_.empty() && !open_.back().has_braces; open_.pop_back()) nodes_[open_.back().node].end = nodes_.size();
  }

  void read_arguments(SyntaxNode& node) {
    lexer_.expect('(');
    std::string_view last = lexer_.next().text;
    while (!lexer_.take(')')) {
      node.arguments.push_back(argument());
      if (!lexer_.take(',') && !lexer_.next().is(')')) lexer_.fail_expected("',' or ')'");
      last = lexer_.next().text;
    }
    node.text = {node.name.data(), static_cast<std::size_t>(last.data() + last.size() - node.name.data())};
  }
  Argument argument() {
    Argument a;
    a.place = lexer_.next().place;
    if (lexer_.next().kind == Token::Kind::name) {
      const Token name = lexer_.take();
      if (!lexer_.take('=')) {
        a.value = named_value(name);
        return a;
      }
      a.name = name.text;
    }
    a.value = value(0);
    return a;
  }
  Value value(int depth) {
    constexpr int deepest_vector = 16;
    if (depth > deepest_vector) report_.fail(lexer_.next().place, "vectors are nested too deeply");
    double sign = 1;
    bool is_signed = false;
    for (; lexer_.next().is('-') || lexer_.next().is('+'); is_signed = true)
      if (lexer_.take().is('-')) sign = -sign;
    Value v = unsigned_value(depth);
    if (is_signed && v.kind != Value::Kind::number) report_.fail(lexer_.next().place, "a sign without a number");
    v.number *= sign;
    return v;
  }
  Value unsigned_value(int depth) {
    const Token& next = lexer_.next();
    if (next.kind == Token::Kind::name) return named_value(lexer_.take());
    if (next.kind == Token::Kind::number) return {Value::Kind::number, false, lexer_.take().number, {}, {}};
    if (next.kind == Token::Kind::string) return {Value::Kind::string, false, 0, lexer_.take().text, {}};
    if (!lexer_.take('[')) lexer_.fail_expected("a number, a vector, a string, true, false or undef");
    Value vector{Value::Kind::vector, false, 0, {}, {}};
    while (!lexer_.take(']')) {
      vector.items.push_back(value(depth + 1));
      if (!lexer_.take(',') && !lexer_.next().is(']')) lexer_.fail_expected("',' or ']'");
    }
    return vector;
  }
  [[nodiscard]] Value named_value(const Token& name) const {
    if (name.text == "true" || name.text == "false") return {Value::Kind::boolean, name.text == "true", 0, {}, {}};
    if (name.text == "undef") return {};
    if (name.text == "inf") return {Value::Kind::number, false, std::numeric_limits<double>::infinity(), {}, {}};
    if (name.text == "nan") return {Value::Kind::number, false, std::numeric_limits<double>::quiet_NaN(), {}, {}};
    report_.fail(name.place, std::string("'").append(name.text).append("' is no value: .csg files have no variables"));
  }

  Lexer lexer_;
  const Report& report_;
  std::vector<SyntaxNode> nodes_;
  std::vector<Open> open_;
};

/// The value of hexadecimal digits at a place; none where there are fewer.
std::optional<std::uint32_t> hexadecimal(std::string_view digits) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

void append_utf8(std::string& text, std::uint32_t code) {
  const auto byte = [&](std::uint32_t bits) { text.push_back(static_cast<char>(bits)); };
  if (code < 0x80) return byte(code);
  if (code < 0x800) {
    byte(0xc0 | code >> 6);
  } else {
    byte(0xe0 | code >> 12);
    byte(0x80 | (code >> 6 & 0x3f));
  }
  byte(0x80 | (code & 0x3f));
}

}  // namespace

std::string text_of(const Value& string) {
  const std::string_view raw = string.text.substr(1, string.text.size() - 2);
  std::string text;
  for (std::size_t i = 0; i < raw.size(); ++i) {
    if (raw[i] != '\\' || i + 1 == raw.size()) {
      text.push_back(raw[i]);
      continue;
    }
    const char c = raw[++i];
    const std::size_t digits = c == 'x' ? 2 : c == 'u' ? 4 : 0;
    if (const auto code = hexadecimal(raw.substr(std::min(i + 1, raw.size()), digits));
        digits > 0 && code && i + digits < raw.size()) {
      append_utf8(text, *code);
      i += digits;
    } else {
      text.push_back(c == 'n' ? '\n' : c == 't' ? '\t' : c == 'r' ? '\r' : c);
    }
  }
  return text;
}

std::vector<SyntaxNode> parse(std::string_view text, const Report& report) { return Parser(text, report).parse(); }

}  // namespace strata::openscad
