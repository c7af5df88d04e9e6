#pragma once
#include <fmt/format.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "common/json_report.h"
#include "common/progress.h"
#include "common/watch.h"
#include "planar_verbs.h"
#include "settings.h"
#include "strata/planar.h"

// What the verbs of `strata planar` share.

/// Reads the operands; what the readers note goes to stderr unless quiet. Throws strata::IoError, UsageError.
[[nodiscard]] std::vector<strata::planar::PlanarFile> read_files(const Settings& settings);

/// The format that -o and --format ask for. Throws UsageError.
[[nodiscard]] strata::planar::PlanarFormat output_format_of(const Settings& settings);

[[nodiscard]] strata::planar::FillRule fill_rule(const PlanarSettings& planar);

/// [x, y]: numbers, or quotients as text where doubles are not exact.
[[nodiscard]] Json place(const strata::planar::RationalPlacement& p);

/// Path, loops and vertices of every operand.
[[nodiscard]] Json operand_facts(const Settings& settings, const std::vector<strata::planar::PlanarFile>& files);

/// How many polygons, holes and vertices a region has, and its area.
[[nodiscard]] Json region_facts(const strata::planar::Region& region);

/// A line per member; on standard error where standard output has the result.
void print_facts(const Json& result, const Settings& settings);

/// Calls work(monitor); stops cleanly.
template <class Work>
auto cancellable(Watch& watch, const Settings& settings, const Work& work) {
  watch.on_stop(OnStop::ask);
  try {
    ProgressBar bar(settings.progress, settings.quiet);
    const strata::Progress progress = [&bar](double fraction) { bar.show(fraction); };
    return work(strata::Monitor(&watch.token(), &progress));
  } catch (const strata::Cancelled&) {
    watch.on_stop(OnStop::leave);  // says why
    throw;
  }
}
