#include "verify/fuzz/findings.h"

#include <fmt/format.h>

#include <exception>

#include "verify/certify.h"

namespace fuzz {
namespace {

namespace fs = std::filesystem;

fs::path new_folder(const fs::path& keep, const std::string& name) {
  fs::create_directories(keep);
  fs::path folder = keep / name;
  for (int n = 2; fs::exists(fs::symlink_status(folder)); ++n) folder = keep / fmt::format("{}-{}", name, n);
  fs::create_directory(folder);
  return folder;
}

/// True if expected.json is there and the oracle agrees with it.
bool has_witness(const fs::path& folder, const fs::path& oracle, const verify::Limits& limits) {
  if (oracle.empty()) return false;
  verify::RunOptions options;
  options.limits = limits;
  options.jobs = 1;
  const auto is_exact = [](const verify::Run& run) {
    return run.findings.front().verdict.outcome == verify::Outcome::exact;
  };
  try {
    return is_exact(verify::certify({verify::read_case(folder)}, options)) &&
           is_exact(verify::recertify({verify::read_case(folder)}, oracle, options));
  } catch (const std::exception&) {
    return false;  // a result that even the certification fails on
  }
}

}  // namespace

std::string replay_command(const Finding& f) {
  const std::string asked = f.engine == "strata" ? "" : fmt::format(" --engine \"{}\"", f.engine);
  return fmt::format("strata fuzz --seed {} --round {}{}", f.round.seed, f.round.number, asked);
}

fs::path keep_finding(const Finding& f, const fs::path& keep, const fs::path& oracle, const verify::Limits& limits) {
  const fs::path folder = new_folder(keep, fmt::format("fuzz-{}-{}-{}", f.broke.check, f.round.seed, f.round.number));
  const std::string why = fmt::format("The check '{}' does not hold: {}. Found in {} by: {}", f.broke.check,
                                      f.broke.reason, f.question.kind, replay_command(f));
  const std::vector<std::string> tags = {"fuzz", f.broke.check};
  write_case(folder, f.question, why, tags);
  if (has_witness(folder, oracle, limits)) return folder;
  fs::remove(folder / "expected.json");
  write_case(folder, f.question, why + ". Nobody but the engine has said yet what is right.", tags);
  return folder;
}

}  // namespace fuzz
