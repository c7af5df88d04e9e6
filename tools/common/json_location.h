#pragma once
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/json_report.h"

/// Parses a JSON text. `file` stands for it in messages. Throws strata::IoError with line and column for what is no
/// JSON, with the place for a key that an object has twice, and for arrays and objects nested more than 100 deep.
[[nodiscard]] Json parse_json(std::string_view text, const std::string& file);

/// The same for a line of a file of many; `where` is "file:line", and messages begin with it.
[[nodiscard]] Json parse_json_line(std::string_view text, const std::string& where);

/// A value in a JSON document that knows where it stands: "steps[3].operation". Whatever is not as asked for is a
/// strata::IoError that begins with this place. Valid as long as the document.
class JsonLocation {
 public:
  JsonLocation(const Json& value, std::string file, std::string path = {});

  [[nodiscard]] const Json& value() const { return *value_; }
  [[nodiscard]] const std::string& path() const { return path_; }  ///< empty for the whole document

  /// Demands an object that has no other keys.
  void expect_keys(std::initializer_list<std::string_view> keys) const;
  [[nodiscard]] JsonLocation at(const std::string& key) const;  ///< demands an object that has it
  [[nodiscard]] std::optional<JsonLocation> find(const std::string& key) const;
  [[nodiscard]] std::vector<JsonLocation> items() const;  ///< demands an array
  /// Demands a string, not empty and without bytes 0.
  [[nodiscard]] std::string text() const;
  /// Demands one of these strings; which, from 0. Throws "'cut' is no operation; one of ..." for `what` "operation".
  [[nodiscard]] std::size_t choice(std::string_view what, const std::vector<std::string_view>& words) const;

  [[noreturn]] void fail(const std::string& reason) const;
  [[noreturn]] void fail_expected(std::string_view what) const;  ///< "expected ..., found ..."

 private:
  const Json* value_;
  std::string file_;
  std::string path_;
};
