#pragma once
#include <string>

#include "common/exit_code.h"
#include "settings.h"

/// What `strata draw` asks for beside the common settings.
struct DrawSettings {
  std::vector<double> from, direction;  ///< three numbers, or none
  std::vector<double> towards, up;      ///< the same
  std::string style = "lines";
  double crease_angle = 25;
  double width = 1000;
};

void add_draw_options(CLI::App& verb, DrawSettings& draw);

/// Line drawing or shaded picture of meshes from a point or along a direction, as SVG, or PNG by rsvg-convert.
[[nodiscard]] ExitCode run_draw(const DrawSettings& draw, const Settings& settings);
