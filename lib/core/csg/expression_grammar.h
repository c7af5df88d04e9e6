#pragma once
#include <cctype>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#include "strata/expression.h"

namespace strata {

/// The grammar of `parse_expression`, for values of any type with the operators |, ^, &, - and ~. `leaf(name)` is the
/// value of a name; it may throw std::out_of_range. Throws ParseError.
template <class Value, class Leaf>
class ExpressionGrammar {
 public:
  /// Both must outlive this.
  ExpressionGrammar(std::string_view text, const Leaf& leaf) : text_(text), leaf_(leaf) {}

  Value parse() {
    Value e = unions();
    if (at_ < text_.size()) fail(text_[at_] == ')' ? "a parenthesis that was not opened" : "an operator is missing");
    return e;
  }

 private:
  static constexpr int deepest = 1000;

  Value unions() {
    Value e = exclusions();
    while (take('|')) e = e | exclusions();
    return e;
  }
  Value exclusions() {
    Value e = intersections();
    while (take('^')) e = e ^ intersections();
    return e;
  }
  Value intersections() {
    Value e = sums();
    while (take('&')) e = e & sums();
    return e;
  }
  Value sums() {
    Value e = complements();
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
  Value complements() {
    bool odd = false;
    while (take('~') || take('!')) odd = !odd;
    Value e = atom();
    return odd ? ~e : e;
  }
  Value atom() {
    skip_spaces();
    const std::size_t start = at_;
    if (take('(')) {
      if (++depth_ > deepest) fail("parentheses are nested too deeply");
      Value e = unions();
      if (!take(')')) at_ < text_.size() ? fail("an operator or ')' is missing") : fail_at(start, "is never closed");
      --depth_;
      return e;
    }
    while (at_ < text_.size() && is_name(text_[at_])) ++at_;
    if (at_ == start) fail("a name or '(' is missing");
    std::string name(text_.substr(start, at_ - start));
    Value e = named(name, start);
    skip_spaces();
    return e;
  }
  [[nodiscard]] Value named(const std::string& name, std::size_t start) const {
    try {
      return leaf_(name);
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
  const Leaf& leaf_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace strata
