#pragma once
#include <optional>
#include <span>
#include <vector>

#include "common/json_report.h"
#include "files.h"
#include "settings.h"
#include "strata/combine.h"
#include "strata/errors.h"
#include "strata/mesh.h"
#include "strata/options.h"

/// {kind, severity, where, faces, count, message, remedy}; where is null or [x, y, z].
[[nodiscard]] Json to_json(const strata::Defect& defect);
[[nodiscard]] Json to_json(std::span<const strata::Defect> defects);

/// One line each to the standard error, unless `--quiet`.
void print_notes(std::span<const strata::Defect> notes, const Settings& settings);

/// {vertices, triangles, volume, area, components, euler, closed}. Volume is null for a mesh that is not closed; all
/// measures are for one with bad indices or coordinates that are not finite.
[[nodiscard]] Json measures(const strata::ExactMesh& mesh, const Settings& settings);

/// {path, measures, defects}.
[[nodiscard]] Json operand_report(const LoadedMesh& operand, std::span<const strata::Defect> defects,
                                  const Settings& settings);

/// With facets.
[[nodiscard]] strata::MeasuredBoundary measured(const strata::ExactMesh& mesh, const Settings& settings);

/// {measures, touching_edges, touching_vertices, facets, volume_exact, empty, closed, rounded_valid}; `rounded_valid`
/// is null where it was not checked, `volume_exact` where more than 1,000 vertices are not doubles.
[[nodiscard]] Json result_report(const strata::MeasuredBoundary& result, std::optional<bool> rounded_valid);

/// A report per operand, with what was resolved on the way in, as for this operand alone; errors too.
[[nodiscard]] Json operand_reports(std::span<const LoadedMesh> operands, const Settings& settings);
/// The same where an evaluation has taken the operands, with these notes: without any, they are not searched again.
[[nodiscard]] Json operand_reports(std::span<const LoadedMesh> operands, std::span<const strata::Defect> notes,
                                   const Settings& settings);
