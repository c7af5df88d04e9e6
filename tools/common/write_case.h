#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "strata/mesh.h"
#include "strata/options.h"

namespace verify {

/// A case to be written.
struct NewCase {
  std::string why, expression;
  std::vector<std::string> tags;
  std::vector<std::pair<std::string, const strata::ExactMesh*>> operands;  ///< by name
  strata::InputClass input = strata::InputClass::solid;
};

/// Writes case.json and the operands into a folder that is there: OFF where doubles hold them, else XOFF; all bits are
/// kept. No expected.json. Throws strata::IoError.
void write_case(const std::filesystem::path& folder, const NewCase& c);

}  // namespace verify
