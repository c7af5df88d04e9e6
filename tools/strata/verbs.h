#pragma once
#include "common/exit_code.h"
#include "settings.h"
#include "strata/options.h"

/// union, intersection, difference, symmetric-difference. `name` is the verb, as it stands in the report.
[[nodiscard]] ExitCode run_boolean(strata::Operation operation, const char* name, const Settings& settings);

/// A mesh that crosses itself, made a solid.
[[nodiscard]] ExitCode run_resolve(const Settings& settings);
[[nodiscard]] ExitCode run_round(const Settings& settings);

/// An expression over meshes, evaluated at once.
[[nodiscard]] ExitCode run_eval(Settings& settings);

/// Is the mesh the boundary of a solid? Lists all defects. Never writes a mesh.
[[nodiscard]] ExitCode run_check(const Settings& settings);

/// Counts, measures, bounding box. Says what it can about broken meshes too.
[[nodiscard]] ExitCode run_info(const Settings& settings);

/// A mesh in another format, with all that the format keeps of its attributes.
[[nodiscard]] ExitCode run_convert(const Settings& settings);

/// Are two meshes equal as point sets?
[[nodiscard]] ExitCode run_compare(const Settings& settings);

/// Meshes, and the value of an expression about them, as a page that shows them.
[[nodiscard]] ExitCode run_view(Settings& settings);

/// The layers of a scene as seen from an origin; writes them as a coloured mesh.
[[nodiscard]] ExitCode run_layers(const Settings& settings);

/// The binary space partition of a solid: its size, and its cells as a picture.
[[nodiscard]] ExitCode run_bsp(const Settings& settings);

/// A solid as convex pieces: files of a folder, or a picture.
[[nodiscard]] ExitCode run_decompose(const Settings& settings);

/// Which solids interfere, touch, or are apart, and where and how far.
[[nodiscard]] ExitCode run_contacts(const Settings& settings);

/// The convex hull of meshes and points.
[[nodiscard]] ExitCode run_hull(const Settings& settings);

/// Where are points in a scene? Streams them from a file into another.
[[nodiscard]] ExitCode run_locate(const Settings& settings);

/// Where do rays meet a scene? Streams them from a file, and their hits into another.
[[nodiscard]] ExitCode run_ray(const Settings& settings);

/// The Minkowski sum of two solids, or the erosion of the first one by the second.
[[nodiscard]] ExitCode run_minkowski(const Settings& settings, bool subtract);

/// A solid grown or shrunk by a polyhedral ball.
[[nodiscard]] ExitCode run_offset(const Settings& settings);

/// Sets that need not be regular: an expression over meshes and complexes, operators, and what their boundaries are.
[[nodiscard]] ExitCode run_topology(Settings& settings);

/// Booleans of regions of the line, which files list as intervals.
[[nodiscard]] ExitCode run_intervals(strata::Operation operation, const Settings& settings);
