#pragma once
#include <string>

/// May text to this file descriptor have colours? On terminals only, not where $NO_COLOR has any value
/// (no-color.org), and not where $TERM is `dumb`.
[[nodiscard]] bool has_colours(int descriptor);

/// The text in bold red, where standard error has colours.
[[nodiscard]] std::string painted_error(const std::string& text);
