#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/json_location.h"
#include "verify/facts.h"

namespace verify {

/// What the right result of a case is, and who says so: expected.json.
struct Expectation {
  std::string volume;            ///< as `volume_text` has it
  strata::Rational volume_near;  ///< exact, or to 15 digits where only a digest is kept
  strata::Rational area;         ///< to 15 digits
  FormFacts form;
  std::uint64_t components = 0;
  std::int64_t euler = 0;
  NonManifold touching;
  std::vector<std::string> origin;  ///< "analytic", "nef", engines; sorted

  [[nodiscard]] bool is_empty() const { return form.vertices == 0; }
};

[[nodiscard]] Expectation expectation_of(const Facts& facts);

/// Throws strata::IoError, which names file and field.
[[nodiscard]] Expectation read_expectation(const std::filesystem::path& path);
/// The same for a text, for which `file` stands in messages.
[[nodiscard]] Expectation parse_expectation(std::string_view text, const std::string& file);
[[nodiscard]] Json to_json(const Expectation& expectation);

/// What differs, as a sentence; nothing if only `origin` may.
[[nodiscard]] std::optional<std::string> difference(const Expectation& found, const Expectation& expected);

/// Adds a name to `origin`. False if it is there already.
bool add_origin(Expectation& expectation, const std::string& name);

}  // namespace verify
