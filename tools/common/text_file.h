#pragma once
#include <string>
#include <string_view>

/// All bytes of a file. Throws strata::IoError.
[[nodiscard]] std::string read_file(const std::string& path);

/// Writes text to a file, whole or not at all, or to stdout for "-". Throws strata::IoError.
void write_text(const std::string& where, std::string_view text);
