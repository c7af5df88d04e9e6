#pragma once
#include <optional>
#include <string>

#include "common/json_report.h"
#include "settings.h"
#include "strata/io.h"
#include "strata/monitor.h"
#include "strata/rounding.h"

/// The step of `--grid`, or of `--to`: a decimal as 1e-3 or a fraction as 1/1024. Throws UsageError, which names
/// `option`.
[[nodiscard]] strata::Rational parse_step(const char* option, const std::string& text);

/// The numbers that a file of a format can hold, on the grid that the settings ask for; none if it holds all rationals
/// and no grid is asked for.
[[nodiscard]] std::optional<strata::CoordinateGrid> grid_of(strata::Format format, const Settings& settings);

/// As strata::round_to_solid; a coordinate beyond the format is an error of the output. Throws strata::IoError.
[[nodiscard]] strata::RoundedMesh rounded_for_output(const strata::ExactMesh& exact, const strata::CoordinateGrid& grid,
                                                     const Settings& settings, const strata::CancelToken* cancel);

/// Where faces were rearranged, a line to the standard error, unless `--quiet`.
void print_rounding(const strata::RoundingReport& report, const Settings& settings);

/// A solid so far from the exact one is not what was asked for: it is written, with exit code 5.
[[nodiscard]] bool strays(const strata::RoundingReport& report);
/// Says so on the standard error.
void print_strays(const strata::RoundingReport& report);

/// What a file holds in place of the exact boundary of a solid.
struct RoundedOutput {
  strata::Attributes attributes;                 ///< of what the file holds
  std::optional<strata::ExactMesh> mesh;         ///< none: the exact mesh, as the format keeps or rounds it
  Json report;                                   ///< what rounding did: as RoundingReport; null if nothing was asked
  std::optional<strata::RoundingReport> strays;  ///< if what is written strays from the exact mesh
};
/// Rounded such that it bounds a solid, unless the settings ask for the nearest numbers or the format holds all.
[[nodiscard]] RoundedOutput rounded_output(const strata::ExactMesh& exact, const strata::Attributes& attributes,
                                           strata::Format format, const Settings& settings,
                                           const strata::CancelToken* cancel = nullptr);
/// Of a mesh that is rounded already, as it is.
[[nodiscard]] RoundedOutput rounded_output(const strata::RoundingReport& report, const strata::Mesh& mesh,
                                           strata::Attributes attributes, const Settings& settings);

/// Writes the boundary of a solid so, whole or not at all. Throws strata::IoError.
void write_solid(const Settings& settings, strata::Format format, const strata::ExactMesh& exact,
                 const strata::Attributes& attributes = {});

[[nodiscard]] Json to_json(const strata::RoundingReport& report, const strata::Mesh& mesh);
