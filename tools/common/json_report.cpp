#include "common/json_report.h"

#include <utility>

#include "common/text_file.h"
#include "core/system/memory.h"

std::uint64_t peak_bytes() { return strata::system::peak_bytes(); }

void write_report(const std::string& where, Json report) {
  report["strata"] = STRATA_VERSION;
  write_text(where, report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}
