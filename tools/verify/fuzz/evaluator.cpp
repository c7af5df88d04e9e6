#include "verify/fuzz/evaluator.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "common/scratch.h"
#include "strata/errors.h"
#include "strata/expression.h"
#include "strata/io.h"
#include "strata/measure.h"
#include "verify/decimal.h"

namespace fuzz {
namespace {

using strata::ExactMesh;
using verify::CaseOperand;
using verify::Outcome;

class Library : public Evaluator {
 public:
  [[nodiscard]] bool is_exact() const override { return true; }
  [[nodiscard]] ExactMesh value(const std::string& expression,
                                const std::vector<CaseOperand>& operands) const override {
    return value_by_library(expression, operands, 1);
  }
};

class Foreign : public Evaluator {
 public:
  Foreign(std::unique_ptr<verify::Engine> engine, const verify::Limits& limits)
      : engine_(std::move(engine)), limits_(limits) {}

  [[nodiscard]] bool is_exact() const override { return false; }
  [[nodiscard]] double unit_roundoff() const override { return engine_->unit_roundoff(); }

  [[nodiscard]] ExactMesh value(const std::string& expression,
                                const std::vector<CaseOperand>& operands) const override {
    verify::Case c;
    c.expression = expression;
    c.steps = verify::steps_of(expression);
    for (const CaseOperand& o : operands)
      if (std::find(c.steps.names.begin(), c.steps.names.end(), o.name) != c.steps.names.end())
        c.operands.push_back({o.name, {}, o.mesh});
    if (c.steps.steps.empty()) return c.operands.at(0).mesh;
    return answer(c);
  }

 private:
  [[nodiscard]] ExactMesh answer(const verify::Case& c) const {
    const Scratch scratch;
    const verify::Answer answer = engine_->ask(c, scratch.path(), limits_);
    if (answer.file.empty()) fail(c.expression, answer.why_not);
    try {
      strata::MeshFile file = strata::read_mesh(answer.file);
      ExactMesh mesh{std::move(file.mesh), std::move(file.exact)};
      ensure_closed(c.expression, mesh);
      return mesh;
    } catch (const strata::IoError& error) {
      throw Broken("closed", fmt::format("{}: cannot be read: {}", c.expression, error.what()));
    }
  }

  [[noreturn]] static void fail(const std::string& expression, const verify::Verdict& why) {
    const std::string text = fmt::format("{}: {}", expression, why.reason);
    if (why.outcome == Outcome::timed_out) throw Broken("hang", text);
    if (why.outcome == Outcome::crashed) throw Broken("crash", text);
    throw NoQuestion(text);
  }

  static void ensure_closed(const std::string& expression, const ExactMesh& mesh) {
    if (mesh.mesh.triangles.empty()) return;
    if (const auto open = strata::topology(mesh).open_edges; open != 0)
      throw Broken("closed", fmt::format("{}: open: {} edges are not closed", expression, open));
    if (strata::volume(mesh) < 0) throw Broken("closed", fmt::format("{}: inverted", expression));
  }

  std::unique_ptr<verify::Engine> engine_;
  verify::Limits limits_;
};

}  // namespace

ExactMesh value_by_library(const std::string& expression, const std::vector<CaseOperand>& operands, unsigned threads) {
  strata::Options options;
  options.threads = threads;
  try {
    std::map<std::string, strata::Solid> solids;
    for (const CaseOperand& o : operands)
      solids.emplace(o.name, o.mesh.mesh.triangles.empty() ? strata::Solid() : strata::Solid(o.mesh));
    return strata::parse_expression(expression, [&](const std::string& name) { return solids.at(name); })
        .evaluate(options)
        .exact_mesh();
  } catch (const strata::LogicError& error) {
    throw Broken("error", fmt::format("{}: {}", expression, error.what()));
  } catch (const strata::InputError& error) {
    throw Broken("refusal", fmt::format("{}: {}", expression, error.what()));
  }
}

std::unique_ptr<Evaluator> library_evaluator() { return std::make_unique<Library>(); }

std::unique_ptr<Evaluator> engine_evaluator(const std::string& engine, const verify::EngineFolders& folders,
                                            const verify::Limits& limits) {
  return std::make_unique<Foreign>(verify::make_engine(engine, folders), limits);
}

}  // namespace fuzz
