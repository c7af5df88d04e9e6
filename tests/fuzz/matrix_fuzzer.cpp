// Transforms in JSON, and what is written for them.
#include <optional>
#include <string>

#include "fuzz.h"
#include "io_error_law.h"
#include "json_matrix.h"

namespace strata::fuzz {
namespace {

Transform parse(std::string_view text) {
  const std::string file_name = "fuzz.json";
  try {
    const Json json = parse_json(text, file_name);
    return read_matrix(JsonLocation(json, file_name, "transform"));
  } catch (const IoError& error) {
    check_error(error, file_name);
    throw;
  }
}

std::string written(const Transform& map) {
  Json rows = Json::array();
  for (const Transform::Row& row : map.rows()) {
    rows.push_back(Json::array());
    for (const Rational& x : row) rows.back().push_back(x.str());
  }
  rows.push_back({0, 0, 0, 1});
  return rows.dump();
}

void check(std::string_view text) {
  try {
    const Transform map = parse(text);
    require(map.determinant() != 0, "transforms have inverses");
    require(parse(written(map)) == map, "what is written reads back the same");
  } catch (const IoError&) {  // was checked
  }
}

}  // namespace
}  // namespace strata::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return strata::fuzz::run(data, size, strata::fuzz::check);
}
