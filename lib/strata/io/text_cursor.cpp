#include "strata/io/text_cursor.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace strata::io {
namespace {

bool is_white(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// True when a decimal number other than zero that is no double is too small for one, not too large:
/// its first digit, moved by the exponent, stands behind the point.
bool is_tiny(const char* first, const char* last) {
  const char* mark = std::find_if(first, last, [](char c) { return c == 'e' || c == 'E'; });
  std::int64_t exponent = 0;
  if (mark != last) {
    const char* digits = mark + 1 + (mark[1] == '+');
    // An exponent that does not fit outweighs the digits of any file.
    constexpr std::int64_t huge = std::int64_t{1} << 60;
    if (std::from_chars(digits, last, exponent).ec != std::errc{}) exponent = *digits == '-' ? -huge : huge;
    exponent = std::clamp(exponent, -huge, huge);
  }
  const char* point = std::find(first, mark, '.');
  const char* digit = std::find_if(first, mark, [](char c) { return c >= '1' && c <= '9'; });
  return exponent + (point - digit) < 0;
}

}  // namespace

TextCursor::TextCursor(const Input& input, Syntax syntax, std::size_t offset)
    : input_(&input), syntax_(syntax), at_(input.data.data() + offset), end_(input.data.data() + input.data.size()) {
  if (offset == 0 && input.data.starts_with("\xEF\xBB\xBF")) at_ += 3;
}

bool TextCursor::skip_continuation() {
  if (!syntax_.continuation) return false;
  const char* next = at_ + 1;
  if (next != end_ && *next == '\r') ++next;
  if (next != end_ && *next == '\n') ++next;
  if (next == at_ + 1) return false;
  at_ = next;
  return true;
}

void TextCursor::skip_line() {
  const bool comment = syntax_.hash_comments && at_ != end_ && *at_ == '#';
  while (true) {
    while (at_ != end_ && *at_ != '\n' && *at_ != '\r') ++at_;
    if (at_ == end_) return;
    const bool joined = syntax_.continuation && !comment && at_ != input_->data.data() && at_[-1] == '\\';
    if (*at_++ == '\r' && at_ != end_ && *at_ == '\n') ++at_;
    if (!joined) return;
  }
}

std::string_view TextCursor::word() {
  if (at_line_end()) return {};
  const char* first = at_;
  while (at_ != end_ && !is_white(*at_)) ++at_;
  return {first, static_cast<std::size_t>(at_ - first)};
}

bool TextCursor::accept(std::string_view expected) {
  const char* before = at_;
  const std::string_view found = word();
  const bool same = std::equal(found.begin(), found.end(), expected.begin(), expected.end(),
                               [](char a, char b) { return lower(a) == lower(b); });
  if (!same) at_ = before;
  return same;
}

bool TextCursor::accept_text(std::string_view text) {
  if (!std::string_view(at_, remaining()).starts_with(text)) return false;
  at_ += text.size();
  return true;
}

bool TextCursor::at_delimiter() const {
  return at_ == end_ || is_white(*at_) || (syntax_.continuation && *at_ == '\\');
}

double TextCursor::number(const char* what) {
  skip_blanks();
  const char* first = at_;
  if (first != end_ && *first == '+' && first + 1 != end_ && first[1] != '-') ++first;
  double value = 0;
  const auto [last, error] = std::from_chars(first, end_, value);
  if (error == std::errc::invalid_argument) fail_expected(what);
  const char* word_start = at_;
  at_ = last;
  const bool whole = at_delimiter();
  at_ = word_start;
  if (!whole) fail_expected(what);
  if (error == std::errc::result_out_of_range) value = out_of_range(first, last, what);
  if (!std::isfinite(value)) fail_expected(std::string(what) + " that is finite");
  at_ = last;
  return value;
}

double TextCursor::out_of_range(const char* first, const char* last, const char* what) {
  if (!is_tiny(first, last)) fail_expected(std::string(what) + " within the range of doubles");
  return *first == '-' ? -0.0 : 0.0;
}

std::int64_t TextCursor::leading_integer(const char* what) {
  skip_blanks();
  const char* first = at_;
  if (first != end_ && *first == '+' && first + 1 != end_ && first[1] != '-') ++first;
  std::int64_t value = 0;
  const auto [last, error] = std::from_chars(first, end_, value);
  if (error != std::errc{}) fail_expected(what);
  at_ = last;
  return value;
}

std::int64_t TextCursor::integer(const char* what) {
  skip_blanks();
  const char* first = at_;
  const std::int64_t value = leading_integer(what);
  if (at_delimiter()) return value;
  at_ = first;
  fail_expected(what);
}

std::uint64_t TextCursor::count(const char* what, std::uint64_t bytes) {
  skip_blanks();
  const std::size_t place = offset();
  const std::int64_t value = integer(what);
  if (value < 0) fail_at(place, std::string("expected ") + what + ", found " + std::to_string(value));
  // The last item needs no line end.
  const std::uint64_t room = (remaining() + 1) / bytes;
  if (static_cast<std::uint64_t>(value) > room)
    fail_at(place, "the " + std::string(what) + " is " + std::to_string(value) +
                       ", but the rest of the file has room for " + std::to_string(room) +
                       " at most: truncated, or the count is wrong");
  return static_cast<std::uint64_t>(value);
}

void TextCursor::fail_expected(const std::string& what) const {
  constexpr std::size_t longest = 32;
  std::string found;
  for (const char* c = at_; c != end_ && !is_white(*c) && found.size() < longest; ++c)
    found += static_cast<unsigned char>(*c) < 0x20 || *c == 0x7f ? '?' : *c;
  const char* place = at_ == end_ ? "the end of the file" : "the end of the line";
  fail("expected " + what + ", found " + (found.empty() ? place : "'" + found + "'"));
}

}  // namespace strata::io
