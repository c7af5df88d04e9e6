#include "common/terminal.h"

#include <cstdlib>
#include <string_view>

#include "core/system/streams.h"

bool has_colours(int descriptor) {
  if (!strata::system::is_terminal(descriptor)) return false;
  if (const char* refused = std::getenv("NO_COLOR"); refused != nullptr && *refused != '\0') return false;
  const char* terminal = std::getenv("TERM");
  return terminal == nullptr || std::string_view(terminal) != "dumb";
}

std::string painted_error(const std::string& text) {
  return has_colours(strata::system::standard_error) ? "\033[1;31m" + text + "\033[0m" : text;
}
