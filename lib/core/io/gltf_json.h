#pragma once
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/io/input.h"

namespace strata::io {

using GltfJson = nlohmann::json;

/// Parses a document whose values are nested 100 deep at most. Throws Malformed.
[[nodiscard]] GltfJson parse_gltf_json(std::string_view text);

/// An element of a JSON document, with the path to it for messages. What is missing, or of another type than asked for,
/// is an error or a default. Throws Malformed.
class GltfValue {
 public:
  GltfValue(const GltfJson& json, std::string path) : json_(&json), path_(std::move(path)) {}

  [[nodiscard]] bool has(const char* member) const { return json_->is_object() && json_->contains(member); }
  [[nodiscard]] GltfValue at(const char* member) const;
  [[nodiscard]] GltfValue at(std::size_t element) const;
  /// Elements of a list that is a member; 0 if there is none.
  [[nodiscard]] std::size_t count(const char* member) const;

  [[nodiscard]] std::size_t size() const;  ///< of a list
  [[nodiscard]] double number() const;     ///< finite
  [[nodiscard]] std::size_t index() const;
  /// An index into a list of `count`.
  [[nodiscard]] std::size_t index_below(std::size_t count) const;
  [[nodiscard]] const std::string& text() const;
  [[nodiscard]] std::size_t index_or(const char* member, std::size_t otherwise) const;
  [[nodiscard]] double number_or(const char* member, double otherwise) const;
  [[nodiscard]] std::string text_or(const char* member, std::string otherwise) const;
  [[nodiscard]] bool is_true(const char* member) const;

  [[nodiscard]] const GltfJson& json() const { return *json_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  [[noreturn]] void refuse(const std::string& reason) const { fail(path_ + ": " + reason); }

 private:
  const GltfJson* json_;
  std::string path_;
};

}  // namespace strata::io
