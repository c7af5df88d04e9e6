#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/csv.h"
#include "strata/mesh.h"
#include "strata/options.h"
#include "strata/rational.h"
#include "strata/solid.h"

/// The corpus of real meshes and expected values, in the directory that STRATA_CORPUS names.
namespace strata::test {

/// The corpus, or nothing and a visible warning that the test is skipped.
[[nodiscard]] std::optional<std::filesystem::path> corpus_or_skip();

/// A mesh of the corpus. Throws IoError.
[[nodiscard]] Mesh load(const std::filesystem::path& root, const std::string& path);

/// An OFF file of triangles, with its coordinates taken as the short decimals that they were before they became
/// doubles: 0.10000000000000001 is one tenth here (15 digits). `load` takes the doubles as they are.
/// Throws std::runtime_error for any other file.
[[nodiscard]] ExactMesh load_decimals(const std::filesystem::path& root, const std::string& path);

/// "49/40", "-3", "0.1" or "1e-7", exactly; whatever follows a blank is left out. Nothing for an empty text.
[[nodiscard]] std::optional<Rational> exact_number(std::string_view text);

/// A Boolean as the tables name it: "union", "intersection", "A-B", "B-A", "xor".
struct NamedOperation {
  Operation operation = Operation::union_;
  bool swapped = false;
};
[[nodiscard]] NamedOperation operation_named(std::string_view name);

/// The named operation on two solids, with exact vertices.
[[nodiscard]] Solid evaluate(std::string_view operation, const Solid& a, const Solid& b);

/// |x - expected| <= bound * |expected|, decided exactly.
[[nodiscard]] bool within(const Rational& x, const Rational& expected, const Rational& bound);

/// Parts of the surface: triangles joined over edges that have exactly two triangles. Sheets that only share a vertex
/// or an edge of four triangles are parts of their own, where Topology::components counts them as one.
[[nodiscard]] std::size_t surface_parts(const Mesh& mesh);

/// The last part of a path of the corpus, for messages.
[[nodiscard]] std::string short_name(const std::string& path);

}  // namespace strata::test
