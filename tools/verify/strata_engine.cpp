#include "verify/strata_engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "common/exit_code.h"
#include "common/sibling_program.h"
#include "strata/io.h"

namespace verify {
namespace {

namespace fs = std::filesystem;

/// The exit codes of the command line, of which only some mean what they mean for other programs.
Verdict verdict(const ChildEnd& end) {
  if (end.how != ChildEnd::How::exited) return verdict_of(end);
  if (end.code == static_cast<int>(ExitCode::invalid_input)) return {Outcome::refused, end.error};
  if (end.code == static_cast<int>(ExitCode::stopped)) return {Outcome::crashed, "out of memory"};
  return end.code == 0 ? Verdict{} : Verdict{Outcome::crashed, fmt::format("exit status {}: {}", end.code, end.error)};
}

/// What a report says of features that rounding could not keep; empty: nothing.
std::string what_collapsed(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  const auto report = nlohmann::json::parse(file, nullptr, false);
  if (report.is_discarded() || !report.contains("result")) return {};
  const auto& result = report.at("result");
  if (!result.is_object() || !result.contains("rounding") || result.at("rounding").is_null()) return {};
  const auto& rounding = result.at("rounding");
  if (!rounding.contains("exact")) return {};
  const auto number = [&](const char* which, const char* what) {
    return rounding.at(which).at(what).get<std::int64_t>();
  };
  return fmt::format("rounding: {} of {} components left, Euler characteristic {} of {}, {} faces gone",
                     number("rounded", "components"), number("exact", "components"), number("rounded", "euler"),
                     number("exact", "euler"), rounding.at("vanished_faces").get<std::uint64_t>());
}

/// What this program can be asked under a name of its own.
struct Variant {
  const char* name;
  const char* engine;  ///< as for --engine
  const char* result;
  double unit_roundoff = 0x1p-53;
  const char* script = nullptr;  ///< if given, called in place of the command line
};
constexpr std::array variants{Variant{"strata", "arrangement", "result.xoff"},
                              Variant{"strata-doubles", "arrangement", "result.off"},
                              Variant{"strata-floats", "arrangement", "result.stl", 0x1p-24},
                              Variant{"layers", "layers", "result.xoff"},
                              Variant{"strata-python", "arrangement", "result.xoff", 0x1p-53, "strata_python.py"},
                              Variant{"strata-node", "arrangement", "result.xoff", 0x1p-53, "strata_node.mjs"},
                              Variant{"strata-chromium", "arrangement", "result.xoff", 0x1p-53, "strata_chromium.mjs"}};

class StrataEngine : public Engine {
 public:
  StrataEngine(const Variant& variant, const EngineFolders& folders)
      : variant_(variant),
        program_(variant.script == nullptr ? command_line()
                                           : script_command(folders, folders.scripts / variant.script)) {}

  [[nodiscard]] std::string name() const override { return variant_.name; }
  [[nodiscard]] double unit_roundoff() const override { return variant_.unit_roundoff; }

  [[nodiscard]] Answer ask(const Case& c, const fs::path& folder, const Limits& limits) const override {
    Answer answer;
    answer.file = folder / variant_.result;
    std::vector<std::string> command = program_;
    command.insert(command.end(), {"eval", c.expression});
    for (std::string& binding : bindings_of(c, folder)) command.push_back(std::move(binding));
    for (const std::string& word :
         {std::string("-o"), answer.file.string(), std::string("--input"), std::string(strata::name(c.input)),
          std::string("--engine"), std::string(variant_.engine), std::string("-j"), std::string("1"),
          std::string("--rounding"), std::string("valid"), std::string("--report"), (folder / "report.json").string(),
          std::string("-q")})
      command.push_back(word);
    const ChildEnd end = run_child(command, limits, folder);
    answer.why_not = verdict(end);
    if (end.how == ChildEnd::How::exited && end.code == static_cast<int>(ExitCode::file) &&
        end.error.find("beyond the largest number") != std::string::npos)
      answer.why_not = {Outcome::not_applicable, "coordinates are beyond floats"};
    answer.seconds = end.seconds;
    answer.peak_bytes = end.peak_bytes;
    if (answer.why_not.outcome != Outcome::exact) {
      answer.file.clear();
    } else {
      answer.collapsed = what_collapsed(folder / "report.json");
    }
    return answer;
  }

 private:
  static std::vector<std::string> command_line() {
    const std::string program = sibling_program("strata").string();
    if (program.empty()) throw std::runtime_error("engine not installed: there is no program strata beside this one");
    return {program};
  }

  Variant variant_;
  std::vector<std::string> program_;
};

}  // namespace

std::vector<std::string> bindings_of(const Case& c, const fs::path& folder) {
  std::vector<std::string> bindings;
  for (const CaseOperand& o : c.operands) {
    fs::path file = o.file.empty() ? folder / (o.name + ".off") : fs::absolute(o.file);
    if (o.file.empty()) strata::write_mesh(file, o.mesh, strata::Format::off);
    bindings.push_back(o.name + "=" + file.string());
  }
  return bindings;
}

std::unique_ptr<Engine> make_strata_engine(const std::string& name, const EngineFolders& folders) {
  const auto* v = std::find_if(variants.begin(), variants.end(), [&](const Variant& one) { return one.name == name; });
  return v == variants.end() ? nullptr : std::make_unique<StrataEngine>(*v, folders);
}

}  // namespace verify
