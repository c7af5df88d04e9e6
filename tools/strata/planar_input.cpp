#include "planar_input.h"

#include <iostream>
#include <iterator>
#include <optional>

#include "common/tell.h"
#include "strata/rational.h"

using namespace strata::planar;

namespace {

std::optional<PlanarFormat> format_asked(const std::string& name) {
  if (name.empty()) return std::nullopt;
  const auto format = planar_format_named(name);
  if (!format) throw UsageError(fmt::format("unknown format {}: wkt, geojson and svg are known", name));
  return format;
}

/// Sums of rational vertices grow with their number: beyond this many, areas in reports are those of the rounded
/// vertices.
constexpr std::size_t most_exact = 20000;

PlanarFile read_operand(const std::string& path, const Settings& settings) {
  const auto format = format_asked(settings.input_format);
  PlanarFile file;
  if (path == "-") {
    const std::string bytes{std::istreambuf_iterator<char>(std::cin), {}};
    file = read_planar(bytes, *format, "standard input");
  } else {
    file = read_planar(path, format);
  }
  if (!settings.quiet)
    for (const std::string& note : file.notes) tell("strata: {}: note: {}\n", path, note);
  return file;
}

}  // namespace

std::vector<PlanarFile> read_files(const Settings& settings) {
  std::vector<PlanarFile> files;
  for (const std::string& path : settings.operands) files.push_back(read_operand(path, settings));
  return files;
}

PlanarFormat output_format_of(const Settings& settings) {
  if (const auto format = format_asked(settings.output_format)) return *format;
  if (const auto format = planar_format_of(settings.output)) return *format;
  throw UsageError(fmt::format("{}: no known extension: give --format wkt, geojson or svg", settings.output));
}

Json region_facts(const Region& region) {
  std::uint32_t holes = 0, simple = 0, manifold = 0;
  for (std::uint32_t p = 0; p < region.polygons(); ++p) {
    const PolygonKind kind = kind_of(region, p);
    holes += region.holes(p);
    simple += kind.is_simple() ? 1 : 0;
    manifold += kind.is_manifold ? 1 : 0;
  }
  const std::size_t constructed = region.loops.places.meets.size();
  Json j = {{"polygons", region.polygons()},
            {"holes", holes},
            {"simple", simple},
            {"manifold", manifold},
            {"vertices", region.loops.vertices.size()},
            {"constructed_points", constructed},
            {"area", nullptr},
            {"area_exact", nullptr}};
  if (constructed <= most_exact) {
    const strata::Rational exact = area(region);
    j["area"] = strata::to_nearest_double(exact);
    j["area_exact"] = exact.str();
  } else {
    Loops rounded;
    rounded.places.place = region.loops.places.place;
    rounded.vertices = region.loops.vertices;
    rounded.first_vertex = region.loops.first_vertex;
    j["area"] = strata::to_nearest_double(twice_area(rounded) / 2);
  }
  return j;
}

FillRule fill_rule(const PlanarSettings& planar) {
  if (planar.fill == "even-odd") return FillRule::even_odd;
  if (planar.fill == "positive") return FillRule::positive;
  return planar.fill == "negative" ? FillRule::negative : FillRule::nonzero;
}

Json place(const RationalPlacement& p) {
  Json xy = Json::array();
  for (const strata::Rational& x : p) {
    const double nearest = strata::to_nearest_double(x);
    xy.push_back(strata::to_rational(nearest) == x ? Json(nearest) : Json(x.str()));
  }
  return xy;
}

Json operand_facts(const Settings& settings, const std::vector<PlanarFile>& files) {
  Json list = Json::array();
  for (std::size_t i = 0; i < files.size(); ++i)
    list.push_back({{"path", settings.operands[i]},
                    {"loops", files[i].loops.size()},
                    {"vertices", files[i].loops.vertices.size()}});
  return list;
}

void print_facts(const Json& result, const Settings& settings) {
  if (settings.quiet || settings.report == "-") return;
  for (const auto& [key, value] : result.items())
    fmt::print(settings.output == "-" ? stderr : stdout, "{:18} {}\n", key, value.dump());
}
