#include "core/io/pieces.h"

#include "core/io/line_end.h"

namespace strata::io {

std::size_t next_line(std::string_view text, std::size_t offset) {
  const char* const begin = text.data();
  const char* const end = begin + text.size();
  const char* at = begin + offset;
  while (true) {
    const char* stop = find_line_end(at, end);
    if (stop == end) return text.size();
    at = behind_line_end(stop, end);
    // The search may have started in the middle of CR LF.
    if (*stop == '\n' && stop != begin && stop[-1] == '\r') --stop;
    if (stop == begin || stop[-1] != '\\') return static_cast<std::size_t>(at - begin);
  }
}

}  // namespace strata::io
