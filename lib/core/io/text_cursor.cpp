#include "core/io/text_cursor.h"

#include <algorithm>
#include <charconv>

#include "core/system/decimal.h"

namespace strata::io {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// True when a decimal number other than zero that is no double is too small for one, not too large: its first digit,
/// shifted by the exponent, is after the point.
bool is_tiny(const char* first, const char* last) {
  const char* mark = std::find_if(first, last, [](char c) { return c == 'e' || c == 'E'; });
  std::int64_t exponent = 0;
  if (mark != last) {
    const char* digits = mark + 1 + (mark[1] == '+');
    // An exponent that does not fit exceeds the number of digits of any file.
    constexpr std::int64_t huge = std::int64_t{1} << 60;
    if (system::from_chars(digits, last, exponent).ec != std::errc{}) exponent = *digits == '-' ? -huge : huge;
    exponent = std::clamp(exponent, -huge, huge);
  }
  const char* point = std::find(first, mark, '.');
  const char* digit = std::find_if(first, mark, [](char c) { return c >= '1' && c <= '9'; });
  return exponent + (point - digit) < 0;
}

}  // namespace

TextCursor::TextCursor(std::string_view text, Syntax syntax, Piece piece)
    : begin_(text.data()), at_(begin_ + piece.first), end_(begin_ + piece.last), syntax_(syntax) {
  if (piece.first == 0) accept_text("\xEF\xBB\xBF");
}

bool TextCursor::skip_continuation() {
  if (!syntax_.continuation) return false;
  const char* const next = at_ + 1;
  if (next == end_ || (*next != '\n' && *next != '\r')) return false;
  at_ = behind_line_end(next, end_);
  return true;
}

bool TextCursor::has_comment(const char* from) const {
  if (!syntax_.hash_comments) return false;
  for (const char* c = from; c != at_; ++c)
    if (*c == '#' && (c == from || is_white(c[-1]))) return true;
  return false;
}

bool TextCursor::accept(std::string_view expected) {
  if (at_line_end() || remaining() < expected.size()) return false;
  const char* const behind = at_ + expected.size();
  if (behind != end_ && !is_white(*behind)) return false;
  if (!std::equal(at_, behind, expected.begin(), [](char a, char b) { return lower(a) == lower(b); })) return false;
  at_ = behind;
  return true;
}

bool TextCursor::accept_text(std::string_view text) {
  if (!std::string_view(at_, remaining()).starts_with(text)) return false;
  at_ += text.size();
  return true;
}

double TextCursor::unusual_number(const char* what) {
  const char* const first = behind_plus();
  double value = 0;
  const auto [last, error] = system::from_chars(first, end_, value);
  if (error == std::errc::invalid_argument || !is_delimiter(last)) fail_expected(what);
  if (error == std::errc::result_out_of_range) {
    if (!is_tiny(first, last)) fail_expected(std::string(what) + " within the range of doubles");
    value = *first == '-' ? -0.0 : 0.0;
  }
  if (!std::isfinite(value)) fail_expected(std::string(what) + " that is finite");
  at_ = last;
  return value;
}

std::int64_t TextCursor::unusual_integer(const char* what) {
  std::int64_t value = 0;
  const auto [last, error] = system::from_chars(behind_plus(), end_, value);
  if (error != std::errc{}) fail_expected(what);
  at_ = last;
  return value;
}

std::uint64_t TextCursor::count(const char* what, std::uint64_t bytes) {
  skip_blanks();
  const std::size_t place = offset();
  const std::int64_t value = integer(what);
  if (value < 0) fail_at_line(place, std::string("expected ") + what + ", found " + std::to_string(value));
  // The last item needs no line end.
  const std::uint64_t room = (remaining() + 1) / bytes;
  if (static_cast<std::uint64_t>(value) > room)
    fail_at_line(place, "the " + std::string(what) + " is " + std::to_string(value) +
                            ", but the rest of the file has room for " + std::to_string(room) +
                            " at most: truncated, or the count is wrong");
  return static_cast<std::uint64_t>(value);
}

void TextCursor::fail_expected(const std::string& what) const {
  const std::string_view found(at_, static_cast<std::size_t>(std::find_if(at_, end_, is_white) - at_));
  const char* place = at_ == end_ ? "the end of the file" : "the end of the line";
  fail_here("expected " + what + ", found " + (found.empty() ? place : quoted(found)));
}

}  // namespace strata::io
