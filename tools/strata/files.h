#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "settings.h"
#include "strata/io.h"
#include "strata/mesh.h"

/// An operand as read. Its exact part is what the file says beyond doubles (XOFF).
struct LoadedMesh {
  std::string path;  ///< as given; "-" for standard input
  strata::ExactMesh mesh;
  std::vector<std::uint32_t> polygon_of_triangle = {};  ///< as in strata::MeshFile
};

/// Reads all operands; what the readers note goes to stderr unless quiet. Throws strata::IoError, UsageError.
[[nodiscard]] std::vector<LoadedMesh> read_operands(const Settings& settings);

/// The format that -o and --format ask for; binary STL on standard output unless told. Throws UsageError.
[[nodiscard]] strata::Format output_format(const Settings& settings);

/// Writes a mesh whole or not at all. Throws strata::IoError.
void write_output(const Settings& settings, strata::Format format, const strata::ExactMesh& mesh);

/// Writes text to a file, whole or not at all, or to stdout for "-". Throws strata::IoError.
void write_text(const std::string& where, std::string_view text);
