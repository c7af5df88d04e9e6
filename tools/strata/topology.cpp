#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "common/stopwatch.h"
#include "common/watch.h"
#include "files.h"
#include "named_operands.h"
#include "report.h"
#include "strata/complex.h"
#include "verbs.h"

namespace {

using strata::complex::Part;
using strata::complex::SelectiveComplex;

struct Operator {
  const char* name;
  SelectiveComplex (*apply)(const SelectiveComplex&);
};

template <Part P>
SelectiveComplex part_of(const SelectiveComplex& s) {
  return part(s, P);
}

constexpr std::array operators{
    Operator{"interior", strata::complex::interior},
    Operator{"closure", strata::complex::closure},
    Operator{"boundary", strata::complex::boundary},
    Operator{"exterior", strata::complex::exterior},
    Operator{"complement", [](const SelectiveComplex& s) { return ~s; }},
    Operator{"regularized", strata::complex::regularized},
    Operator{"open-regularized", strata::complex::open_regularized},
    Operator{"membrane", strata::complex::membrane},
    Operator{"dangle", strata::complex::dangle},
    Operator{"skin", part_of<Part::skin>},
    Operator{"wound", part_of<Part::wound>},
    Operator{"hair", part_of<Part::hair>},
    Operator{"cut", part_of<Part::cut>},
    Operator{"holes", strata::complex::holes},
};

struct Operand : NamedOperand {
  bool is_open = false;
};

std::vector<Operand> operands_of(const Settings& settings) {
  std::vector<Operand> operands;
  for (NamedOperand& operand : named_operands(settings.bindings)) operands.push_back({std::move(operand)});
  for (const std::string& name : settings.open) {
    const auto at = std::find_if(operands.begin(), operands.end(), [&](const Operand& o) { return o.name == name; });
    if (at == operands.end()) throw UsageError(fmt::format("--open: there is no '{}'", name));
    at->is_open = true;
  }
  return operands;
}

bool is_complex_file(const std::string& path) { return path.ends_with(".sgc") || path.ends_with(".SGC"); }

/// Solids stand for complexes in expressions.
struct Parsed {
  strata::Expression expression;
  std::vector<std::string> names;  ///< of its primitives, in order
};

Parsed parse(const Settings& settings, const std::vector<Operand>& operands) {
  std::map<std::string, strata::Solid> solids;
  for (const Operand& o : operands) solids.emplace(o.name, strata::Solid::trusted({}));
  std::string text = settings.expression;
  if (text.empty())
    for (const Operand& o : operands) text += (text.empty() ? "" : " | ") + o.name;
  try {
    Parsed parsed{strata::parse_expression(text, [&](const std::string& name) { return solids.at(name); }), {}};
    for (const auto& p : parsed.expression.primitives()) parsed.names.push_back(p.name);
    for (const Operand& o : operands)
      if (std::find(parsed.names.begin(), parsed.names.end(), o.name) == parsed.names.end())
        throw UsageError(fmt::format("the expression has no '{}'", o.name));
    return parsed;
  } catch (const strata::ParseError& error) {
    throw UsageError(fmt::format("{}\n  {}\n  {:>{}}", error.what(), text, '^', error.position() + 1));
  }
}

/// Reads meshes as solids and complexes as they are. `settings.operands` names the meshes, for messages.
std::vector<SelectiveComplex> read(Settings& settings, const std::vector<Operand>& operands,
                                   std::vector<LoadedMesh>& meshes) {
  settings.operands.clear();
  for (const Operand& o : operands)
    if (!is_complex_file(o.path)) settings.operands.push_back(o.path);
  check_streams(settings);
  if (!settings.operands.empty()) meshes = read_operands(settings);
  std::vector<SelectiveComplex> complexes;
  std::size_t mesh = 0;
  for (const Operand& o : operands) {
    if (is_complex_file(o.path)) {
      const SelectiveComplex s = strata::complex::read_sgc(o.path);
      complexes.push_back(o.is_open ? interior(s) : s);
    } else {
      const strata::Solid solid = make_solid(meshes, mesh++, settings);
      complexes.push_back(of_solid(solid, o.is_open ? strata::complex::Border::open : strata::complex::Border::closed));
    }
  }
  return complexes;
}

SelectiveComplex evaluate(const Parsed& parsed, const std::vector<Operand>& operands,
                          const std::vector<SelectiveComplex>& complexes, const strata::Monitor& monitor) {
  std::vector<SelectiveComplex> primitives;
  for (const std::string& name : parsed.names)
    for (std::size_t k = 0; k < operands.size(); ++k)
      if (operands[k].name == name) primitives.push_back(complexes[k]);
  try {
    return strata::complex::evaluate(parsed.expression, primitives, monitor);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

SelectiveComplex operated(SelectiveComplex s, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const auto at = std::find_if(operators.begin(), operators.end(), [&](const Operator& o) { return name == o.name; });
    if (at == operators.end()) {
      std::string known;
      for (const Operator& o : operators) known += fmt::format("{}{}", known.empty() ? "" : ", ", o.name);
      throw UsageError(fmt::format("there is no operator '{}', but {}", name, known));
    }
    s = at->apply(s);
  }
  return s;
}

/// Cells of dimension 0 to 3 per part of space.
Json part_counts(const SelectiveComplex& s) {
  constexpr std::array<const char*, 6> names{"interior", "exterior", "skin", "wound", "hair", "cut"};
  std::array<std::array<std::uint32_t, 4>, 6> counts{};
  const auto parts = parts_of(s);
  for (std::uint32_t c = 0; c < parts.size(); ++c)
    ++counts[static_cast<std::size_t>(parts[c])][static_cast<std::size_t>(s.incidences().cell(c).dimension)];
  Json result = Json::object();
  for (std::size_t p = 0; p < names.size(); ++p) result[names[p]] = counts[p];
  return result;
}

/// Cells of dimension 0 to 3 about which the boundary is no manifold.
Json non_manifold_counts(const SelectiveComplex& s) {
  std::array<std::uint32_t, 4> counts{};
  for (const strata::complex::Cell& c : non_manifold_cells(s)) ++counts[static_cast<std::size_t>(c.dimension)];
  return counts;
}

Json facts(const SelectiveComplex& s) {
  const auto volume = strata::complex::volume(s);
  const auto area = strata::complex::area(s);
  return {{"dimension", s.dimension()},
          {"cells", {s.count(0), s.count(1), s.count(2), s.count(3)}},
          {"parts", part_counts(s)},
          {"incidences", s.incidences().size()},
          {"components", strata::complex::components(s).count},
          {"holes", strata::complex::count_holes(s)},
          {"bounded", s.is_bounded()},
          {"open", is_open(s)},
          {"closed", is_closed(s)},
          {"closed_regularized", is_closed_regularized(s)},
          {"open_regularized", is_open_regularized(s)},
          {"manifold", is_manifold(s)},
          {"non_manifold_cells", non_manifold_counts(s)},
          {"volume_exact", volume ? Json(volume->str()) : Json(nullptr)},
          {"area", area ? Json(*area) : Json(nullptr)},
          {"length", strata::complex::length(s)}};
}

void write(const SelectiveComplex& s, const std::string& path) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  write_sgc(text, s);
  write_text(path, text.str());
}

}  // namespace

ExitCode run_topology(Settings& settings) {
  Watch watch(settings.timeout);
  Stopwatch stopwatch;
  const std::vector<Operand> operands = operands_of(settings);
  const Parsed parsed = parse(settings, operands);
  (void)operated(SelectiveComplex(), settings.operators);  // are these all operators?
  Json report = {
      {"operation", "topology"}, {"expression", parsed.expression.text()}, {"operators", settings.operators}};
  std::vector<LoadedMesh> meshes;
  const std::vector<SelectiveComplex> complexes = read(settings, operands, meshes);
  report["operands"] = Json::array();
  for (std::size_t k = 0; k < operands.size(); ++k)
    report["operands"].push_back({{"name", operands[k].name},
                                  {"path", operands[k].path},
                                  {"border", operands[k].is_open ? "open" : "closed"},
                                  {"facts", facts(complexes[k])}});
  report["seconds"]["read"] = stopwatch.lap();

  watch.on_stop(OnStop::ask);
  SelectiveComplex result;
  try {
    result = operated(evaluate(parsed, operands, complexes, strata::Monitor(&watch.token())), settings.operators);
  } catch (const strata::Cancelled&) {
    watch.on_stop(OnStop::leave);  // says why
    throw;
  }
  report["seconds"]["evaluate"] = stopwatch.lap();
  report["result"] = facts(result);
  report["peak_bytes"] = peak_bytes();

  watch.on_stop(OnStop::finish);
  if (!settings.output.empty()) write(result, settings.output);
  if (!settings.quiet && settings.report != "-")
    for (const auto& [key, value] : report["result"].items())
      fmt::print(settings.output == "-" ? stderr : stdout, "{:18} {}\n", key, value.dump());
  if (!settings.report.empty()) write_report(settings.report, std::move(report));
  return ExitCode::ok;
}
