#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "oracle/isolated.h"
#include "oracle/nef.h"
#include "strata/io.h"
#include "verify/facts.h"
#include "verify/steps.h"

// strata-oracle EXPRESSION OUT.json NAME=FILE...: the volume and the canonical form of an expression by CGAL's Nef
// polyhedra. Its ways to an answer are tried until two agree; where they contradict one another, or fewer than two have
// an answer, it has failed (exit status 3, and the reason on standard error).
namespace {

using strata::ExactMesh;
using strata::oracle::NefSolid;
using strata::oracle::OracleFailed;
using strata::oracle::Way;

constexpr int failed = 3, usage = 2;

ExactMesh read(const std::string& path) {
  strata::MeshFile file = strata::read_mesh(path);
  return {std::move(file.mesh), std::move(file.exact)};
}

/// What expected.json has of a solid that the oracle can tell.
std::string answer(const verify::Steps& steps, const std::map<std::string, std::string>& paths, Way way) {
  std::vector<NefSolid> values;
  for (const std::string& name : steps.names) values.emplace_back(read(paths.at(name)));
  for (const verify::Step& step : steps.steps) {
    const std::array<NefSolid, 2> operands = {values.at(step.first), values.at(step.second)};
    values.push_back(nef_combine(step.operation, operands, way));
  }
  const auto facets = values.at(steps.result).facets();
  const auto form = verify::facts_of(strata::canonical_form(facets));
  return fmt::format("{{\"volume\": \"{}\", \"vertices\": {}, \"edges\": {}, \"facets\": {}, \"hash\": \"{:016x}\"}}\n",
                     verify::volume_text(strata::oracle::facet_volume(facets)), form.vertices, form.edges, form.facets,
                     form.hash);
}

/// The answer that two ways agree on; CGAL crashes on some, hence the child processes.
std::string agreed(const std::function<std::string(Way)>& ask) {
  std::vector<std::string> answers;
  std::string complaints;
  for (const Way way : {Way::in_order, Way::backwards, Way::other_formula, Way::regularized}) {
    try {
      answers.push_back(strata::oracle::in_child([&] { return ask(way); }, 600));
    } catch (const OracleFailed& error) {
      complaints += std::string(error.what()) + "; ";
      continue;
    }
    if (answers.back() != answers.front()) throw OracleFailed("its ways contradict one another");
    if (answers.size() == 2) return answers.front();
  }
  throw OracleFailed("no two of its ways have an answer: " + complaints);
}

std::map<std::string, std::string> bindings(int count, char** arguments) {
  std::map<std::string, std::string> paths;
  for (int k = 0; k < count; ++k) {
    const std::string text = arguments[k];
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) throw std::invalid_argument("expected NAME=FILE, found " + text);
    paths[text.substr(0, equals)] = text.substr(equals + 1);
  }
  return paths;
}

int run(int count, char** arguments) {
  const verify::Steps steps = verify::steps_of(arguments[1]);
  const auto paths = bindings(count - 3, arguments + 3);
  std::ofstream out(arguments[2]);
  out << agreed([&](Way way) { return answer(steps, paths, way); });
  out.close();
  if (!out) throw std::runtime_error(std::string("cannot write ") + arguments[2]);
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 4) {
    std::fputs("usage: strata-oracle EXPRESSION OUT.json NAME=FILE...\n", stderr);
    return usage;
  }
  try {
    return run(count, arguments);
  } catch (const std::exception& error) {
    std::fputs((std::string(error.what()) + "\n").c_str(), stderr);
    return failed;
  }
}
