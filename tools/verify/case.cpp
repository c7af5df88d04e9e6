#include "verify/case.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "common/json_choice.h"
#include "common/text_file.h"
#include "strata/expression.h"
#include "strata/io.h"
#include "verify/decimal.h"
#include "verify/generate.h"
#include "verify/json_number.h"

namespace verify {
namespace {

namespace fs = std::filesystem;
using strata::InputClass;

CaseOperand read_operand(const std::string& name, const JsonLocation& place, const fs::path& folder) {
  if (place.value().is_object()) return {name, {}, {generate(place), {}}};
  const std::string file = place.text();
  const fs::path path = folder / file;
  if (!fs::path(file).is_relative() || file.find("..") != std::string::npos)
    place.fail("operands are files in the folder of the case");
  try {
    strata::MeshFile mesh = strata::read_mesh(path);
    return {name, path, {std::move(mesh.mesh), std::move(mesh.exact)}};
  } catch (const strata::IoError& error) {
    place.fail(error.what());
  }
}

/// What is generated is bounded: a short line may ask for much.
std::vector<CaseOperand> read_operands(const JsonLocation& place, const fs::path& folder) {
  constexpr std::size_t most = 1'000'000;
  std::vector<CaseOperand> operands;
  std::size_t generated = 0;
  for (const auto& [name, value] : place.value().items()) {
    const JsonLocation own = place.at(name);
    operands.push_back(read_operand(name, own, folder));
    if (operands.back().file.empty()) generated += operands.back().mesh.mesh.triangles.size();
    if (generated > most) own.fail(fmt::format("more than {} triangles are generated", most));
  }
  return operands;
}

std::optional<strata::Rational> rational_in(const JsonLocation& place, const char* key) {
  const auto member = place.find(key);
  if (!member) return {};
  const auto value = parse_rational(member->text());
  if (!value) member->fail_expected("a number as a string");
  return value;
}

std::optional<std::int64_t> integer_in(const JsonLocation& place, const char* key) {
  const auto member = place.find(key);
  if (!member) return {};
  return integer(*member, INT64_MIN, INT64_MAX);
}

Known read_known(const JsonLocation& place) {
  place.expect_keys({"volume", "area", "components", "euler", "facets", "edges", "vertices"});
  return {rational_in(place, "volume"), rational_in(place, "area"),  integer_in(place, "components"),
          integer_in(place, "euler"),   integer_in(place, "facets"), integer_in(place, "edges"),
          integer_in(place, "vertices")};
}

Steps read_steps(const JsonLocation& place) {
  try {
    return steps_of(place.text());
  } catch (const strata::ParseError& error) {
    place.fail(error.what());
  } catch (const std::invalid_argument& error) {
    place.fail(error.what());
  }
}

void check_names(const Case& c, const JsonLocation& root) {
  const auto has = [](const auto& list, const auto& matches) { return std::any_of(list.begin(), list.end(), matches); };
  for (const std::string& used : c.steps.names)
    if (!has(c.operands, [&](const CaseOperand& o) { return o.name == used; }))
      root.at("expression").fail(fmt::format("there is no operand '{}'", used));
  for (const CaseOperand& o : c.operands)
    if (!has(c.steps.names, [&](const std::string& used) { return o.name == used; }))
      root.at("operands").fail(fmt::format("the expression has no '{}'", o.name));
}

}  // namespace

bool Case::has_tag(const std::string& tag) const { return std::find(tags.begin(), tags.end(), tag) != tags.end(); }

Case read_case(const fs::path& folder) {
  Case c = parse_case(read_file((folder / "case.json").string()), folder);
  if (fs::exists(folder / "expected.json")) c.expected = read_expectation(folder / "expected.json");
  return c;
}

Case parse_case(std::string_view text, const fs::path& folder) {
  const std::string file = (folder / "case.json").string();
  const Json json = parse_json(text, file);
  const JsonLocation root(json, file);
  root.expect_keys({"operands", "expression", "tags", "why", "input", "known"});
  Case c;
  c.slug = folder.filename().string();
  c.folder = folder;
  c.expression = root.at("expression").text();
  c.steps = read_steps(root.at("expression"));
  c.why = root.at("why").text();
  for (const JsonLocation& tag : root.at("tags").items()) c.tags.push_back(tag.text());
  if (const auto input = root.find("input")) c.input = read_choice(*input, "input class", strata::all_input_classes);
  if (const auto known = root.find("known")) c.known = read_known(*known);
  const JsonLocation operands = root.at("operands");
  if (!operands.value().is_object()) operands.fail_expected("an object");
  c.operands = read_operands(operands, folder);
  check_names(c, root);
  return c;
}

std::vector<fs::path> find_cases(const fs::path& root) {
  std::vector<fs::path> folders;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(root, error))
    if (fs::exists(entry.path() / "case.json")) folders.push_back(entry.path());
  if (folders.empty()) throw strata::IoError(root.string(), {}, "no folder with a case.json is in it");
  std::sort(folders.begin(), folders.end());
  return folders;
}

}  // namespace verify
