#include "core/io/xml_scanner.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/io/text_cursor.h"
#include "core/system/decimal.h"

namespace strata::io {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }

constexpr auto name_ends = [] {
  std::array<bool, 256> ends{};
  for (const char c : std::string_view(" \n\t\r=/><\"'")) ends[static_cast<unsigned char>(c)] = true;
  return ends;
}();

bool ends_name(char c) { return name_ends[static_cast<unsigned char>(c)]; }

/// Where the next such character is, or the end. For short distances, where a call of memchr costs more.
std::size_t next_of(std::string_view text, char c, std::size_t at) {
  while (at < text.size() && text[at] != c) ++at;
  return at;
}

/// A name without its prefix.
std::string_view local(std::string_view name) {
  const std::size_t colon = next_of(name, ':', 0);
  return colon == name.size() ? name : name.substr(colon + 1);
}

/// Where the next end tag starts, or the end. Blocks without one are passed without a branch for each character.
std::size_t next_end_tag(std::string_view text, std::size_t at) {
  constexpr std::size_t block = 1 << 12;
  for (; at + block < text.size(); at += block) {
    unsigned char found = 0;
    for (const char* c = text.data() + at; c != text.data() + at + block; ++c)
      found |= static_cast<unsigned char>(static_cast<unsigned>(c[0] == '<') & static_cast<unsigned>(c[1] == '/'));
    if (found != 0) break;
  }
  return std::min(text.find("</", at), text.size());
}

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

constexpr std::array<std::pair<std::string_view, char>, 5> entities{
    std::pair<std::string_view, char>{"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}};

void append_utf8(std::string& text, std::uint32_t c) {
  const auto tail = [&](unsigned shift) { text += static_cast<char>(0x80 | ((c >> shift) & 0x3f)); };
  if (c < 0x80) {
    text += static_cast<char>(c);
  } else if (c < 0x800) {
    text += static_cast<char>(0xc0 | (c >> 6));
    tail(0);
  } else if (c < 0x10000) {
    text += static_cast<char>(0xe0 | (c >> 12));
    tail(6), tail(0);
  } else if (c < 0x110000) {
    text += static_cast<char>(0xf0 | (c >> 18));
    tail(12), tail(6), tail(0);
  }
}

/// Appends what an entity, without & and ;, stands for. False if there is none.
bool append_entity(std::string& text, std::string_view entity) {
  for (const auto& [name, c] : entities)
    if (entity == name) return text += c, true;
  if (!entity.starts_with('#')) return false;
  const bool is_hex = entity.starts_with("#x");
  entity.remove_prefix(is_hex ? 2 : 1);
  std::uint32_t c = 0;
  const auto [end, error] = std::from_chars(entity.data(), entity.data() + entity.size(), c, is_hex ? 16 : 10);
  if (error != std::errc{} || end != entity.data() + entity.size()) return false;
  append_utf8(text, c);
  return true;
}

}  // namespace

XmlScanner::XmlScanner(std::string_view text) : text_(text) {
  constexpr std::string_view mark = "\xef\xbb\xbf";
  if (text.starts_with("\xfe\xff") || text.starts_with("\xff\xfe")) fail("XML in UTF-16, where UTF-8 is expected");
  if (text.starts_with(mark)) at_ = mark.size();
}

void XmlScanner::skip_blanks() {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
}

void XmlScanner::skip_behind(std::string_view mark, const char* what) {
  const std::size_t found = text_.find(mark, at_);
  if (found == std::string_view::npos) fail_at_line(at_, std::string(what) + " has no end");
  at_ = found + mark.size();
}

void XmlScanner::skip_misc() {
  while (true) {
    skip_blanks();
    if (at_ < text_.size() && text_[at_] != '<') at_ = std::min(text_.find('<', at_), text_.size());
    const std::string_view rest = text_.substr(at_);
    if (rest.size() < 2 || (rest[1] != '!' && rest[1] != '?')) return;
    if (rest.starts_with("<!--"))
      skip_behind("-->", "a comment");
    else if (rest.starts_with("<![CDATA["))
      skip_behind("]]>", "a CDATA section");
    else if (rest.starts_with("<?"))
      skip_behind("?>", "an instruction");
    else
      fail_at_line(at_, "document types and other declarations in XML are not read");
  }
}

std::string_view XmlScanner::read_name() {
  const std::size_t first = at_;
  while (at_ < text_.size() && !ends_name(text_[at_])) ++at_;
  if (at_ == first) fail_at_line(at_, "expected a name in a tag");
  return text_.substr(first, at_ - first);
}

void XmlScanner::read_start() {
  constexpr std::size_t deepest = 200;
  tag_ = at_++;
  const std::string_view whole = read_name();
  name_ = local(whole);
  attributes_.clear();
  closed_ = false;
  while (true) {
    skip_blanks();
    if (at_ >= text_.size()) fail_at_line(tag_, "a tag has no end");
    if (text_[at_] == '>') {
      ++at_;
      if (open_.size() == deepest) fail_at_line(tag_, "elements are nested more than 200 deep");
      open_.push_back(whole);
      return;
    }
    if (text_[at_] == '/') {
      if (at_ + 1 >= text_.size() || text_[at_ + 1] != '>') fail_at_line(tag_, "a tag has no end");
      at_ += 2;
      closed_ = true;
      return;
    }
    const std::string_view attribute = read_name();
    skip_blanks();
    if (at_ >= text_.size() || text_[at_] != '=') fail_at_line(tag_, "an attribute has no value");
    ++at_;
    skip_blanks();
    const char quote = at_ < text_.size() ? text_[at_] : ' ';
    if (quote != '"' && quote != '\'') fail_at_line(tag_, "the value of an attribute is not in quotes");
    const std::size_t end = next_of(text_, quote, at_ + 1);
    if (end == text_.size()) fail_at_line(tag_, "the value of an attribute has no end");
    attributes_.push_back({local(attribute), text_.substr(at_ + 1, end - at_ - 1)});
    at_ = end + 1;
  }
}

void XmlScanner::read_end() {
  tag_ = at_;
  at_ += 2;
  const std::string_view whole = read_name();
  skip_blanks();
  if (at_ >= text_.size() || text_[at_] != '>') fail_at_line(tag_, "a tag has no end");
  ++at_;
  if (open_.empty() || open_.back() != whole)
    fail_at_line(tag_, "</" + std::string(whole.substr(0, 32)) + "> ends an element that was not started");
  open_.pop_back();
}

bool XmlScanner::next_child() {
  if (closed_) {
    closed_ = false;
    return false;
  }
  skip_misc();
  if (at_ >= text_.size()) {
    if (!open_.empty())
      fail_at_line(at_, "the XML is truncated: <" + std::string(open_.back().substr(0, 32)) + "> has no end");
    return false;
  }
  if (at_ + 1 < text_.size() && text_[at_ + 1] == '/') {
    read_end();
    return false;
  }
  read_start();
  return true;
}

void XmlScanner::skip() {
  if (closed_) {
    closed_ = false;
    return;
  }
  const std::size_t depth = open_.size();
  while (open_.size() >= depth) {
    const bool is_start = next_child();
    if (is_start && closed_) closed_ = false;
  }
}

std::vector<std::string_view> XmlScanner::pieces() const {
  constexpr std::size_t least = 1 << 17;
  std::vector<std::string_view> pieces;
  if (closed_) return pieces;
  const std::size_t end = next_end_tag(text_, at_);
  for (std::size_t first = at_; first < end;) {
    const std::size_t cut = end - first > least ? std::min(text_.find('<', first + least), end) : end;
    pieces.push_back(text_.substr(first, cut - first));
    first = cut;
  }
  return pieces;
}

void XmlScanner::pass(const std::vector<std::string_view>& pieces) {
  for (const std::string_view piece : pieces) at_ += piece.size();
}

std::string_view XmlScanner::content() {
  if (closed_) {
    closed_ = false;
    return {};
  }
  const std::size_t first = at_;
  skip();
  return without_blanks(text_.substr(first, tag_ - first));
}

const std::string_view* XmlScanner::find(std::string_view attribute) const {
  for (const Attribute& a : attributes_)
    if (a.name == attribute) return &a.value;
  return nullptr;
}

std::string XmlScanner::text_of(std::string_view attribute) const {
  const std::string_view* const raw = find(attribute);
  return raw == nullptr ? std::string() : unescaped(*raw);
}

double XmlScanner::number(std::string_view value, const char* what) const {
  double x = 0;
  const auto [end, error] = system::from_chars(value.data(), value.data() + value.size(), x);
  if (error == std::errc{} && end == value.data() + value.size() && std::isfinite(x)) return x;
  try {
    const std::string_view inner = without_blanks(value);
    TextCursor cursor(inner, {});
    x = cursor.number(what);
    if (cursor.at_end()) return x;
  } catch (const Malformed& malformed) {
    fail_here(malformed.reason);
  }
  fail_here(std::string("expected ") + what + ", found " + quoted(value));
}

std::uint32_t XmlScanner::index(std::string_view value, const char* what) const {
  std::uint32_t x = 0;
  auto [end, error] = system::from_chars(value.data(), value.data() + value.size(), x);
  if (error == std::errc{} && end == value.data() + value.size()) return x;
  const std::string_view inner = without_blanks(value);
  const auto again = system::from_chars(inner.data(), inner.data() + inner.size(), x);
  if (again.ec != std::errc{} || again.ptr != inner.data() + inner.size())
    fail_here(std::string("expected ") + what + ", found " + quoted(value));
  return x;
}

std::string unescaped(std::string_view raw) {
  std::string text;
  while (!raw.empty()) {
    const std::size_t start = std::min(raw.find('&'), raw.size());
    text += raw.substr(0, start);
    raw.remove_prefix(start);
    if (raw.empty()) break;
    const std::size_t end = raw.find(';');
    if (end != std::string_view::npos && append_entity(text, raw.substr(1, end - 1))) {
      raw.remove_prefix(end + 1);
    } else {
      text += '&';
      raw.remove_prefix(1);
    }
  }
  return text;
}

std::string escaped(std::string_view text) {
  std::string raw;
  for (const char c : text) {
    const auto found = std::find_if(entities.begin(), entities.end(), [&](const auto& e) { return e.second == c; });
    if (found != entities.end())
      raw.append("&").append(found->first).append(";");
    else if (c == '\n' || c == '\r' || c == '\t')
      raw.append("&#").append(std::to_string(static_cast<int>(c))).append(";");
    else if (static_cast<unsigned char>(c) >= ' ')
      raw += c;
  }
  return raw;
}

}  // namespace strata::io
