#include "common/json_location.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>

#include "strata/errors.h"

namespace {

std::string member_path(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

/// Watches a text being parsed for keys that an object has twice, of which only the last would be seen, and for nesting
/// that is too deep: copies and texts of values are made by recursion.
class KeyWatch {
 public:
  explicit KeyWatch(const std::string& file) : file_(file) {}

  bool see(Json::parse_event_t event, const Json& parsed) {
    using Event = Json::parse_event_t;
    switch (event) {
      case Event::object_start:
      case Event::array_start:
        begin_item();
        if (open_.size() == deepest)
          throw strata::IoError(file_, {}, fmt::format("arrays and objects are nested more than {} deep", deepest));
        open_.push_back({event == Event::array_start, 0, {}, {}});
        break;
      case Event::object_end:
      case Event::array_end:
        open_.pop_back();
        break;
      case Event::key:
        open_.back().key = parsed.get<std::string>();
        if (!open_.back().keys.insert(open_.back().key).second)
          throw strata::IoError(file_, {}, path() + ": this key stands twice in one object");
        break;
      case Event::value:
        begin_item();
        break;
    }
    return true;
  }

 private:
  static constexpr std::size_t deepest = 100;
  struct Open {
    bool is_array;
    std::size_t items;  ///< of an array, begun so far
    std::string key;    ///< of an object, the last
    std::set<std::string> keys;
  };

  void begin_item() {
    if (!open_.empty() && open_.back().is_array) ++open_.back().items;
  }

  std::string path() const {
    std::string path;
    for (const Open& o : open_) path = o.is_array ? fmt::format("{}[{}]", path, o.items - 1) : member_path(path, o.key);
    return path;
  }

  const std::string& file_;
  std::vector<Open> open_;
};

// Messages of the parser begin with an identifier in brackets and end with what was wrong: "[...] parse error at line
// 1, column 2: syntax error while ...".
std::string reason_of(const std::string& message) {
  const std::size_t column = message.find("column ");
  const std::size_t from = column == std::string::npos ? message.find("] ") : message.find(": ", column);
  return from == std::string::npos ? message : message.substr(from + 2);
}

[[noreturn]] void fail_at_byte(const std::string& file, std::string_view text, std::size_t byte,
                               const std::string& reason) {
  const std::string_view before = text.substr(0, byte == 0 ? 0 : byte - 1);
  const auto line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
  const std::size_t column = before.size() - (before.rfind('\n') == before.npos ? 0 : before.rfind('\n') + 1) + 1;
  throw strata::IoError(file, {line, {}}, fmt::format("column {}: {}", column, reason));
}

/// How messages show a value: short.
std::string shown(const Json& value) {
  constexpr std::size_t longest = 40;
  std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  if (value.is_object()) return "an object";
  if (text.size() > longest) return value.is_array() ? "an array" : text.substr(0, longest) + "...";
  return text;
}

}  // namespace

Json parse_json(std::string_view text, const std::string& file) {
  KeyWatch keys(file);
  try {
    return Json::parse(text.begin(), text.end(),
                       [&keys](int, Json::parse_event_t event, const Json& parsed) { return keys.see(event, parsed); });
  } catch (const Json::parse_error& error) {
    fail_at_byte(file, text, error.byte, reason_of(error.what()));
  } catch (const Json::exception& error) {
    throw strata::IoError(file, {}, reason_of(error.what()));
  }
}

Json parse_json_line(std::string_view text, const std::string& where) {
  try {
    return parse_json(text, where);
  } catch (const strata::IoError& error) {
    throw strata::IoError(where, {}, error.reason());
  }
}

JsonLocation::JsonLocation(const Json& value, std::string file, std::string path)
    : value_(&value), file_(std::move(file)), path_(std::move(path)) {}

void JsonLocation::expect_keys(std::initializer_list<std::string_view> keys) const {
  if (!value_->is_object()) fail_expected("an object");
  for (const auto& [key, value] : value_->items())
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      JsonLocation(value, file_, member_path(path_, key))
          .fail(fmt::format("no such key; known are {}", fmt::join(keys, ", ")));
}

JsonLocation JsonLocation::at(const std::string& key) const {
  if (auto member = find(key)) return *std::move(member);
  fail(fmt::format("'{}' is missing", key));
}

std::optional<JsonLocation> JsonLocation::find(const std::string& key) const {
  if (!value_->is_object()) fail_expected("an object");
  const auto found = value_->find(key);
  if (found == value_->end()) return {};
  return JsonLocation(*found, file_, member_path(path_, key));
}

std::vector<JsonLocation> JsonLocation::items() const {
  if (!value_->is_array()) fail_expected("an array");
  std::vector<JsonLocation> items;
  for (std::size_t k = 0; k < value_->size(); ++k)
    items.emplace_back((*value_)[k], file_, fmt::format("{}[{}]", path_, k));
  return items;
}

std::string JsonLocation::text() const {
  if (!value_->is_string()) fail_expected("a string");
  std::string text = value_->get<std::string>();
  if (text.empty() || text.find('\0') != std::string::npos) fail_expected("a string, not empty and without zero bytes");
  return text;
}

std::size_t JsonLocation::choice(std::string_view what, const std::vector<std::string_view>& words) const {
  const std::string word = text();
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) fail(fmt::format("'{}' is no {}; one of {}", word, what, fmt::join(words, ", ")));
  return static_cast<std::size_t>(found - words.begin());
}

void JsonLocation::fail(const std::string& reason) const {
  throw strata::IoError(file_, {}, path_.empty() ? reason : fmt::format("{}: {}", path_, reason));
}

void JsonLocation::fail_expected(std::string_view what) const {
  fail(fmt::format("expected {}, found {}", what, shown(*value_)));
}
