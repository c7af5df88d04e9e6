// Documents of `strata chain`.
#include "chain_document.h"
#include "fuzz.h"
#include "io_error_law.h"

namespace strata::fuzz {
namespace {

constexpr const char* file_name = "folder/steps.json";

void check(const ChainOperand& operand) {
  require(!operand.place.empty() && !operand.file.empty() && !operand.path.empty(), "operands have places and files");
  require(operand.transform.determinant() != 0, "transforms have inverses");
  require(!operand.title().empty(), "operands have titles");
}

void check(std::string_view text) {
  try {
    const ChainDocument document = parse_chain_document(text, file_name, Settings());
    require(document.name == file_name, "documents have the name given");
    if (document.start) check(*document.start);
    for (const ChainStep& step : document.steps) check(step.operand);
  } catch (const IoError& error) {
    check_error(error, file_name);
  }
}

}  // namespace
}  // namespace strata::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return strata::fuzz::run(data, size, [](std::string_view text) { strata::fuzz::check(text); });
}
