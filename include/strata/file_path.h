#pragma once
/// Paths of files as parameters: texts, and std::filesystem::path without its header.
#include <concepts>
#include <string>
#include <string_view>
#include <utility>

namespace strata {

/// The path of a file, as it is given to functions that read and write files. It is made of a std::string, a
/// std::string_view, a literal, or a std::filesystem::path (which only those who use it include). Nothing is
/// interpreted: bytes are handed to the operating system as they are. On Windows the text is UTF-8.
class FilePath {
 public:
  template <class T>
  requires std::convertible_to<const T&, std::string_view> FilePath(const T& text)
      : text_(std::string_view(text)) {}                             // NOLINT(google-explicit-constructor)
  FilePath(std::string&& text) noexcept : text_(std::move(text)) {}  // NOLINT(google-explicit-constructor)

  /// A path whose native() is a string of char, as everywhere but on Windows, where u8string() is taken.
  template <class T>
  requires(!std::convertible_to<const T&, std::string_view> && requires(const T& path) {
    path.native();
    path.u8string();
  }) FilePath(const T& path) {  // NOLINT(google-explicit-constructor)
    if constexpr (std::convertible_to<decltype(path.native()), std::string_view>) {
      text_ = std::string_view(path.native());
    } else {
      const auto text = path.u8string();
      text_.assign(text.begin(), text.end());
    }
  }

  [[nodiscard]] const std::string& text() const noexcept { return text_; }

 private:
  std::string text_;
};

}  // namespace strata
