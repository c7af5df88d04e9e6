#pragma once
#include <string>
#include <string_view>

#include "strata/monitor.h"

/// All bytes of a file. Throws strata::IoError.
[[nodiscard]] std::string read_file(const std::string& path);

/// All bytes of a file, or of standard input for "-". Waiting for a pipe ends when `cancel` is set. Throws
/// strata::IoError, strata::Cancelled.
[[nodiscard]] std::string read_text(const std::string& where, const strata::CancelToken* cancel = nullptr);

/// Writes text to a file, whole or not at all, or to stdout for "-". Throws strata::IoError.
void write_text(const std::string& where, std::string_view text);
