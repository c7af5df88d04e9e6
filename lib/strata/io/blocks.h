#pragma once
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "strata/io/sink.h"

namespace strata::io {

/// Writes items 0..count-1 in order. `format(i, at)` puts item i at `at`, in no more than `most` bytes, and returns the
/// place behind it. Blocks of items are formatted in parallel, while earlier ones are written.
template <class Format>
void write_blocks(Sink& sink, std::size_t count, std::size_t most, const Format& format) {
  constexpr std::size_t block = 2048;
  struct Block {
    std::unique_ptr<char[]> bytes;
    std::size_t size = 0;
  };
  // Blocks are written in order, so the one that had the same buffer is gone when the next one takes it.
  const auto under_way = 2 * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()) + 1;
  std::vector<Block> blocks(under_way);
  std::size_t next = 0;
  const auto number = [&](tbb::flow_control& control) {
    if (next * block >= count) control.stop();
    return next++;
  };
  const auto format_block = [&](std::size_t b) {
    Block& own = blocks[b % under_way];
    if (!own.bytes) own.bytes = std::make_unique_for_overwrite<char[]>(block * most);
    char* at = own.bytes.get();
    for (std::size_t i = b * block; i < std::min((b + 1) * block, count); ++i) at = format(i, at);
    own.size = static_cast<std::size_t>(at - own.bytes.get());
    return b;
  };
  const auto write_block = [&](std::size_t b) {
    const Block& own = blocks[b % under_way];
    sink.write({own.bytes.get(), own.size});
  };
  constexpr auto in_order = tbb::filter_mode::serial_in_order;
  tbb::parallel_pipeline(under_way,
                         tbb::make_filter<void, std::size_t>(in_order, number) &
                             tbb::make_filter<std::size_t, std::size_t>(tbb::filter_mode::parallel, format_block) &
                             tbb::make_filter<std::size_t, void>(in_order, write_block));
}

}  // namespace strata::io
