#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <mutex>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "common/progress.h"
#include "common/stopwatch.h"
#include "common/watch.h"
#include "contact_file.h"
#include "files.h"
#include "report.h"
#include "rounded_output.h"
#include "threads.h"
#include "verbs.h"

namespace {

using strata::Rational;
using strata::RationalPoint;
using strata::contact::Assembly;
using strata::contact::ContactRegion;
using strata::contact::MeshFeature;
using strata::contact::RelatedPair;
using strata::contact::Relation;

bool is_picture(const std::string& path) { return path.ends_with(".glb") || path.ends_with(".GLB"); }

void check_output(const Settings& settings) {
  if (!settings.output.empty() && settings.output != "-" && !is_picture(settings.output) &&
      strata::format_of(settings.output) != strata::Format::ply)
    throw UsageError(
        fmt::format("contacts are written as PLY or glTF; give {} the extension .ply or .glb", settings.output));
  if (!settings.output_format.empty() && settings.overlaps.empty())
    throw UsageError("--format is for the files of --overlap");
  if (!settings.output_format.empty()) (void)output_format(settings);  // is there such a one?
  if (settings.within && !(*settings.within >= 0)) throw UsageError("--within wants a distance, 0 or more");
  std::error_code unknown;
  const std::filesystem::path folder = settings.overlaps;
  if (settings.overlaps.empty() || !std::filesystem::exists(folder, unknown)) return;
  if (!std::filesystem::is_directory(folder, unknown))
    throw UsageError(fmt::format("{} is a file; overlaps go into a folder", settings.overlaps));
  if (!std::filesystem::is_empty(folder, unknown))
    throw UsageError(
        fmt::format("the folder {} is not empty: overlaps of different parts would mix", settings.overlaps));
}

/// How far parts may be apart to be listed; nothing where only those are that are not apart.
std::optional<double> reach_of(const Settings& settings) {
  if (settings.within) return settings.within;
  if (settings.distances) return std::numeric_limits<double>::infinity();
  return std::nullopt;
}

/// All pairs that are not apart, and the others that may be within reach.
std::vector<PairFacts> listed_pairs(const Assembly& parts, const std::vector<RelatedPair>& related,
                                    std::optional<double> reach) {
  std::vector<PairFacts> pairs;
  if (!reach) {
    for (const RelatedPair& pair : related) pairs.push_back({pair});
    return pairs;
  }
  auto next = related.begin();
  for (const auto& [a, b] : parts.near_pairs(*reach)) {
    const bool is_related = next != related.end() && next->a == a && next->b == b;
    pairs.push_back({is_related ? *next++ : RelatedPair{a, b, Relation::apart}});
  }
  return pairs;
}

/// Pairs within reach by their boxes that are not.
void erase_farther(std::vector<PairFacts>& pairs, double reach) {
  if (std::isinf(reach)) return;
  const Rational exact = strata::to_rational(reach), squared = exact * exact;
  std::erase_if(pairs, [&](const PairFacts& facts) {
    return facts.pair.relation == Relation::apart && facts.nearest.squared > squared;
  });
}

void find_facts(const Assembly& parts, std::vector<PairFacts>& pairs, const strata::Monitor& monitor) {
  std::size_t done = 0;
  std::mutex mutex;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pairs.size(), 1), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      monitor.check();
      const auto [a, b, relation] = pairs[i].pair;
      switch (relation) {
        case Relation::apart:
          pairs[i].nearest = parts.nearest(a, b);
          break;
        case Relation::contact:
          pairs[i].region = parts.contact_region(a, b);
          break;
        case Relation::interfering:
          pairs[i].overlap = parts.overlap(a, b);
          if (pairs[i].overlap.is_empty())
            throw UsageError(fmt::format("one of the parts {} and {} crosses itself; give --input overlapping", a, b));
          break;
      }
      const std::lock_guard lock(mutex);
      monitor.report(0.5 + 0.5 * static_cast<double>(++done) / static_cast<double>(pairs.size()));
    }
  });
}

/// A coordinate: a number, or a fraction as text where doubles are not exact.
Json coordinate(const Rational& x) {
  const double nearest = strata::to_nearest_double(x);
  return std::isfinite(nearest) && strata::to_rational(nearest) == x ? Json(nearest) : Json(x.str());
}
Json place(const RationalPoint& p) { return {coordinate(p[0]), coordinate(p[1]), coordinate(p[2])}; }

Json region_report(const ContactRegion& region) {
  Json facets = Json::array(), edges = Json::array(), vertices = Json::array();
  for (const auto& f : region.facets) {
    Json loops = Json::array();
    for (const auto& loop : f.loops) {
      Json& corners = loops.emplace_back(Json::array());
      for (const std::uint32_t p : loop) corners.push_back(place(region.points[p]));
    }
    Json vector = Json::array();
    for (const Rational& x : f.area_vector) vector.push_back(x.str());
    facets.push_back({{"area", f.area},
                      {"squared_area_exact", f.squared_area.str()},
                      {"area_vector_exact", std::move(vector)},
                      {"loops", std::move(loops)}});
  }
  for (const auto& e : region.edges)
    edges.push_back({{"length", e.length},
                     {"squared_length_exact", e.squared_length.str()},
                     {"ends", {place(region.points[e.ends[0]]), place(region.points[e.ends[1]])}}});
  for (const std::uint32_t v : region.vertices) vertices.push_back(place(region.points[v]));
  return {{"area", region.area()},
          {"length", region.length()},
          {"facets", std::move(facets)},
          {"edges", std::move(edges)},
          {"vertices", std::move(vertices)}};
}

Json witness(const RationalPoint& p, const MeshFeature& feature) {
  Json vertices = Json::array();
  for (std::size_t i = 0; i <= static_cast<std::size_t>(feature.kind); ++i) vertices.push_back(feature.vertices[i]);
  return {{"at", place(p)}, {"on", name(feature.kind)}, {"vertices", std::move(vertices)}};
}

Json pair_report(const PairFacts& facts) {
  Json report = {{"a", facts.pair.a}, {"b", facts.pair.b}, {"relation", name(facts.pair.relation)}};
  switch (facts.pair.relation) {
    case Relation::apart:
      report["distance"] = facts.nearest.distance;
      report["squared_distance_exact"] = facts.nearest.squared.str();
      report["witnesses"] = {witness(facts.nearest.on_a, facts.nearest.feature_a),
                             witness(facts.nearest.on_b, facts.nearest.feature_b)};
      break;
    case Relation::contact:
      report.update(region_report(facts.region));
      break;
    case Relation::interfering: {
      const Rational volume = facts.overlap.volume();
      report["volume"] = strata::to_nearest_double(volume);
      report["volume_exact"] = volume.str();
      break;
    }
  }
  return report;
}

void write_overlaps(std::vector<PairFacts>& pairs, Json& reports, const Settings& settings) {
  const std::filesystem::path folder = settings.overlaps;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw strata::IoError(settings.overlaps, {}, fmt::format("cannot make the folder: {}", error.message()));
  const std::string extension = settings.output_format.empty() ? "xoff" : settings.output_format;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (pairs[i].pair.relation != Relation::interfering) continue;
    Settings of_overlap = settings;
    const std::string name = fmt::format("overlap-{}-{}.{}", pairs[i].pair.a, pairs[i].pair.b, extension);
    of_overlap.output = (folder / name).string();
    of_overlap.output_format.clear();
    write_solid(of_overlap, output_format(of_overlap), pairs[i].overlap.exact_mesh());
    reports[i]["file"] = name;
  }
}

/// The table of the pairs, after a line of counts.
void print_table(const Json& result, const std::vector<LoadedMesh>& operands, std::FILE* stream) {
  fmt::print(stream, "{} parts: {} pairs apart, {} in contact, {} interfering\n", operands.size(),
             result["apart"].dump(), result["contact"].dump(), result["interfering"].dump());
  for (const Json& pair : result["pairs"]) {
    const auto& relation = pair["relation"].get_ref<const std::string&>();
    std::string numbers;
    if (relation == "apart") numbers = fmt::format("distance {}", pair["distance"].dump());
    if (relation == "interfering") numbers = fmt::format("volume {}", pair["volume"].dump());
    if (relation == "contact")
      numbers = fmt::format("facets {}, area {}; edges {}, length {}; vertices {}", pair["facets"].size(),
                            pair["area"].dump(), pair["edges"].size(), pair["length"].dump(), pair["vertices"].size());
    fmt::print(stream, "{}  {}  {:11}  {}\n", operands[pair["a"].get<std::size_t>()].path,
               operands[pair["b"].get<std::size_t>()].path, relation, numbers);
  }
}

/// Counts of pairs, and all that are listed.
Json result_of(const std::vector<PairFacts>& pairs, std::size_t parts) {
  std::size_t contact = 0, interfering = 0;
  Json list = Json::array();
  for (const PairFacts& facts : pairs) {
    contact += facts.pair.relation == Relation::contact;
    interfering += facts.pair.relation == Relation::interfering;
    list.push_back(pair_report(facts));
  }
  return {{"parts", parts},
          {"apart", parts * (parts - 1) / 2 - contact - interfering},
          {"contact", contact},
          {"interfering", interfering},
          {"pairs", std::move(list)}};
}

}  // namespace

ExitCode run_contacts(const Settings& settings) {
  Watch watch(settings.timeout);
  Stopwatch stopwatch;
  check_output(settings);
  const std::optional<double> reach = reach_of(settings);
  Json report = {{"operation", "contacts"}, {"operands", nullptr}, {"result", nullptr}, {"seconds", Json::object()}};
  const std::vector<LoadedMesh> operands = read_operands(settings);
  report["seconds"]["read"] = stopwatch.lap();

  watch.on_stop(OnStop::ask);
  std::optional<Assembly> parts;
  std::vector<PairFacts> pairs;
  try {
    std::vector<strata::Solid> solids;
    for (std::size_t k = 0; k < operands.size(); ++k) solids.push_back(make_solid(operands, k, settings));
    report["seconds"]["prepare"] = stopwatch.lap();
    ProgressBar bar(settings.progress, settings.quiet);
    const strata::Progress half = [&bar](double fraction) { bar.show(fraction / 2); };
    const strata::Progress whole = [&bar](double fraction) { bar.show(fraction); };
    on_threads(settings, [&] {
      parts.emplace(solids);
      pairs = listed_pairs(*parts, parts->pairs(strata::Monitor(&watch.token(), &half)), reach);
      report["seconds"]["pairs"] = stopwatch.lap();
      find_facts(*parts, pairs, strata::Monitor(&watch.token(), &whole));
      if (reach) erase_farther(pairs, *reach);
    });
    report["seconds"]["facts"] = stopwatch.lap();
  } catch (const strata::Cancelled&) {
    watch.on_stop(OnStop::leave);  // says why
    throw;
  }
  report["result"] = result_of(pairs, operands.size());
  report["peak_bytes"] = peak_bytes();

  watch.on_stop(OnStop::finish);
  stopwatch.lap();
  if (!settings.overlaps.empty()) write_overlaps(pairs, report["result"]["pairs"], settings);
  if (!settings.output.empty())
    is_picture(settings.output) ? write_contact_picture(settings.output, *parts, pairs)
                                : write_contacts(settings.output, *parts, pairs);
  report["seconds"]["write"] = stopwatch.lap();
  if (!settings.quiet && settings.report != "-")
    print_table(report["result"], operands, settings.output == "-" ? stderr : stdout);
  if (settings.report.empty()) return ExitCode::ok;
  report["operands"] = operand_reports(operands, settings);
  write_report(settings.report, std::move(report));
  return ExitCode::ok;
}
