#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "common/csv.h"
#include "common/stopwatch.h"
#include "common/text_file.h"
#include "planar_input.h"
#include "planar_verbs.h"
#include "rounded_region.h"
#include "row_file.h"
#include "stream_blocks.h"
#include "threads.h"

using namespace strata::planar;

namespace {

Region region_of(const PlanarFile& file, const PlanarSettings& planar, const strata::Monitor& monitor) {
  const Operand operand(file.loops, fill_rule(planar));
  return combine(std::span(&operand, 1), Operation::union_, monitor);
}

/// Standard output has the facts, or the report.
void report_facts(Json report, const Json& facts, const Settings& settings) {
  print_facts(facts, settings);
  if (settings.report.empty()) return;
  report["peak_bytes"] = peak_bytes();
  write_report(settings.report, std::move(report));
}

/// Every polygon as one loop.
Region bridged_region(const Region& region) {
  LoopsBuilder builder;
  Region result;
  for (std::uint32_t p = 0; p < region.polygons(); ++p) {
    const Loops one = bridged(region, p);
    for (const std::uint32_t v : one.vertices) builder.add_vertex(exact_position(one.places, v));
    builder.end_loop();
    result.first_loop.push_back(p + 1);
  }
  result.loops = builder.finish();
  return result;
}

/// Points on their way through the stages.
struct PointBlock {
  LineBlock lines;
  std::vector<double> numbers;
  std::string rows;
  std::array<std::uint64_t, 3> counts{};  ///< by Membership
};

void answer(const Locator& locator, PointBlock& block) {
  constexpr std::array words{"in", "on", "out"};
  block.rows.clear();
  block.counts = {};
  std::array<char, longest_number> digits;
  for (std::size_t i = 0; i < block.numbers.size(); i += 2) {
    const PlanePoint p{block.numbers[i], block.numbers[i + 1]};
    const auto where = static_cast<std::size_t>(locator.locate(p));
    ++block.counts[where];
    for (const double x : p) block.rows.append(digits.data(), append_number(digits.data(), x)).append(1, ',');
    block.rows.append(words[where]).append(1, '\n');
  }
}

/// Answers all points, in bounded memory.
std::array<std::uint64_t, 3> stream_points(const Locator& locator, const Settings& settings, const Watch& watch) {
  ByteSource bytes(settings.points, &watch.token());
  CsvReader reader(bytes, {"x", "y"});
  RowFile file(
      settings.output, [](std::uint64_t) { return std::string("x,y,where\n"); }, 0);
  std::array<std::uint64_t, 3> counts{};
  stream_blocks<PointBlock>([&](PointBlock& block) { return reader.next(block.lines); },
                            [&](PointBlock& block) {
                              block.numbers.clear();
                              reader.parse(block.lines, block.numbers);
                              answer(locator, block);
                            },
                            [&](const PointBlock& block) {
                              for (std::size_t k = 0; k < counts.size(); ++k) counts[k] += block.counts[k];
                              file.write(block.rows);
                            });
  file.finish(counts[0] + counts[1] + counts[2]);
  return counts;
}

const char* name(Relation relation) {
  constexpr std::array names{"apart", "contact", "interfering"};
  return names[static_cast<std::size_t>(relation)];
}

Json to_json(const Contact& contact) {
  Json edges = Json::array(), points = Json::array();
  for (const auto& [from, to] : contact.edges) edges.push_back({place(from), place(to)});
  for (const RationalPlacement& p : contact.points) points.push_back(place(p));
  return {{"relation", name(contact.relation)}, {"edges", std::move(edges)}, {"points", std::move(points)}};
}

Json to_json(const CanonicalDecomposition& d) {
  Json vertices = Json::array(), edges = Json::array();
  for (const RationalPlacement& p : d.vertices) vertices.push_back(place(p));
  for (const auto& [from, to] : d.edges) edges.push_back({from, to});
  return {{"manifold", d.is_manifold()},
          {"exterior_faces", d.exterior_faces},
          {"vertices", std::move(vertices)},
          {"degree", d.degree},
          {"edges", std::move(edges)}};
}

}  // namespace

ExitCode run_planar_bridge(const PlanarSettings& planar, const Settings& settings) {
  Watch watch(settings.timeout);
  const PlanarFormat format = output_format_of(settings);
  if (settings.exact && format != PlanarFormat::wkt)
    throw UsageError("--exact is for WKT: other formats have no quotients");
  const std::vector<PlanarFile> files = read_files(settings);
  Json facts = {{"polygons", 0}, {"bridges", 0}};
  const Region result = cancellable(watch, settings, [&](const strata::Monitor& monitor) {
    const Region region = region_of(files.front(), planar, monitor);
    facts = {{"polygons", region.polygons()}, {"bridges", region.loops.size() - region.polygons()}};
    return bridged_region(output_region(region, settings, monitor).rounded.region);
  });
  watch.on_stop(OnStop::finish);
  write_text(settings.output, to_text(result, format, settings.exact ? Coordinates::exact : Coordinates::nearest));
  report_facts({{"operation", "planar bridge"}, {"operands", operand_facts(settings, files)}, {"result", facts}}, facts,
               settings);
  return ExitCode::ok;
}

ExitCode run_planar_locate(const PlanarSettings& planar, const Settings& settings) {
  Watch watch(settings.timeout);
  const std::vector<PlanarFile> files = read_files(settings);
  Json facts;
  cancellable(watch, settings, [&](const strata::Monitor& monitor) {
    on_threads(settings, [&] {
      const Region region = region_of(files.front(), planar, monitor);
      const auto counts = stream_points(Locator(region), settings, watch);
      facts = {{"count", counts[0] + counts[1] + counts[2]}, {"in", counts[0]}, {"on", counts[1]}, {"out", counts[2]}};
    });
    return 0;
  });
  report_facts({{"operation", "planar locate"}, {"operands", operand_facts(settings, files)}, {"points", facts}}, facts,
               settings);
  return ExitCode::ok;
}

ExitCode run_planar_contacts(const PlanarSettings& planar, const Settings& settings) {
  Watch watch(settings.timeout);
  const std::vector<PlanarFile> files = read_files(settings);
  Json pairs = Json::array();
  Json facts = {{"apart", 0}, {"contact", 0}, {"interfering", 0}};
  cancellable(watch, settings, [&](const strata::Monitor& monitor) {
    std::vector<Region> regions;
    for (const PlanarFile& file : files) regions.push_back(region_of(file, planar, monitor));
    for (std::size_t a = 0; a < regions.size(); ++a)
      for (std::size_t b = a + 1; b < regions.size(); ++b) {
        monitor.check();
        const Contact contact = contact_of(regions[a], regions[b]);
        Json pair = {{"a", a}, {"b", b}};
        pair.update(to_json(contact));
        pairs.push_back(std::move(pair));
        Json& count = facts[name(contact.relation)];
        count = count.get<std::uint64_t>() + 1;
      }
    return 0;
  });
  if (!settings.quiet && settings.report != "-")
    for (const Json& p : pairs)
      fmt::print("{} {} {}: {} edges, {} points\n", settings.operands[p["a"].get<std::size_t>()],
                 settings.operands[p["b"].get<std::size_t>()], p["relation"].get<std::string>(), p["edges"].size(),
                 p["points"].size());
  report_facts({{"operation", "planar contacts"},
                {"operands", operand_facts(settings, files)},
                {"result", facts},
                {"pairs", std::move(pairs)}},
               facts, settings);
  return ExitCode::ok;
}

ExitCode run_planar_decompose(const PlanarSettings& planar, const Settings& settings) {
  Watch watch(settings.timeout);
  const std::vector<PlanarFile> files = read_files(settings);
  Json polygons = Json::array();
  std::size_t vertices = 0, edges = 0, exterior = 0;
  cancellable(watch, settings, [&](const strata::Monitor& monitor) {
    const Region region = region_of(files.front(), planar, monitor);
    for (std::uint32_t p = 0; p < region.polygons(); ++p) {
      monitor.check();
      const CanonicalDecomposition d = canonical_decomposition(region, p);
      vertices += d.vertices.size();
      edges += d.edges.size();
      exterior += d.exterior_faces;
      polygons.push_back(to_json(d));
    }
    return 0;
  });
  const Json facts = {
      {"polygons", polygons.size()}, {"vertices", vertices}, {"edges", edges}, {"exterior_faces", exterior}};
  report_facts({{"operation", "planar decompose"},
                {"operands", operand_facts(settings, files)},
                {"result", facts},
                {"polygons", std::move(polygons)}},
               facts, settings);
  return ExitCode::ok;
}
