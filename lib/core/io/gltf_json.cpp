#include "core/io/gltf_json.h"

#include <cmath>
#include <utility>

namespace strata::io {

GltfJson parse_gltf_json(std::string_view text) {
  constexpr int deepest = 100;
  try {
    return GltfJson::parse(text.begin(), text.end(), [](int depth, GltfJson::parse_event_t, GltfJson&) {
      if (depth > deepest) fail("values in the JSON are nested more than 100 deep");
      return true;
    });
  } catch (const GltfJson::parse_error& error) {
    fail_at_byte(error.byte > 0 ? error.byte - 1 : 0, "the JSON of the file is malformed");
  } catch (const GltfJson::exception&) {
    fail("the JSON of the file has a number beyond the range of doubles");
  }
}

GltfValue GltfValue::at(const char* member) const {
  if (!has(member)) refuse(std::string("has no member '") + member + "'");
  return {(*json_)[member], path_.empty() ? member : path_ + "." + member};
}

GltfValue GltfValue::at(std::size_t element) const {
  if (!json_->is_array() || element >= json_->size()) refuse("has no element " + std::to_string(element));
  return {(*json_)[element], path_ + "[" + std::to_string(element) + "]"};
}

std::size_t GltfValue::size() const {
  if (!json_->is_array()) refuse("is not a list");
  return json_->size();
}

std::size_t GltfValue::count(const char* member) const { return has(member) ? at(member).size() : 0; }

double GltfValue::number() const {
  if (!json_->is_number()) refuse("is not a number");
  const double x = json_->get<double>();
  if (!std::isfinite(x)) refuse("is not finite");
  return x;
}

std::size_t GltfValue::index() const {
  constexpr double most = 9e15;
  if (json_->is_number_unsigned()) return json_->get<std::size_t>();
  const double x = json_->is_number() ? json_->get<double>() : -1;
  if (!(x >= 0) || x > most || x != std::floor(x)) refuse("is not a whole number from 0 on");
  return static_cast<std::size_t>(x);
}

std::size_t GltfValue::index_below(std::size_t count) const {
  const std::size_t i = index();
  if (i >= count) refuse("is " + std::to_string(i) + ", of " + std::to_string(count));
  return i;
}

const std::string& GltfValue::text() const {
  if (!json_->is_string()) refuse("is not a text");
  return json_->get_ref<const std::string&>();
}

std::size_t GltfValue::index_or(const char* member, std::size_t otherwise) const {
  return has(member) ? at(member).index() : otherwise;
}

double GltfValue::number_or(const char* member, double otherwise) const {
  return has(member) ? at(member).number() : otherwise;
}

std::string GltfValue::text_or(const char* member, std::string otherwise) const {
  return has(member) && (*json_)[member].is_string() ? (*json_)[member].get<std::string>() : std::move(otherwise);
}

bool GltfValue::is_true(const char* member) const {
  return has(member) && (*json_)[member].is_boolean() && (*json_)[member].get<bool>();
}

}  // namespace strata::io
