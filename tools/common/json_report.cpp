#include "common/json_report.h"

#include <sys/resource.h>

#include <utility>

#include "common/text_file.h"

std::uint64_t peak_bytes() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  return static_cast<std::uint64_t>(usage.ru_maxrss);
#else
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
#endif
}

void write_report(const std::string& where, Json report) {
  report["strata"] = STRATA_VERSION;
  write_text(where, report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}
