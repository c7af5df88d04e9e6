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
};

/// Reads all operands, with the attributes that the settings ask for; what the readers note goes to stderr unless
/// quiet. Throws strata::IoError, UsageError.
[[nodiscard]] std::vector<LoadedMesh> read_operands(const Settings& settings);

/// A solid made from operand k, of the class that the settings say; what is resolved goes to stderr unless quiet.
/// Errors name that operand. Throws strata::InputError.
[[nodiscard]] strata::Solid make_solid(std::span<const LoadedMesh> operands, std::size_t k, const Settings& settings);

/// The same with its attributes.
[[nodiscard]] strata::Solid make_attributed_solid(std::span<const LoadedMesh> operands, std::size_t k,
                                                  const Settings& settings);

/// The format that -o and --format ask for; binary STL on standard output unless told. Throws UsageError.
[[nodiscard]] strata::Format output_format(const Settings& settings);

/// Writes a mesh whole or not at all. Throws strata::IoError.
void write_output(const Settings& settings, strata::Format format, const strata::ExactMesh& mesh,
                  const strata::Attributes& attributes = {});
