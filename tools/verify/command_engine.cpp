#include "verify/command_engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "strata/io.h"

namespace verify {
namespace {

namespace fs = std::filesystem;

constexpr int no_such_operation = 5;

class CommandEngine : public Engine {
 public:
  CommandEngine(std::string name, std::vector<std::string> command, double unit_roundoff)
      : name_(std::move(name)), command_(std::move(command)), unit_roundoff_(unit_roundoff) {
    // Processes run elsewhere: what is a file here must be found from there.
    for (std::string& word : command_)
      if (word.find('/') != std::string::npos && fs::exists(word)) word = fs::absolute(word).string();
  }

  [[nodiscard]] std::string name() const override { return name_; }
  [[nodiscard]] double unit_roundoff() const override { return unit_roundoff_; }

  [[nodiscard]] Answer ask(const Case& c, const fs::path& folder, const Limits& limits) const override {
    for (const CaseOperand& o : c.operands)
      if (!o.mesh.exact.empty()) return {{}, {Outcome::not_applicable, "operands have rational coordinates"}};
    if (c.steps.steps.empty()) return {{}, {Outcome::not_applicable, "the case has no operation with two operands"}};
    return run(c, write_operands(c, folder), folder, limits);
  }

 private:
  static std::vector<fs::path> write_operands(const Case& c, const fs::path& folder) {
    std::vector<fs::path> files;
    for (const std::string& name : c.steps.names) {
      files.push_back(folder / (name + ".off"));
      const auto o = std::find_if(c.operands.begin(), c.operands.end(), [&](const auto& x) { return x.name == name; });
      strata::write_mesh(files.back(), strata::MeshView(o->mesh.mesh), strata::Format::off);
    }
    return files;
  }

  [[nodiscard]] Answer run(const Case& c, std::vector<fs::path> files, const fs::path& folder,
                           const Limits& limits) const {
    Answer answer;
    for (std::size_t k = 0; k < c.steps.steps.size(); ++k) {
      const Step& step = c.steps.steps[k];
      files.push_back(folder / fmt::format("step-{}.off", k + 1));
      Limits left = limits;
      left.seconds = std::max(limits.seconds - answer.seconds, 0.0);
      std::vector<std::string> command = command_;
      command.insert(command.end(), {strata::name(step.operation), files[step.first].string(),
                                     files[step.second].string(), files.back().string()});
      const ChildEnd end = run_child(command, left, folder);
      answer.seconds += end.seconds;
      answer.peak_bytes = std::max(answer.peak_bytes, end.peak_bytes);
      answer.why_not = verdict(end, files.back(), k, c.steps.steps.size());
      if (answer.why_not.outcome != Outcome::exact) return answer;
    }
    answer.file = files[c.steps.result];
    return answer;
  }

  static Verdict verdict(const ChildEnd& end, const fs::path& result, std::size_t k, std::size_t count) {
    Verdict v = verdict_of(end);
    if (end.how == ChildEnd::How::exited && end.code == no_such_operation)
      v = {Outcome::not_applicable, end.error};
    else if (v.outcome == Outcome::exact && !fs::exists(result))
      v = {Outcome::crashed, "it wrote no file"};
    if (v.outcome != Outcome::exact && count > 1) v.reason = fmt::format("step {} of {}: {}", k + 1, count, v.reason);
    return v;
  }

  std::string name_;
  std::vector<std::string> command_;
  double unit_roundoff_;
};

}  // namespace

std::unique_ptr<Engine> make_command_engine(std::string name, std::vector<std::string> command, double unit_roundoff) {
  return std::make_unique<CommandEngine>(std::move(name), std::move(command), unit_roundoff);
}

}  // namespace verify
