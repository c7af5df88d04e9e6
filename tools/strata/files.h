#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/text_file.h"
#include "settings.h"
#include "strata/io.h"
#include "strata/mesh.h"
#include "strata/solid.h"

/// An operand as read. Its exact part is what the file says beyond doubles (XOFF).
struct LoadedMesh {
  std::string path;  ///< as given; "-" for standard input
  strata::ExactMesh mesh;
  std::vector<std::uint32_t> polygon_of_triangle = {};  ///< as in strata::MeshFile
  strata::Attributes attributes = {};                   ///< as in strata::MeshFile
  strata::Unit unit = strata::Unit::none;               ///< of the coordinates
  std::size_t argument = 0;                             ///< which of the paths it came from
};

/// Reads all operands, with the attributes that the settings ask for, each object as one with --objects. If some have a
/// unit, all are converted to that of the first of these, exactly; those whose files say none have it already, or that
/// of --unit. What the readers note goes to stderr unless quiet. Throws strata::IoError, UsageError.
[[nodiscard]] std::vector<LoadedMesh> read_operands(const Settings& settings);

/// A solid made from operand k, of the class that the settings say; what is resolved goes to stderr unless quiet.
/// Errors name that operand. Throws strata::InputError.
[[nodiscard]] strata::Solid make_solid(std::span<const LoadedMesh> operands, std::size_t k, const Settings& settings);

/// A solid that was made from a mesh, with the attributes of this.
[[nodiscard]] strata::Solid with_attributes_of(const LoadedMesh& mesh, strata::Solid solid);

/// `make_solid`, with its attributes.
[[nodiscard]] strata::Solid make_attributed_solid(std::span<const LoadedMesh> operands, std::size_t k,
                                                  const Settings& settings);

/// Notes what operands have that a result does not carry.
void tell_what_is_not_carried(std::span<const LoadedMesh> operands, const Settings& settings);

/// The format that -o and --format ask for; binary STL on standard output unless told. Throws UsageError.
[[nodiscard]] strata::Format output_format(const Settings& settings);

/// The settings with the unit of the operands, which the output has.
[[nodiscard]] Settings with_unit_of(std::span<const LoadedMesh> operands, Settings settings);

/// Writes a mesh whole or not at all, in the unit of the settings. Throws strata::IoError, with --strict also for what
/// the format cannot keep.
void write_output(const Settings& settings, strata::Format format, const strata::ExactMesh& mesh,
                  const strata::Attributes& attributes = {});
