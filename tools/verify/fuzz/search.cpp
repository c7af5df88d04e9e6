#include "verify/fuzz/search.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "common/exit_code.h"
#include "common/scratch.h"
#include "core/system/program.h"
#include "verify/fuzz/laws.h"
#include "verify/fuzz/shrink.h"

namespace fuzz {
namespace {

using verify::ChildEnd;

/// "check: reason", as the child has written it.
Broke read_broke(const std::string& error) {
  const std::size_t colon = error.find(": ");
  if (colon == std::string::npos) return {"error", error};
  return {error.substr(0, colon), error.substr(colon + 2)};
}

Reply reply_of(const ChildEnd& end) {
  if (end.how == ChildEnd::How::timed_out)
    return {true, Broke{"hang", fmt::format("stopped after {:.1f} s", end.seconds)}};
  if (end.how == ChildEnd::How::crashed)
    return {true, Broke{"crash", "ended by " + strata::system::name_of_crash(end.code)}};
  if (end.code == static_cast<int>(ExitCode::ok)) return {true, {}};
  if (end.code == static_cast<int>(ExitCode::invalid_input)) return {false, {}};
  if (end.code == static_cast<int>(ExitCode::negative)) return {true, read_broke(end.error)};
  if (end.code == static_cast<int>(ExitCode::stopped)) return {true, Broke{"memory", end.error}};
  return {true, Broke{"error", fmt::format("exit status {}: {}", end.code, end.error)}};
}

}  // namespace

Reply ask(const Question& question, const std::string& engine, const Asking& asking, const std::string& only) {
  const Scratch scratch;
  const std::filesystem::path folder = scratch.path() / "case";
  write_case(folder, question, question.kind, {"fuzz"});
  std::vector<std::string> command = {asking.program, "fuzz", "--case", folder.string(), "--engine", engine};
  if (!only.empty()) command.insert(command.end(), {"--check", only});
  command.insert(command.end(), asking.words.begin(), asking.words.end());
  verify::Limits limits = asking.limits;
  constexpr double most_expressions = 60;  // of one question; every one has its own limit
  if (engine != "strata") limits.seconds *= most_expressions;
  verify::ChildEnd end = verify::run_child(command, limits, scratch.path());
  if (end.how == ChildEnd::How::timed_out) {  // on a busy machine that may be nobody's fault
    constexpr double patience = 5;
    limits.seconds *= patience;
    end = verify::run_child(command, limits, scratch.path());
  }
  return reply_of(end);
}

Question shrunken(const Question& question, const std::string& engine, const std::string& check, const Asking& asking,
                  double seconds) {
  const auto& names = check_names();
  const bool is_law = std::find(names.begin(), names.end(), check) != names.end();
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  return fuzz::shrunken(question, [&](const Question& candidate) {
    if (std::chrono::steady_clock::now() > end) return false;
    const Reply reply = ask(candidate, engine, asking, is_law ? check : "");
    return reply.broke && reply.broke->check == check;
  });
}

}  // namespace fuzz
