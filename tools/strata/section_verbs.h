#pragma once
#include <optional>
#include <string>

#include "common/exit_code.h"
#include "settings.h"

/// What the verbs of sections ask for beside the common settings.
struct SectionSettings {
  std::string plane;           ///< a,b,c,d: the points with a x + b y + c z = d
  std::size_t along = 2;       ///< the axis that planes are perpendicular to
  std::optional<double> step;  ///< from plane to plane
  std::optional<double> from;  ///< the first plane; none: where the solids begin
  std::optional<double> to;    ///< planes below this; none: where the solids end
  std::string at;              ///< a file of coordinates; "-" is stdin
};

/// The polygons in which a plane meets solids.
[[nodiscard]] ExitCode run_section(const SectionSettings& section, const Settings& settings);

/// The same for many planes.
[[nodiscard]] ExitCode run_slice(const SectionSettings& section, const Settings& settings);
