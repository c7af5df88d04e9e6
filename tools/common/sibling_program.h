#pragma once
#include <filesystem>
#include <string>

/// The file of the program that runs.
[[nodiscard]] std::filesystem::path own_program();

/// A program that belongs to this one: beside it, in ../libexec/strata as seen from there, or else in the PATH. Empty
/// where there is none.
[[nodiscard]] std::filesystem::path sibling_program(const std::string& name);

/// The first file of this name that can be run in a folder of the PATH; empty where there is none.
[[nodiscard]] std::filesystem::path program_in_path(const std::string& name);
