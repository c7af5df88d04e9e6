#include "strata/section.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iostream>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/text_file.h"
#include "core/system/decimal.h"
#include "layer_stack.h"
#include "plane_option.h"
#include "section_verbs.h"
#include "verb_run.h"

namespace {

namespace planar = strata::planar;

/// The corners of all solids in the coordinates of planes.
std::array<planar::PlanePoint, 2> corners(const std::vector<strata::Solid>& solids, const strata::PlaneAxes& axes) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  planar::PlanePoint lower{infinity, infinity}, upper{-infinity, -infinity};
  for (const strata::Solid& solid : solids) {
    const strata::BoundingBox box = solid.bounding_box();
    for (const auto& [i, axis] : {std::pair{0U, axes.u}, std::pair{1U, axes.v}}) {
      lower[i] = std::min(lower[i], box.lower[axis]);
      upper[i] = std::max(upper[i], box.upper[axis]);
    }
  }
  if (!(lower[0] <= upper[0])) return {};
  return {lower, upper};
}

/// Numbers, one per line or with commas or blanks between them.
std::vector<double> read_numbers(const std::string& path) {
  const std::string text = path == "-" ? std::string(std::istreambuf_iterator<char>(std::cin), {}) : read_file(path);
  constexpr std::string_view between = " \t\r\n,;";
  std::vector<double> numbers;
  std::string_view rest = text;
  while (true) {
    rest.remove_prefix(std::min(rest.find_first_not_of(between), rest.size()));
    if (rest.empty()) return numbers;
    const std::string_view word = rest.substr(0, rest.find_first_of(between));
    double x = 0;
    const auto [end, error] = strata::system::from_chars(word.data(), word.data() + word.size(), x);
    if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(x)) {
      const auto line = 1 + std::count(text.data(), word.data(), '\n');
      throw strata::IoError(path, {static_cast<std::uint64_t>(line), {}},
                            fmt::format("expected a number, found '{}'", word));
    }
    numbers.push_back(x);
    rest.remove_prefix(word.size());
  }
}

/// Throws UsageError where the options of slice contradict one another.
void check(const SectionSettings& section, const Settings& settings) {
  if (section.step.has_value() == !section.at.empty()) throw UsageError("give either --step or --at");
  if (section.step && (!(*section.step > 0) || !std::isfinite(*section.step)))
    throw UsageError("--step must be positive");
  if (!section.at.empty() && (section.from || section.to)) throw UsageError("--from and --to go with --step");
  for (const auto& bound : {section.from, section.to})
    if (bound && !std::isfinite(*bound)) throw UsageError("--from and --to must be finite");
  if (section.at == "-" && std::count(settings.operands.begin(), settings.operands.end(), "-") > 0)
    throw UsageError("standard input cannot be both a mesh and the planes");
}

/// Where the planes are: multiples of the step from the first one, each rounded once.
std::vector<double> heights_of(const SectionSettings& section, const std::vector<strata::Solid>& solids) {
  if (!section.at.empty()) {
    std::vector<double> heights = read_numbers(section.at);
    std::sort(heights.begin(), heights.end());
    return heights;
  }
  double from = std::numeric_limits<double>::infinity(), to = -from;
  for (const strata::Solid& solid : solids) {
    const strata::BoundingBox box = solid.bounding_box();
    from = std::min(from, box.lower[section.along]);
    to = std::max(to, box.upper[section.along]);
  }
  from = section.from.value_or(from);
  to = section.to.value_or(to);
  constexpr double most = 1e7;
  if ((to - from) / *section.step > most) throw UsageError("--step makes more than ten million planes");
  std::vector<double> heights;
  const strata::Rational first = std::isfinite(from) ? strata::Rational(from) : 0, step = *section.step;
  for (std::int64_t k = 0; from < to; ++k) {
    const double height = strata::to_nearest_double(first + step * k);
    if (height >= to) break;
    heights.push_back(height);
  }
  return heights;
}

std::vector<strata::Solid> solids_of(VerbRun& run) {
  std::vector<strata::Solid> solids;
  for (std::size_t k = 0; k < run.operands().size(); ++k) solids.push_back(run.solid(k));
  return solids;
}

/// What is counted while sections are written.
struct Counts {
  std::size_t sections = 0, empty = 0, polygons = 0, vertices = 0;

  void add(const planar::Region& region) {
    ++sections;
    empty += region.empty() ? 1 : 0;
    polygons += region.polygons();
    vertices += region.loops.vertices.size();
  }
  [[nodiscard]] Json json() const {
    return {{"sections", sections}, {"empty", empty}, {"polygons", polygons}, {"vertices", vertices}};
  }
};

}  // namespace

ExitCode run_section(const SectionSettings& section, const Settings& settings) {
  const strata::Plane plane = parse_plane(section.plane);
  const strata::PlaneAxes axes = strata::axes_of(plane);
  (void)LayerStack::format_of(settings);
  VerbRun run("section", settings);
  std::vector<strata::Solid> solids;
  std::vector<planar::Region> regions;
  std::vector<strata::Rational> projected;
  run.evaluate([&](const strata::Options& options) {
    solids = solids_of(run);
    for (const strata::Solid& solid : solids) {
      regions.push_back(strata::section(solid, plane, options));
      projected.push_back(planar::area(regions.back()));
    }
  });
  run.begin_writing();
  const auto [lower, upper] = corners(solids, axes);
  LayerStack stack(settings, lower, upper);
  Counts counts;
  Json areas = Json::array();
  for (std::size_t k = 0; k < solids.size(); ++k) {
    const double area = strata::true_area(plane, projected[k]);
    counts.add(regions[k]);
    stack.add({0, section.plane, k, std::move(regions[k]), area}, {});
    areas.push_back({{"mesh", k}, {"area", area}, {"projected_area_exact", projected[k].str()}});
  }
  stack.finish();
  constexpr std::array names{"x", "y", "z"};
  Json result = counts.json();
  result["rearranged"] = stack.rearranged();
  result["axes"] = {names[axes.u], names[axes.v]};
  result["areas"] = std::move(areas);
  return run.end(std::move(result));
}

ExitCode run_slice(const SectionSettings& section, const Settings& settings) {
  check(section, settings);
  (void)LayerStack::format_of(settings);
  VerbRun run("slice", settings);
  Counts counts;
  std::size_t planes = 0;
  std::optional<LayerStack> stack;
  run.evaluate([&](const strata::Options& options) {
    const std::vector<strata::Solid> solids = solids_of(run);
    const std::vector<double> heights = heights_of(section, solids);
    planes = heights.size();
    const auto [lower, upper] = corners(solids, {(section.along + 1) % 3, (section.along + 2) % 3, section.along});
    stack.emplace(settings, lower, upper);
    const strata::Monitor monitor(options.cancel);
    for (std::size_t k = 0; k < solids.size(); ++k)
      strata::slice(
          solids[k], section.along, heights,
          [&](std::size_t plane, planar::Region region) {
            counts.add(region);
            stack->add({plane, fmt::format("{}", heights[plane] + 0.0), k, std::move(region), {}}, monitor);
          },
          options);
    stack->flush(monitor);
  });
  run.begin_writing();
  stack->finish();
  Json result = counts.json();
  result["rearranged"] = stack->rearranged();
  result["planes"] = planes;
  return run.end(std::move(result));
}
