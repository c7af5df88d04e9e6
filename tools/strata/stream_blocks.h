#pragma once
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <cstddef>
#include <exception>
#include <vector>

/// Streams blocks through `read(block)`, which returns false at the end, `work(block)`, and `write(block)`. Reading and
/// writing go one by one in order; work is done in parallel meanwhile. There are few blocks at a time, and they are
/// used again, so memory is bounded. What `work` throws is thrown when the block's turn to be written comes: of several
/// errors the first in the input, whatever the number of threads.
template <class Block, class Read, class Work, class Write>
void stream_blocks(const Read& read, const Work& work, const Write& write) {
  struct Slot {
    Block block;
    std::exception_ptr error;
  };
  // Blocks are written in order, so the one that had the same slot is gone when the next one takes it.
  const auto under_way = 2 * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()) + 1;
  std::vector<Slot> slots(under_way);
  std::size_t next = 0;
  const auto read_block = [&](tbb::flow_control& control) -> Slot* {
    Slot& slot = slots[next++ % under_way];
    if (!read(slot.block)) control.stop();
    return &slot;
  };
  const auto work_on = [&](Slot* slot) {
    try {
      work(slot->block);
    } catch (...) {
      slot->error = std::current_exception();
    }
    return slot;
  };
  const auto write_block = [&](Slot* slot) {
    if (slot->error) std::rethrow_exception(slot->error);
    write(slot->block);
  };
  constexpr auto in_order = tbb::filter_mode::serial_in_order;
  tbb::parallel_pipeline(under_way, tbb::make_filter<void, Slot*>(in_order, read_block) &
                                        tbb::make_filter<Slot*, Slot*>(tbb::filter_mode::parallel, work_on) &
                                        tbb::make_filter<Slot*, void>(in_order, write_block));
}
