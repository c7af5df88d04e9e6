#include "verify/fuzz/laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "common/json_location.h"
#include "common/scratch.h"
#include "common/text_file.h"
#include "strata/bsp.h"
#include "strata/errors.h"
#include "strata/incremental.h"
#include "strata/io.h"
#include "strata/measure.h"
#include "strata/solid.h"
#include "support/transform.h"
#include "verify/child.h"
#include "verify/decimal.h"
#include "verify/facts.h"
#include "verify/first_error.h"
#include "verify/fuzz/membership.h"
#include "verify/fuzz/step_text.h"
#include "verify/judge.h"
#include "verify/strata_engine.h"

namespace fuzz {
namespace {

using strata::ExactMesh;
using strata::Rational;
using strata::test::Affine;
using verify::CaseOperand;
using Operands = std::vector<CaseOperand>;
using Partition = strata::bsp::Partition<3>;

strata::Options one_thread() {
  strata::Options options;
  options.threads = 1;
  return options;
}

/// Vertices and triangles backwards, triangles from another corner on.
ExactMesh relisted(const ExactMesh& mesh) {
  if (mesh.exact.empty()) return {strata::test::relisted(mesh.mesh), {}};
  std::vector<strata::RationalPoint> points;
  for (auto v = static_cast<std::uint32_t>(mesh.mesh.vertices.size()); v-- > 0;) points.push_back(mesh.position(v));
  return strata::test::exact_mesh(points, strata::test::relisted(mesh.mesh).triangles);
}

ExactMesh reloaded(const ExactMesh& mesh) {
  const std::string bytes = strata::to_string(mesh, strata::Format::xoff);
  strata::MeshFile file = strata::read_mesh(std::string_view(bytes), strata::Format::xoff, "a result");
  return {std::move(file.mesh), std::move(file.exact)};
}

Operands each(Operands operands, const auto& change) {
  for (CaseOperand& o : operands) o.mesh = change(o.mesh);
  return operands;
}

Rational power_of_two(int exponent) {
  const strata::Integer power = strata::Integer(1) << std::abs(exponent);
  return exponent >= 0 ? Rational(power) : Rational(strata::Integer(1), power);
}

/// The exponent of the largest coordinate.
int exponent_of(const Operands& operands) {
  double largest = 0;
  for (const CaseOperand& o : operands)
    for (const strata::Vertex& v : o.mesh.mesh.vertices)
      for (const double x : v) largest = std::max(largest, std::abs(x));
  return largest > 0 ? std::ilogb(largest) : 0;
}

/// Checks of one case with one engine.
class Laws {
 public:
  Laws(const verify::Case& c, const Evaluator& engine, const Oracle& oracle)
      : case_(c), engine_(engine), oracle_(oracle) {
    const verify::Steps& steps = c.steps;
    const bool is_joint = steps.result >= steps.names.size();
    const verify::Step last = is_joint ? steps.steps[steps.result - steps.names.size()] : verify::Step{};
    a_ = step_text(steps, is_joint ? last.first : steps.result);
    b_ = step_text(steps, is_joint ? last.second : steps.result);
    whole_ = step_text(steps, steps.result);
  }

  void embedded() {
    if (!engine_.is_exact()) return;
    for (const std::string& text : {whole_, joint('|'), joint('&'), joint('-'), joint('^')})
      if (const std::string why = verify::first_error(value(text)); !why.empty())
        throw Broken("embedded", fmt::format("{}: {}", text, why));
  }

  void volumes() {
    const auto volume = [&](const std::string& text) { return strata::volume(value(text)); };
    const Rational apart = volume(a_) + volume(b_), together = volume(joint('|')) + volume(joint('&'));
    if (!near(apart, together, tolerance(case_.operands)))
      throw Broken("volumes",
                   fmt::format("volumes of {} and {} add up to {}, those of their union and intersection to {}", a_, b_,
                               verify::decimal(apart), verify::decimal(together)));
  }

  void commutativity() {
    for (const char sign : {'|', '&', '^'}) expect("commutativity", joint(sign), fmt::format("{} {} {}", b_, sign, a_));
  }

  void idempotence() {
    for (const char sign : {'|', '&'}) expect("idempotence", fmt::format("{} {} {}", whole_, sign, whole_), whole_);
    expect("idempotence", fmt::format("{} - {}", whole_, whole_), {});
  }

  void de_morgan() {
    const std::string u = "(" + joint('|') + ")";
    expect("de-morgan", fmt::format("{} - ({})", u, joint('&')), fmt::format("({} - {}) | ({} - {})", u, a_, u, b_));
  }

  void differences() {
    expect("differences", fmt::format("({}) - {}", joint('|'), b_), joint('-'));
    expect("differences", joint('^'), fmt::format("({}) | ({} - {})", joint('-'), b_, a_));
  }

  void steps() {
    if (!engine_.is_exact()) return;
    std::vector<ExactMesh> values;
    for (const std::string& name : case_.steps.names) values.push_back(operand(name));
    for (const verify::Step& step : case_.steps.steps) {
      values.push_back(combined(step.operation, values[step.first], values[step.second]));
      if (const std::string why = verify::first_error(values.back()); !why.empty())
        throw Broken("steps", fmt::format("step {}: {}", values.size() - case_.steps.names.size(), why));
    }
    ensure_same("steps", "step by step", values[case_.steps.result], "at once", value(whole_), case_.operands);
  }

  void operand_order() { expect("operand-order", step_text(case_.steps, case_.steps.result, Order::swapped), whole_); }

  void face_order() { expect_image("face-order", each(case_.operands, relisted), value(whole_)); }

  void axes() { expect_mapped("axes", {{{{0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, 0}}}}); }

  void scaling() {
    const Rational s = power_of_two(exponent_of(case_.operands) > 500 ? -3 : 3);
    expect_mapped("scaling", {{{{s, 0, 0}, {0, s, 0}, {0, 0, s}, {0, 0, 0}}}});
  }

  void translation() {
    const Rational s = power_of_two(exponent_of(case_.operands));
    expect_mapped("translation", {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {s, Rational(-2 * s), Rational(3 * s)}}}});
  }

  void membership() {
    if (!engine_.is_exact()) return;
    if (const std::string why = misplaced_point(case_, value(whole_)); !why.empty())
      throw Broken("membership", fmt::format("{}: {}", whole_, why));
  }

  void threads() {
    if (!engine_.is_exact()) return;
    const ExactMesh other = value_by_library(whole_, case_.operands, 2);
    const auto bytes = [](const ExactMesh& mesh) { return strata::to_string(mesh, strata::Format::xoff); };
    if (bytes(other) != bytes(value(whole_)))
      throw Broken("threads", fmt::format("{}: two threads write another mesh than one", whole_));
  }

  void solid_in_steps() {
    if (!engine_.is_exact()) return;
    const strata::IncrementalSolid a(strata::Solid::trusted(value(a_)));
    const strata::Solid b = strata::Solid::trusted(value(b_));
    for (const strata::Operation operation : strata::all_operations)
      ensure_same("workpiece", fmt::format("{} of a workpiece", name(operation)),
                  step(a, operation, b).solid().exact_mesh(), "at once", value(joint(sign(operation))), case_.operands);
    const strata::IncrementalSolid twice =
        step(step(a, strata::Operation::symmetric_difference, b), strata::Operation::symmetric_difference, b);
    ensure_same("workpiece", "a workpiece after two equal xors", twice.solid().exact_mesh(), a_, value(a_),
                case_.operands);
  }

  void partitions() {
    constexpr std::size_t most_faces = 400;  // trees of many slivers are large
    std::size_t faces = 0;
    for (const CaseOperand& o : case_.operands) faces += o.mesh.mesh.triangles.size();
    if (!engine_.is_exact() || faces > most_faces) return;
    std::vector<Partition> values;
    for (const std::string& operand_name : case_.steps.names)
      values.push_back(strata::bsp::partition_of(strata::Solid(operand(operand_name)).exact_mesh()));
    for (const verify::Step& s : case_.steps.steps)
      values.push_back(strata::bsp::combined(s.operation, values[s.first], values[s.second]));
    const Partition& merged = values[case_.steps.result];
    ensure_same("partitions", "the merged tree of the expression", strata::bsp::exact_mesh_of(merged), whole_,
                value(whole_), case_.operands);
    ensure_same("partitions", "its tree built anew", strata::bsp::exact_mesh_of(strata::bsp::rebuilt(merged)), whole_,
                value(whole_), case_.operands);
  }

  void reload() {
    if (!engine_.is_exact() || case_.steps.steps.empty()) return;
    const verify::Step last = case_.steps.steps[case_.steps.result - case_.steps.names.size()];
    const ExactMesh again = combined(last.operation, reloaded(value(a_)), reloaded(value(b_)));
    ensure_same("reload", "from files", reloaded(again), "at once", value(whole_), case_.operands);
  }

  void ask_oracle() {
    constexpr std::size_t most_steps = 6, most_faces = 150;
    std::size_t faces = 0;
    for (const CaseOperand& o : case_.operands) faces += o.mesh.mesh.triangles.size();
    if (oracle_.program.empty() || case_.steps.steps.size() > most_steps || faces > most_faces) return;
    const Scratch scratch;
    const std::filesystem::path out = scratch.path() / "oracle.json";
    std::vector<std::string> command = {oracle_.program.string(), case_.expression, out.string()};
    for (std::string& binding : verify::bindings_of(case_, scratch.path())) command.push_back(std::move(binding));
    const verify::ChildEnd end = verify::run_child(command, oracle_.limits, scratch.path());
    if (end.how != verify::ChildEnd::How::exited || end.code != 0) return;  // it does not know either
    compare_with(out);
  }

 private:
  /// Errors of the library are findings.
  static strata::IncrementalSolid step(const strata::IncrementalSolid& solid_in_steps, strata::Operation operation,
                                       const strata::Solid& tool) try {
    return solid_in_steps.with(operation, tool, one_thread());
  } catch (const strata::LogicError& error) {
    throw Broken("error", error.what());
  } catch (const strata::InputError& error) {
    throw Broken("refusal", error.what());
  }

  [[nodiscard]] std::string joint(char sign) const { return fmt::format("{} {} {}", a_, sign, b_); }

  [[nodiscard]] const ExactMesh& operand(const std::string& name) const {
    const auto is_it = [&](const CaseOperand& o) { return o.name == name; };
    return std::find_if(case_.operands.begin(), case_.operands.end(), is_it)->mesh;
  }

  /// Of the operands as they are; every text is evaluated once.
  const ExactMesh& value(const std::string& text) {
    const auto known = values_.find(text);
    if (known != values_.end()) return known->second;
    return values_.emplace(text, engine_.value(text, case_.operands)).first->second;
  }

  [[nodiscard]] ExactMesh combined(strata::Operation operation, const ExactMesh& a, const ExactMesh& b) const {
    return engine_.value(fmt::format("a {} b", sign(operation)), {{"a", {}, a}, {"b", {}, b}});
  }

  /// What volumes may differ by: 0 for exact engines. Every surface on the way is part of the operands' surfaces, so a
  /// step moves volume by no more than the yardstick's distance times their area. No law takes more than four times
  /// the steps of the expression and four more.
  [[nodiscard]] Rational tolerance(const Operands& operands) const {
    if (engine_.is_exact()) return 0;
    verify::Case c;
    c.operands = operands;
    Rational area = 0;
    for (const CaseOperand& o : operands) area += verify::area_of(o.mesh);
    const auto steps = static_cast<std::int64_t>(4 * case_.steps.steps.size() + 4);
    return verify::yardstick_for(c, engine_.unit_roundoff()).distance * area * steps * steps;
  }

  static bool near(const Rational& a, const Rational& b, const Rational& tolerance) {
    return abs(Rational(a - b)) <= tolerance;
  }

  void ensure_same(const char* law, const std::string& left_name, const ExactMesh& left, const std::string& right_name,
                   const ExactMesh& right, const Operands& operands) const {
    const Rational v = strata::volume(left), w = strata::volume(right);
    const bool same = engine_.is_exact() ? strata::Solid::trusted(left) == strata::Solid::trusted(right)
                                         : near(v, w, tolerance(operands));
    if (!same)
      throw Broken(law, fmt::format("{} is another solid than {}: volume {}, not {}", left_name, right_name,
                                    verify::decimal(v), verify::decimal(w)));
  }

  /// Two expressions have the same value; an empty text stands for nothing at all.
  void expect(const char* law, const std::string& left, const std::string& right) {
    const ExactMesh nothing;
    ensure_same(law, left, value(left), right.empty() ? "nothing" : right, right.empty() ? nothing : value(right),
                case_.operands);
  }

  /// The expression of other operands has this value.
  void expect_image(const char* law, const Operands& operands, const ExactMesh& image) const {
    const bool is_rational =
        std::any_of(operands.begin(), operands.end(), [](const CaseOperand& o) { return !o.mesh.exact.empty(); });
    if (is_rational && !engine_.is_exact()) return;
    ensure_same(law, fmt::format("{} of what was changed", whole_), engine_.value(whole_, operands), "the result",
                image, operands);
  }

  void expect_mapped(const char* law, const Affine& map) {
    const auto image = [&](const ExactMesh& mesh) { return strata::test::mapped(mesh, map); };
    expect_image(law, each(case_.operands, image), image(value(whole_)));
  }

  void compare_with(const std::filesystem::path& file) {
    const Json json = parse_json(read_file(file.string()), file.string());
    const JsonLocation root(json, file.string());
    const std::string volume = root.at("volume").text();
    const ExactMesh& mesh = value(whole_);
    if (!engine_.is_exact()) {
      const auto right = verify::parse_rational(volume);
      if (!right || near(strata::volume(mesh), *right, tolerance(case_.operands))) return;
    } else if (volume == verify::volume_text(strata::volume(mesh)) &&
               root.at("hash").text() == fmt::format("{:016x}", verify::facts_of(strata::canonical_form(mesh)).hash)) {
      return;
    }
    throw Broken("oracle", fmt::format("the oracle has another solid: volume {}, not {}", volume,
                                       verify::decimal(strata::volume(mesh))));
  }

  const verify::Case& case_;
  const Evaluator& engine_;
  const Oracle& oracle_;
  std::string a_, b_, whole_;
  std::map<std::string, ExactMesh> values_;
};

using Law = void (Laws::*)();
constexpr std::array<std::pair<const char*, Law>, 17> all_laws{{{"embedded", &Laws::embedded},
                                                                {"volumes", &Laws::volumes},
                                                                {"commutativity", &Laws::commutativity},
                                                                {"idempotence", &Laws::idempotence},
                                                                {"de-morgan", &Laws::de_morgan},
                                                                {"differences", &Laws::differences},
                                                                {"steps", &Laws::steps},
                                                                {"operand-order", &Laws::operand_order},
                                                                {"face-order", &Laws::face_order},
                                                                {"axes", &Laws::axes},
                                                                {"scaling", &Laws::scaling},
                                                                {"translation", &Laws::translation},
                                                                {"membership", &Laws::membership},
                                                                {"threads", &Laws::threads},
                                                                {"workpiece", &Laws::solid_in_steps},
                                                                {"partitions", &Laws::partitions},
                                                                {"reload", &Laws::reload}}};

}  // namespace

const std::vector<std::string>& check_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const auto& [name, law] : all_laws) list.emplace_back(name);
    list.emplace_back("oracle");
    return list;
  }();
  return names;
}

void ensure_laws(const verify::Case& c, const Evaluator& engine, const Oracle& oracle, const std::string& only) {
  for (const CaseOperand& o : c.operands)
    if (const std::string why = verify::first_error(o.mesh); !why.empty())
      throw NoQuestion(fmt::format("{} is no solid: {}", o.name, why));
  const auto& names = check_names();
  const bool all = std::find(names.begin(), names.end(), only) == names.end();
  Laws laws(c, engine, oracle);
  for (const auto& [name, law] : all_laws)
    if (all || only == name) (laws.*law)();
  if (all || only == "oracle") laws.ask_oracle();
}

}  // namespace fuzz
