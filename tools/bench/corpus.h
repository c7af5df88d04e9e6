#pragma once
#include <filesystem>
#include <stdexcept>

#include "strata/mesh.h"

namespace bench {

/// A mesh that this machine does not have.
class MissingMesh : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The collection of real meshes that the environment variable STRATA_CORPUS names.
class Corpus {
 public:
  Corpus();

  /// Throws MissingMesh: STRATA_CORPUS is not set or the file is not there. Throws IoError.
  [[nodiscard]] strata::Mesh read(const std::filesystem::path& name) const;

 private:
  std::filesystem::path root_;
};

}  // namespace bench
