#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace strata::io {

/// The regular file that a model names, if it is beneath the model's folder: not what a path leads to beyond that, by
/// `..`, by an absolute path or by a link. None also where there is no such file. `folder` may be null: none.
[[nodiscard]] std::optional<std::filesystem::path> file_beneath(const std::filesystem::path* folder,
                                                                const std::string& name);

/// %20 and the like, decoded.
[[nodiscard]] std::string percent_decoded(std::string_view text);

/// Bytes of text in base64; none if it is something else.
[[nodiscard]] std::optional<std::string> base64_decoded(std::string_view text);
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace strata::io
