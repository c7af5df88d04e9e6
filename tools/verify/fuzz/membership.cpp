#include "verify/fuzz/membership.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "strata/query.h"
#include "support/random.h"

namespace fuzz {
namespace {

using strata::Vertex;
using strata::Where;

constexpr const char* words[] = {"out of", "on", "in"};

std::vector<Vertex> middles(const verify::Case& c) {
  constexpr int count = 200;
  std::vector<Vertex> vertices, points;
  for (const verify::CaseOperand& o : c.operands)
    vertices.insert(vertices.end(), o.mesh.mesh.vertices.begin(), o.mesh.mesh.vertices.end());
  strata::test::Random random(vertices.size());
  for (int n = 0; n < count && !vertices.empty(); ++n) {
    const Vertex &p = random.pick(vertices), &q = random.pick(vertices);
    points.push_back({p[0] / 2 + q[0] / 2, p[1] / 2 + q[1] / 2, p[2] / 2 + q[2] / 2});
  }
  return points;
}

bool joined(strata::Operation operation, bool a, bool b) {
  switch (operation) {
    case strata::Operation::union_:
      return a || b;
    case strata::Operation::intersection:
      return a && b;
    case strata::Operation::difference:
      return a && !b;
    case strata::Operation::symmetric_difference:
      return a != b;
  }
  throw std::invalid_argument("no operation");
}

/// Where a point off the operands should be; they are numbered as the names of the steps.
Where wanted(const verify::Steps& steps, const strata::WindingNumbers& windings) {
  std::vector<bool> values;
  for (std::uint32_t o = 0; o < steps.names.size(); ++o) values.push_back(windings[o] > 0);
  for (const verify::Step& s : steps.steps) values.push_back(joined(s.operation, values[s.first], values[s.second]));
  return values[steps.result] ? Where::in : Where::out;
}

}  // namespace

std::string misplaced_point(const verify::Case& c, const strata::ExactMesh& result) {
  const auto number_of_result = static_cast<std::uint32_t>(c.steps.names.size());
  std::vector<strata::Solid> solids;
  for (const std::string& name : c.steps.names)
    solids.push_back(strata::Solid::trusted(
        std::find_if(c.operands.begin(), c.operands.end(), [&](const auto& o) { return o.name == name; })->mesh));
  solids.push_back(strata::Solid::trusted(result));
  const strata::Locator locator(strata::scene_of(solids));
  for (const Vertex& q : middles(c)) {
    const strata::Location at = locator.locate(q);
    if (!at.contacts.empty() && at.contacts.front().solid != number_of_result) continue;
    const Where should = wanted(c.steps, at.windings);
    const Where is = !at.contacts.empty() ? Where::on : at.windings[number_of_result] > 0 ? Where::in : Where::out;
    if (is != should)
      return fmt::format("({}, {}, {}) is {} the result and should be {} it", q[0], q[1], q[2],
                         words[static_cast<std::size_t>(is)], words[static_cast<std::size_t>(should)]);
  }
  return {};
}

}  // namespace fuzz
