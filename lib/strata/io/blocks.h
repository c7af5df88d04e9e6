#pragma once
#include <tbb/parallel_for.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string>
#include <vector>

#include "strata/io/sink.h"

namespace strata::io {

/// Writes items 0..count-1 in order. `format(i, text)` appends item i; blocks of items are formatted in parallel.
template <class Format>
void write_blocks(Sink& sink, std::size_t count, const Format& format) {
  constexpr std::size_t block = 4096, at_a_time = 64;
  std::vector<std::string> text(at_a_time);
  for (std::size_t start = 0; start < count; start += block * at_a_time) {
    const std::size_t blocks = std::min(at_a_time, (count - start + block - 1) / block);
    tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t b) {
      text[b].clear();
      const std::size_t first = start + b * block;
      for (std::size_t i = first; i < std::min(first + block, count); ++i) format(i, text[b]);
    });
    for (std::size_t b = 0; b < blocks; ++b) sink.write(text[b]);
  }
}

/// Appends the shortest digits that read back as the same number.
template <class Number>
void append_number(std::string& text, Number x) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, x).ptr);
}

}  // namespace strata::io
