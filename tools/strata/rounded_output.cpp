#include "rounded_output.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "common/tell.h"
#include "files.h"
#include "strata/carry_attributes.h"

using strata::CoordinateGrid;
using strata::Format;
using strata::Rational;

namespace {

Rational power_of_ten(long exponent) {
  Rational power = 1;
  for (long i = 0; i < std::abs(exponent); ++i) power *= Rational(10);
  return exponent < 0 ? Rational(1) / power : power;
}

/// "0.001", "25.4", "1e-6"; none for other text.
std::optional<Rational> parse_decimal(std::string_view text) {
  constexpr long largest_exponent = 400;
  const std::size_t e = text.find_first_of("eE");
  long exponent = 0;
  if (e != std::string_view::npos) {
    std::string_view digits = text.substr(e + 1);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (error != std::errc{} || end != digits.data() + digits.size() || std::abs(exponent) > largest_exponent)
      return {};
  }
  std::string digits(text.substr(0, e));
  if (const std::size_t point = digits.find('.'); point != std::string::npos) {
    exponent -= static_cast<long>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  const auto integer = strata::parse_integer(digits);
  if (!integer || digits.size() > static_cast<std::size_t>(largest_exponent)) return {};
  return Rational(*integer) * power_of_ten(exponent);
}

}  // namespace

Rational parse_step(const char* option, const std::string& text) {
  const auto step = text.find('/') != std::string::npos ? strata::parse_quotient(text) : parse_decimal(text);
  const auto is_double = [](const strata::Integer& x) {
    const double nearest = strata::to_nearest_double(Rational(x));
    return std::isfinite(nearest) && Rational(nearest) == Rational(x);
  };
  if (step && *step > 0 && is_double(numerator(*step)) && is_double(denominator(*step))) return *step;
  throw UsageError(fmt::format(
      "{} {}: expected a positive number that is a quotient of two integers within doubles, as 0.001, 1e-6 or 1/1024",
      option, text));
}

std::optional<CoordinateGrid> grid_of(Format format, const Settings& settings) {
  CoordinateGrid grid;
  if (strata::holds_floats(format)) grid.format = CoordinateGrid::Format::float32;
  if (settings.grid.empty()) return format == Format::xoff ? std::nullopt : std::optional(grid);
  grid.step = parse_step("--grid", settings.grid);
  return grid;
}

Json to_json(const strata::RoundingReport& report, const strata::Mesh& mesh) {
  Json json = {{"rounds", report.rounds},
               {"vertices", mesh.vertices.size()},
               {"triangles", mesh.triangles.size()},
               {"moved_vertices", report.moved_vertices},
               {"far_vertices", report.far_vertices},
               {"largest_movement", report.largest_movement},
               {"unit", report.unit},
               {"vanished_faces", report.vanished_faces},
               {"vanished_components", report.vanished_components}};
  if (report.exact && report.rounded)
    for (const auto& [key, topology] : {std::pair("exact", &*report.exact), std::pair("rounded", &*report.rounded)})
      json[key] = {{"components", topology->components}, {"euler", topology->euler}};
  return json;
}

strata::RoundedMesh rounded_for_output(const strata::ExactMesh& exact, const CoordinateGrid& grid,
                                       const Settings& settings, const strata::CancelToken* cancel) {
  strata::Options options;
  options.threads = settings.threads;
  options.cancel = cancel;
  options.measure = !settings.report.empty();
  try {
    return strata::round_to_solid(exact, grid, options);
  } catch (const std::invalid_argument& error) {
    throw strata::IoError(settings.output, {}, error.what());
  }
}

void print_rounding(const strata::RoundingReport& report, const Settings& settings) {
  if (settings.quiet || report.rounds == 0) return;
  std::string lost;
  if (report.vanished_faces > 0) lost += fmt::format("; nothing is left of {} faces", report.vanished_faces);
  if (report.vanished_components > 0) lost += fmt::format(", nor of {} connected parts", report.vanished_components);
  tell(
      "strata: rounded faces would cross: rearranged in {} rounds; what is left moved by {:.3g} at most ({:.3g} "
      "units){}\n",
      report.rounds, report.largest_movement, report.largest_movement / report.unit, lost);
}

bool strays(const strata::RoundingReport& report) {
  constexpr double most_units = 100;  // results of real meshes: 23
  return report.largest_movement > most_units * report.unit;
}

void print_strays(const strata::RoundingReport& report) {
  fmt::print(
      stderr,
      "strata: not certified: the rounded solid is up to {:.3g} from the exact one, {:.3g} units; it was written all "
      "the same. XOFF holds the exact one; finer numbers (--grid, or a format of doubles) stay nearer\n",
      report.largest_movement, report.largest_movement / report.unit);
}

RoundedOutput rounded_output(const strata::ExactMesh& exact, const strata::Attributes& attributes, Format format,
                             const Settings& settings, const strata::CancelToken* cancel) {
  const auto grid = grid_of(format, settings);
  if (!grid || !settings.makes_solids()) return {attributes, std::nullopt, nullptr, std::nullopt};
  strata::RoundedMesh rounded = rounded_for_output(exact, *grid, settings, cancel);
  print_rounding(rounded.report, settings);
  Json report = to_json(rounded.report, rounded.mesh);
  const bool is_rounded_by_writer =
      !strata::holds_floats(format) && !rounded.report.is_rearranged && settings.grid.empty();
  std::optional<strata::RoundingReport> straying;
  if (strays(rounded.report)) straying = rounded.report;
  if (is_rounded_by_writer) return {attributes, std::nullopt, std::move(report), straying};
  strata::Attributes of_rounded;
  if (!attributes.empty()) of_rounded = strata::carry_attributes({exact, &attributes}, rounded, *grid);
  return {std::move(of_rounded), strata::ExactMesh{std::move(rounded.mesh), {}}, std::move(report), straying};
}

RoundedOutput rounded_output(const strata::RoundingReport& report, const strata::Mesh& mesh,
                             strata::Attributes attributes, const Settings& settings) {
  print_rounding(report, settings);
  RoundedOutput output{std::move(attributes), std::nullopt, to_json(report, mesh), std::nullopt};
  if (strays(report)) output.strays = report;
  return output;
}

void write_solid(const Settings& settings, Format format, const strata::ExactMesh& exact,
                 const strata::Attributes& attributes) {
  const RoundedOutput rounded = rounded_output(exact, attributes, format, settings);
  write_output(settings, format, rounded.mesh ? *rounded.mesh : exact, rounded.attributes);
  if (rounded.strays) print_strays(*rounded.strays);
}
