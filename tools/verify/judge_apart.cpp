#include "verify/judge_apart.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "common/json_choice.h"
#include "common/sibling_program.h"
#include "common/text_file.h"
#include "verify/engine.h"

namespace verify {
namespace {

namespace fs = std::filesystem;

/// The verdict in a report about one finding.
Verdict read_verdict(const fs::path& report) {
  const Json json = parse_json(read_file(report.string()), report.string());
  const JsonLocation finding = JsonLocation(json, report.string()).at("findings").items().at(0);
  return {read_choice(finding.at("outcome"), "outcome", all_outcomes), finding.at("reason").value().get<std::string>()};
}

}  // namespace

Verdict judge_apart(const fs::path& file, const Case& c, double unit_roundoff, const Limits& limits,
                    const fs::path& folder) {
  constexpr double least_seconds = 120;  // exact answers may take longer than rough ones
  const fs::path report = folder / "verdict.json";
  const std::vector<std::string> command = {own_program().string(),
                                            "verify",
                                            "--cases",
                                            fs::absolute(c.folder).parent_path().string(),
                                            "--case",
                                            c.slug,
                                            "--result",
                                            file.string(),
                                            "--roundoff",
                                            fmt::format("{}", unit_roundoff),
                                            "--report",
                                            report.string(),
                                            "--quiet"};
  const ChildEnd end = run_child(command, {std::max(limits.seconds, least_seconds), limits.bytes}, folder);
  if (end.how == ChildEnd::How::exited && fs::exists(report)) return read_verdict(report);
  return {Outcome::oracle_failed, "the judge failed: " + verdict_of(end).reason};
}

}  // namespace verify
