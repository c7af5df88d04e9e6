#pragma once
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/sink.h"

namespace strata::io {

/// Writes items 0..count-1 in order. `format(first, last, storage)` returns the bytes of some items, at most `block`,
/// stored in a `Storage`. Blocks of items are formatted in parallel, while earlier ones are written.
template <class Storage, class Format>
void write_formatted(Sink& sink, std::size_t count, std::size_t block, const Format& format) {
  struct Block {
    Storage storage;
    std::string_view bytes;
  };
  // Blocks are written in order, so a storage is free when the next block uses it.
  const auto under_way = 2 * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()) + 1;
  std::vector<Block> blocks(under_way);
  std::size_t next = 0;
  const auto number = [&](tbb::flow_control& control) {
    if (next * block >= count) control.stop();
    return next++;
  };
  const auto format_block = [&](std::size_t b) {
    Block& own = blocks[b % under_way];
    own.bytes = format(b * block, std::min((b + 1) * block, count), own.storage);
    return b;
  };
  const auto write_block = [&](std::size_t b) { sink.write(blocks[b % under_way].bytes); };
  constexpr auto in_order = tbb::filter_mode::serial_in_order;
  tbb::parallel_pipeline(under_way,
                         tbb::make_filter<void, std::size_t>(in_order, number) &
                             tbb::make_filter<std::size_t, std::size_t>(tbb::filter_mode::parallel, format_block) &
                             tbb::make_filter<std::size_t, void>(in_order, write_block));
}

/// `format(i, at)` writes item i to `at`, in at most `most` bytes, and returns the position after it.
template <class Format>
void write_blocks(Sink& sink, std::size_t count, std::size_t most, const Format& format) {
  using Bytes = std::unique_ptr<char[]>;
  constexpr std::size_t bytes_per_block = 1U << 18;  // few calls of the system, and some blocks fit into a cache
  const std::size_t block = std::min(bytes_per_block / most + 1, count);
  write_formatted<Bytes>(sink, count, block, [&](std::size_t first, std::size_t last, Bytes& bytes) {
    if (!bytes) bytes = std::make_unique_for_overwrite<char[]>(block * most);
    char* at = bytes.get();
    for (std::size_t i = first; i < last; ++i) at = format(i, at);
    return std::string_view(bytes.get(), static_cast<std::size_t>(at - bytes.get()));
  });
}

/// `append(i, text)` appends item i, of any length, to a text.
template <class Append>
void write_texts(Sink& sink, std::size_t count, const Append& append) {
  constexpr std::size_t block = 2048;
  write_formatted<std::string>(sink, count, block, [&](std::size_t first, std::size_t last, std::string& text) {
    text.clear();
    for (std::size_t i = first; i < last; ++i) append(i, text);
    return std::string_view(text);
  });
}

}  // namespace strata::io
