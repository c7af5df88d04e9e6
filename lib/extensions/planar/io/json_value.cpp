#include "extensions/planar/io/json_value.h"

#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

namespace strata::planar {
namespace {

using Kind = JsonValue::Kind;

/// Goes through a text and notes how far the parser has come.
class NotedIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  NotedIterator(const char* at, const char** note) : at_(at), note_(note) {}
  reference operator*() const { return *at_; }
  NotedIterator& operator++() {
    *note_ = ++at_;
    return *this;
  }
  friend bool operator==(const NotedIterator& a, const NotedIterator& b) { return a.at_ == b.at_; }

 private:
  const char* at_;
  const char** note_;
};

/// Makes a tree of what nlohmann's parser reports, with the places that it does not keep.
class TreeMaker {
 public:
  explicit TreeMaker(std::string_view text) : begin_(text.data()), read_(text.data()), end_(begin_ + text.size()) {}

  JsonValue read() {
    nlohmann::json::sax_parse(NotedIterator(begin_, &read_), NotedIterator(end_, &read_), this);
    return std::move(whole_);
  }

  // What the parser calls.
  bool null() { return add(value(Kind::null)); }
  bool boolean(bool) { return add(value(Kind::truth)); }
  bool number_integer(std::int64_t x) { return add_number(static_cast<double>(x)); }
  bool number_unsigned(std::uint64_t x) { return add_number(static_cast<double>(x)); }
  bool number_float(double x, const std::string&) { return add_number(x); }
  bool string(std::string& text) {
    JsonValue v = value(Kind::text);
    v.text = std::move(text);
    return add(std::move(v));
  }
  bool binary(nlohmann::json::binary_t&) { return false; }  // JSON has none
  bool start_object(std::size_t) { return open(Kind::object); }
  bool start_array(std::size_t) { return open(Kind::array); }
  bool key(std::string& name) {
    open_.back().names.push_back(std::move(name));
    return true;
  }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error) {
    io::fail_at_line(offset(), reason_of(error.what()));
  }

 private:
  /// Of the last character that was read: within the value or just behind it.
  [[nodiscard]] std::size_t offset() const {
    return static_cast<std::size_t>(read_ - begin_) - (read_ > begin_ ? 1 : 0);
  }
  [[nodiscard]] JsonValue value(Kind kind) const {
    JsonValue v;
    v.kind = kind;
    v.offset = offset();
    return v;
  }
  bool add_number(double x) {
    JsonValue v = value(Kind::number);
    v.number = x;
    return add(std::move(v));
  }
  bool add(JsonValue v) {
    (open_.empty() ? whole_ : open_.back().items.emplace_back()) = std::move(v);
    return true;
  }
  bool open(Kind kind) {
    constexpr std::size_t deepest = 512;
    if (open_.size() > deepest) io::fail_at_line(offset(), "values are nested more than 512 deep");
    open_.push_back(value(kind));
    return true;
  }
  bool close() {
    JsonValue v = std::move(open_.back());
    open_.pop_back();
    return add(std::move(v));
  }
  /// Without the library's number of the error and its own line; what it quotes may be long.
  static std::string reason_of(std::string_view text) {
    constexpr std::size_t most = 160;
    const std::size_t column = text.find("column ");
    const std::size_t from =
        text.find(column == std::string_view::npos ? "] " : ": ", column == std::string_view::npos ? 0 : column);
    text.remove_prefix(from == std::string_view::npos ? 0 : from + 2);
    return "no JSON: " + std::string(text.substr(0, most)) + (text.size() > most ? "..." : "");
  }

  const char *begin_, *read_, *end_;
  std::vector<JsonValue> open_;  ///< arrays and objects
  JsonValue whole_;
};

}  // namespace

const JsonValue* JsonValue::find(std::string_view name) const {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return &items[i];
  return nullptr;
}

JsonValue read_json(std::string_view text) { return TreeMaker(text).read(); }

}  // namespace strata::planar
