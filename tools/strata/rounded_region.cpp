#include "rounded_region.h"

#include <CLI/CLI.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/tell.h"
#include "planar_input.h"
#include "rounded_output.h"

namespace planar = strata::planar;

OutputRegion output_region(planar::Region region, const Settings& settings, const strata::Monitor& monitor) {
  strata::CoordinateGrid grid;
  if (!settings.grid.empty()) grid.step = parse_step("--grid", settings.grid);
  if (settings.exact && !settings.grid.empty()) throw UsageError("--exact writes what --grid would round");
  if (settings.exact) return {{std::move(region), 0, 0}, {}};
  std::vector<planar::SelfMeeting> conflicts = planar::rounding_conflicts(region);
  if (!settings.makes_solids() || (settings.grid.empty() && conflicts.empty()))
    return {{std::move(region), 0, 0}, std::move(conflicts)};
  try {
    return {planar::round_to_region(region, grid, monitor), std::move(conflicts)};
  } catch (const std::invalid_argument& error) {
    throw strata::IoError(settings.output, {}, error.what());
  }
}

ExitCode report_conflicts(const OutputRegion& written, const Settings& settings) {
  const auto where = [&] { return place(written.conflicts.front().where).dump(); };
  if (!settings.makes_solids() && !written.conflicts.empty()) {
    tell(
        "strata: rounding the result's vertices makes its loops meet in {} places, the first one near {}; "
        "--rounding valid rearranges them, --exact writes the result as it is\n",
        written.conflicts.size(), where());
    return ExitCode::not_certified;
  }
  if (settings.quiet) return ExitCode::ok;
  const planar::RoundedRegion& rounded = written.rounded;
  if (!written.conflicts.empty())
    tell("strata: rounded loops would meet in {} places, the first one near {}: rearranged\n", written.conflicts.size(),
         where());
  if (rounded.rounds > 0 || !written.conflicts.empty())
    tell("strata: loops were rearranged in {} rounds; nothing moved by more than {:.3g}; {} polygons\n", rounded.rounds,
         rounded.largest_movement, rounded.region.polygons());
  return ExitCode::ok;
}

void add_region_rounding_options(CLI::App& verb, Settings& settings) {
  verb.add_flag("--exact", settings.exact, "Quotients where coordinates are not doubles (WKT, CSV)");
  add_rounding_options(verb, settings, "where loops would meet, they are rearranged, so that the file holds polygons");
}
