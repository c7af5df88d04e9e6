#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "settings.h"
#include "strata/io.h"
#include "strata/mesh.h"

/// What a mesh of several is: solids are rounded as --rounding says.
enum class MeshContent { solid, surface };

/// Several meshes in the one file that -o names: the faces of each are a group with its name. Formats for simulation
/// have a number for each face (VTK, PLY) or a physical surface for each group (MSH). Equal vertices are one. What the
/// meshes carry stays, but for groups of their own.
class RegionFile {
 public:
  /// False where -o names a folder. Throws UsageError for a file of a format that has no groups.
  [[nodiscard]] static bool is_named(const Settings& settings);

  explicit RegionFile(const Settings& settings);

  void add(const strata::ExactMesh& mesh, const strata::Attributes& attributes, std::string name, MeshContent content);
  /// Whole or not at all. Throws strata::IoError.
  void write();

 private:
  /// A mesh as it was added.
  struct Part {
    strata::ExactMesh mesh;
    strata::Attributes attributes;
  };

  [[nodiscard]] std::uint32_t vertex(const strata::ExactMesh& mesh, std::uint32_t v);
  [[nodiscard]] strata::Attributes carried() const;

  const Settings& settings_;
  strata::Format format_;
  std::vector<Part> parts_;
  strata::ExactMesh all_;
  std::vector<strata::Source> sources_;  ///< per face: the part, and its face
  std::size_t first_face_of_part_ = 0;
  std::vector<std::int32_t> group_;  ///< per face
  std::vector<std::string> names_;
  std::map<strata::RationalPoint, std::uint32_t> numbers_;
};
