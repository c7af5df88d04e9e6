#include "verify/engine.h"

#include <fmt/format.h>

#include <sstream>
#include <stdexcept>
#include <utility>

#include "common/scratch.h"
#include "core/system/program.h"
#include "verify/command_engine.h"
#include "verify/strata_engine.h"

namespace verify {
namespace {

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> list;
  for (std::string word; stream >> word;) list.push_back(word);
  return list;
}

bool is_name(const std::string& text) { return text.find_first_of(" /=") == std::string::npos; }

/// The last line that says something.
std::string last_line(const std::string& text) {
  const std::size_t start = text.rfind('\n');
  return start == std::string::npos ? text : text.substr(start + 1);
}

class GivenResult : public Engine {
 public:
  GivenResult(std::filesystem::path file, double unit_roundoff)
      : file_(std::move(file)), unit_roundoff_(unit_roundoff) {}

  [[nodiscard]] std::string name() const override { return "result"; }
  [[nodiscard]] double unit_roundoff() const override { return unit_roundoff_; }
  [[nodiscard]] Answer ask(const Case&, const std::filesystem::path&, const Limits&) const override {
    Answer answer;
    answer.file = file_;
    return answer;
  }

 private:
  std::filesystem::path file_;
  double unit_roundoff_;
};

}  // namespace

std::vector<std::string> script_command(const EngineFolders& folders, const std::filesystem::path& script,
                                        double* unit_roundoff) {
  const std::string name = script.stem().string();
  if (!std::filesystem::exists(script))
    throw std::runtime_error(fmt::format("no engine is called '{}': there is no {}", name, script.string()));
  const std::string interpreter = script.extension() == ".mjs" ? "node" : folders.python;
  std::vector<std::string> command = {interpreter, std::filesystem::absolute(script).string()};
  std::vector<std::string> check = command;
  check.emplace_back("--check");
  const Scratch scratch;
  const ChildEnd end = run_child(check, {60, 0}, scratch.path());
  // The exit status is 0, or the exponent of the unit roundoff of floats.
  const bool is_float = end.code == 24;
  if (end.how != ChildEnd::How::exited || (end.code != 0 && !is_float))
    throw std::runtime_error(fmt::format("engine not installed: {}", end.error.empty() ? name : end.error));
  if (unit_roundoff != nullptr) *unit_roundoff = is_float ? 0x1p-24 : 0x1p-53;
  return command;
}

std::unique_ptr<Engine> make_engine(const std::string& text, const EngineFolders& folders) {
  if (std::unique_ptr<Engine> own = make_strata_engine(text, folders)) return own;
  if (is_name(text)) {
    double unit_roundoff = 0;
    std::vector<std::string> script = script_command(folders, folders.scripts / (text + ".py"), &unit_roundoff);
    return make_command_engine(text, std::move(script), unit_roundoff);
  }
  const std::size_t equals = text.find('=');
  const bool is_named = equals != std::string::npos && is_name(text.substr(0, equals)) && equals > 0;
  const std::vector<std::string> command = words(is_named ? text.substr(equals + 1) : text);
  if (command.empty()) throw std::runtime_error(fmt::format("'{}' is no command", text));
  const std::string name = is_named ? text.substr(0, equals) : std::filesystem::path(command.front()).stem().string();
  return make_command_engine(name, command, 0x1p-53);
}

std::unique_ptr<Engine> make_given_result(const std::filesystem::path& file, double unit_roundoff) {
  return std::make_unique<GivenResult>(file, unit_roundoff);
}

Verdict verdict_of(const ChildEnd& end) {
  constexpr int refused = 3;
  switch (end.how) {
    case ChildEnd::How::timed_out:
      return {Outcome::timed_out, fmt::format("stopped after {:.1f} s", end.seconds)};
    case ChildEnd::How::crashed:
      return {Outcome::crashed, "ended by " + strata::system::name_of_crash(end.code)};
    case ChildEnd::How::exited:
      break;
  }
  if (end.code == 0) return {};
  if (end.code == refused) return {Outcome::refused, end.error};
  const bool memory = end.error.find("MemoryError") != std::string::npos ||
                      end.error.find("bad_alloc") != std::string::npos ||
                      end.error.find("out of memory") != std::string::npos;
  return {Outcome::crashed,
          memory ? "out of memory" : fmt::format("exit status {}: {}", end.code, last_line(end.error))};
}

}  // namespace verify
