#include "corpus.h"

#include <cstdlib>

#include "strata/io.h"

namespace bench {

Corpus::Corpus() {
  if (const char* root = std::getenv("STRATA_CORPUS")) root_ = root;
}

strata::Mesh Corpus::read(const std::filesystem::path& name) const {
  if (root_.empty()) throw MissingMesh("STRATA_CORPUS is not set, it should lead to " + name.string());
  if (!exists(root_ / name)) throw MissingMesh("STRATA_CORPUS has no " + name.string());
  return strata::read_mesh(root_ / name).mesh;
}

}  // namespace bench
