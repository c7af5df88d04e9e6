#pragma once
#include <string>
#include <string_view>

/// Bytes as text, for documents that have files inside (RFC 4648).
[[nodiscard]] std::string base64(std::string_view bytes);
