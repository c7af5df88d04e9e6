#pragma once
/// Foreign readers in a process of their own, so that nothing in them can end this one.
#include <cstddef>
#include <string>

#include "strata/function.h"
#include "strata/io.h"

namespace strata::io {

/// What a foreign reader may use.
struct ReaderLimits {
  std::size_t bytes;  ///< of memory, beside what this process has
  unsigned seconds;   ///< of processor time
};

/// Of a reader of a file of this size: a small file gets half a gigabyte and eight seconds.
[[nodiscard]] ReaderLimits limits_for(std::size_t file_bytes);

/// The result of `read`, which runs in a child of this process, within limits. What it throws of IoError comes back. If
/// it ends in any other way (a signal, an abort, too much memory or time), an IoError says so. `name` is the file's in
/// messages. `read` must not depend on other threads. Costs a fork, and a copy of the mesh through a pipe.
[[nodiscard]] MeshFile read_apart(const std::string& name, const ReaderLimits& limits, FunctionRef<MeshFile()> read);

}  // namespace strata::io
