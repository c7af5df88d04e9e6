#include "batch_record.h"

#include <array>
#include <sstream>

#include "common/json_choice.h"
#include "common/json_location.h"

namespace {

constexpr std::array statuses = {JobStatus::ok, JobStatus::failed, JobStatus::timeout, JobStatus::memory,
                                 JobStatus::crashed};

Json lines_of(const std::string& text) {
  Json lines = Json::array();
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

Json number_or_null(const std::optional<int>& number) { return number ? Json(*number) : Json(nullptr); }

}  // namespace

const char* name(JobStatus status) {
  switch (status) {
    case JobStatus::ok:
      return "ok";
    case JobStatus::failed:
      return "failed";
    case JobStatus::timeout:
      return "timeout";
    case JobStatus::memory:
      return "memory";
    case JobStatus::crashed:
      return "crashed";
  }
  return "";
}

std::string record_of(const BatchJob& job, const JobEnd& end) {
  const std::string output = job.output();
  const Json record = {{"id", job.id},
                       {"line", job.line},
                       {"job", job.digest},
                       {"status", name(end.status)},
                       {"exit_code", number_or_null(end.exit_code)},
                       {"signal", number_or_null(end.signal)},
                       {"seconds", end.seconds},
                       {"peak_memory_bytes", end.peak_bytes},
                       {"output", output.empty() ? Json(nullptr) : Json(output)},
                       {"messages", lines_of(end.error)},
                       {"stdout", end.output}};
  return record.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

RecordKey read_record_key(std::string_view record, const std::string& where) {
  const Json json = parse_json_line(record, where);
  const JsonLocation root(json, where);
  const JsonLocation line = root.at("line");
  if (!line.value().is_number_unsigned()) line.fail_expected("the number of a line");
  return {line.value().get<std::size_t>(), root.at("job").text(), read_choice(root.at("status"), "status", statuses)};
}
