#include "verify/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>

#include "strata/io.h"
#include "strata/measure.h"
#include "verify/decimal.h"
#include "verify/first_error.h"

namespace verify {
namespace {

using strata::ExactMesh;
using strata::Rational;

std::optional<Verdict> crossing(const ExactMesh& mesh) {
  const std::string error = first_error(mesh);
  if (error.empty()) return {};
  return Verdict{Outcome::invalid, error};
}

bool near(const Rational& a, const Rational& b, const Rational& tolerance) { return abs(Rational(a - b)) <= tolerance; }

std::string instead(const char* what, const std::string& found, const std::string& expected) {
  return fmt::format("{} {} instead of {}", what, found, expected);
}

std::optional<Verdict> wrong_measures(const ExactMesh& mesh, const Rational& volume, const Expectation& expected,
                                      const Yardstick& yardstick) {
  const Rational& d = yardstick.distance;
  const Rational count = mesh.mesh.triangles.size();
  if (!near(volume, expected.volume_near, Rational(d * expected.area + d * d * expected.form.edge_length)))
    return Verdict{Outcome::wrong, instead("volume", decimal(volume), decimal(expected.volume_near))};
  const Rational area = area_of(mesh);
  const Rational rounding = expected.area / 1'000'000'000'000;
  if (!near(area, expected.area, Rational(2 * d * expected.form.edge_length + d * d * count + rounding)))
    return Verdict{Outcome::wrong, instead("area", decimal(area), decimal(expected.area))};
  return {};
}

std::optional<Verdict> wrong_topology(const strata::Topology& t, const Expectation& expected) {
  const NonManifold& touching = expected.touching;
  if (t.components < expected.components || t.components > std::max(touching.parts, expected.components))
    return Verdict{Outcome::wrong,
                   instead("components", std::to_string(t.components), std::to_string(expected.components))};
  const auto least = expected.euler - static_cast<std::int64_t>(touching.extra_edges);
  const auto most = expected.euler + static_cast<std::int64_t>(touching.extra_vertices);
  if (t.euler < least || t.euler > most)
    return Verdict{Outcome::wrong,
                   instead("Euler characteristic", std::to_string(t.euler), std::to_string(expected.euler))};
  return {};
}

bool is_same_solid(const ExactMesh& mesh, const Rational& volume, const Expectation& expected) {
  return volume_text(volume) == expected.volume && facts_of(strata::canonical_form(mesh)).same_form(expected.form);
}

}  // namespace

Yardstick yardstick_for(const Case& c, double unit_roundoff) {
  double largest = 0;
  for (const CaseOperand& o : c.operands)
    for (const strata::Vertex& v : o.mesh.mesh.vertices)
      for (const double x : v) largest = std::max(largest, std::abs(x));
  return {Rational(256) * strata::to_rational(unit_roundoff) * strata::to_rational(largest)};
}

Verdict judge(const ExactMesh& result, const Case& c, const Yardstick& yardstick) {
  const Expectation& expected = *c.expected;
  if (result.mesh.triangles.empty())
    return expected.is_empty() ? Verdict{} : Verdict{Outcome::wrong, "the result is empty"};
  const strata::Topology topology = strata::topology(result);
  if (topology.open_edges != 0)
    return {Outcome::invalid, fmt::format("open: {} edges are not closed", topology.open_edges)};
  const Rational volume = strata::volume(result);
  if (volume < 0) return {Outcome::invalid, fmt::format("inverted: volume {}", decimal(volume))};
  if (!is_same_solid(result, volume, expected)) {
    if (expected.is_empty())
      return {Outcome::wrong, fmt::format("{} triangles, should be empty", result.mesh.triangles.size())};
    if (auto verdict = wrong_measures(result, volume, expected, yardstick)) return *verdict;
    if (auto verdict = wrong_topology(topology, expected)) return *verdict;
    if (auto verdict = crossing(result)) return *verdict;
    return {Outcome::rounded, "right within rounding"};
  }
  if (auto verdict = crossing(result)) return *verdict;
  return {};
}

Verdict judge_file(const std::filesystem::path& file, const Case& c, const Yardstick& yardstick) {
  ExactMesh mesh;
  try {
    strata::MeshFile read = strata::read_mesh(file);
    mesh = {std::move(read.mesh), std::move(read.exact)};
  } catch (const strata::IoError& error) {
    return {Outcome::invalid, std::string("cannot be read: ") + error.what()};
  }
  try {
    return judge(mesh, c, yardstick);
  } catch (const std::exception& error) {
    return {Outcome::oracle_failed, std::string("the judge failed: ") + error.what()};
  }
}

}  // namespace verify
