// expected.json, and that it is written as it was read.
#include <string>

#include "fuzz.h"
#include "io_error_law.h"
#include "verify/expectation.h"

namespace strata::fuzz {
namespace {

void check_written(const verify::Expectation& expectation) {
  const std::string written = verify::to_json(expectation).dump();
  const verify::Expectation again = verify::parse_expectation(written, "written");
  require(!verify::difference(again, expectation), "what is written says the same");
  require(again.origin == expectation.origin, "origins are kept");
  require(verify::to_json(again).dump() == written, "what was written is written again");
}

void check(std::string_view text) {
  const std::string file_name = "fuzz.json";
  try {
    const verify::Expectation expectation = verify::parse_expectation(text, file_name);
    const Json json = parse_json(text, file_name);
    for (const char* key : {"euler", "vertices", "edges", "facets", "components"})
      require(verify::to_json(expectation)[key].dump() == json[key].dump(), "integers are what the text says");
    check_written(expectation);
  } catch (const IoError& error) {
    check_error(error, file_name);
  }
}

}  // namespace
}  // namespace strata::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return strata::fuzz::run(data, size, strata::fuzz::check);
}
