#pragma once
#include <vector>

#include "common/exit_code.h"
#include "settings.h"
#include "strata/monitor.h"
#include "strata/planar.h"

/// What a file holds in place of a region.
struct OutputRegion {
  strata::planar::RoundedRegion rounded;
  std::vector<strata::planar::SelfMeeting> conflicts;  ///< where vertices at their nearest doubles make loops meet
};

/// The region as it is where its vertices at their nearest doubles bound it, else rounded such that it is a region
/// again. Nothing is rounded, or searched, where quotients were asked for; nothing is rearranged where the nearest
/// doubles were. Throws UsageError for a grid that is none, strata::IoError for coordinates beyond the format.
[[nodiscard]] OutputRegion output_region(strata::planar::Region region, const Settings& settings,
                                         const strata::Monitor& monitor);

/// Tells where loops were rearranged, unless `--quiet`; where they were not, though they meet, it is exit code 5.
[[nodiscard]] ExitCode report_conflicts(const OutputRegion& written, const Settings& settings);

/// --exact, --rounding and --grid, of verbs that write polygons.
void add_region_rounding_options(CLI::App& verb, Settings& settings);
