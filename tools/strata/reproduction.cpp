#include "reproduction.h"

#include <fmt/format.h>

#include <cstdlib>
#include <exception>
#include <filesystem>

namespace {

namespace fs = std::filesystem;

/// The first folder of this kind that is not there yet, made.
fs::path new_folder() {
  const char* named = std::getenv("STRATA_REPRODUCTIONS");
  const fs::path root = named != nullptr && *named != '\0' ? named : ".";
  fs::create_directories(root);
  for (int n = 1;; ++n) {
    fs::path folder = root / fmt::format("strata-reproduction-{}", n);
    if (!fs::exists(fs::symlink_status(folder)) && fs::create_directory(folder)) return folder;
  }
}

}  // namespace

std::string joined_expression(strata::Operation operation, std::size_t count) {
  std::string text = "s0";
  for (std::size_t n = 1; n < count; ++n) text += fmt::format(" {} s{}", sign(operation), n);
  return text;
}

std::string keep_reproduction(const Asked& asked, const char* verb, const std::string& error,
                              const Settings& settings) noexcept try {
  verify::NewCase c = asked();
  const fs::path folder = new_folder();
  c.tags = {"reproduction"};
  c.why = fmt::format("strata {} --input {} -j {} (version {}) ended in an error of the program: {}", verb,
                      name(c.input), settings.threads, STRATA_VERSION, error);
  verify::write_case(folder, c);
  return fmt::format("The operands and what was asked of them are in {}: please send this folder", folder.string());
} catch (const std::exception& why) {
  return fmt::format("The operands and what was asked of them could not be kept: {}", why.what());
}

void provoke_logic_error() {
  if (std::getenv("STRATA_TEST_LOGIC_ERROR") != nullptr) throw strata::LogicError("an error that a test asked for");
}
