#include "common/write_case.h"

#include "common/json_report.h"
#include "common/text_file.h"
#include "strata/io.h"
#include "verify/case.h"

namespace verify {

void write_case(const std::filesystem::path& folder, const NewCase& c) {
  Json document = {{"why", c.why}, {"expression", c.expression}, {"operands", Json::object()}, {"tags", c.tags}};
  if (c.input != strata::InputClass::solid) document["input"] = name(c.input);
  for (const auto& [name, mesh] : c.operands) {
    const bool is_doubles = mesh->exact.empty();
    const std::string file = name + (is_doubles ? ".off" : ".xoff");
    strata::write_mesh(folder / file, *mesh, is_doubles ? strata::Format::off : strata::Format::xoff);
    document["operands"][name] = file;
  }
  write_text((folder / "case.json").string(), document.dump(1) + "\n");
}

}  // namespace verify
