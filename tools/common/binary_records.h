#pragma once
#include <bit>
#include <cstddef>

#include "common/output_file.h"
#include "core/io/binary.h"
#include "core/io/blocks.h"

/// Stores a number at `at`, little endian. Returns the place behind it.
template <class T>
char* store(char* at, T value) {
  return strata::io::store(at, value, std::endian::little);
}

/// Writes records 0..count-1 in order. `format(i, at)` puts record i at `at`, in no more than `most` bytes, and returns
/// the place behind it. Blocks of records are formatted in parallel.
template <class Format>
void write_records(OutputFile& file, std::size_t count, std::size_t most, const Format& format) {
  strata::io::write_blocks(file, count, most, format);
}
