#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

/// The report keeps the order in which its members are written.
using Json = nlohmann::ordered_json;

/// Largest memory the process has held so far.
[[nodiscard]] std::uint64_t peak_bytes();

/// Writes to a file (whole or not at all) or to stdout for "-". Adds the version. Throws strata::IoError.
void write_report(const std::string& where, Json report);
