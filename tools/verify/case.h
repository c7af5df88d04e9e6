#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/json_location.h"
#include "strata/mesh.h"
#include "strata/options.h"
#include "verify/expectation.h"
#include "verify/steps.h"

namespace verify {

/// A solid of a case: a file beside case.json, or a generator line (generators.md).
struct CaseOperand {
  std::string name;
  std::filesystem::path file;  ///< empty where it is generated
  strata::ExactMesh mesh;
};

/// What the case's author knows for certain about the result, each field optional.
struct Known {
  std::optional<strata::Rational> volume, area;
  std::optional<std::int64_t> components, euler, facets, edges, vertices;
};

/// One question with one right answer: a directory with case.json, operands and expected.json. tests/README.md.
struct Case {
  std::string slug;  ///< the directory's name
  std::filesystem::path folder;
  std::vector<CaseOperand> operands;
  std::string expression;
  Steps steps;  ///< the same, one operation at a time
  std::vector<std::string> tags;
  std::string why;
  strata::InputClass input = strata::InputClass::solid;
  Known known;
  std::optional<Expectation> expected;  ///< nothing before the case is certified

  [[nodiscard]] bool has_tag(const std::string& tag) const;
};

/// Reads case.json, the operands and expected.json, if there is one. Throws strata::IoError, which names file and
/// field.
[[nodiscard]] Case read_case(const std::filesystem::path& folder);

/// The same for the text of case.json, without expected.json.
[[nodiscard]] Case parse_case(std::string_view text, const std::filesystem::path& folder);

/// The folders with a case.json directly under `root`, sorted. Throws strata::IoError if there is none.
[[nodiscard]] std::vector<std::filesystem::path> find_cases(const std::filesystem::path& root);

}  // namespace verify
