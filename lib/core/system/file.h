#pragma once
/// Files by their descriptors, as POSIX and the C library of Windows have them. Nothing is thrown: where a call fails,
/// `errno` says why. Calls that a signal interrupts are repeated.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>

namespace strata::system {

enum class FileMode {
  update,  ///< an old file, to be read and written; nothing of it changes when it is opened
  create,  ///< a new file, or an old one that is emptied
  beside,  ///< a new file; fails with EEXIST where there is one
};

/// A stream of bytes for C's functions. Null: failed.
[[nodiscard]] std::FILE* open_stream(const std::filesystem::path& path, FileMode mode);

/// A descriptor of a file to be read. Programs that are started do not have it. Negative: failed.
[[nodiscard]] int open_to_read(const std::filesystem::path& path);
/// A descriptor of a file to be written, which is made if there is none; `append`: after what it has, otherwise in
/// place of that. Negative: failed.
[[nodiscard]] int open_to_write(const std::filesystem::path& path, bool append);
void close(int descriptor);

/// Copies the next bytes, at most `size`; 0 at the end. Negative: failed.
[[nodiscard]] std::ptrdiff_t read(int descriptor, char* to, std::size_t size);
/// The same from a place, which is that of no other call: threads may share the descriptor. Of regular files.
[[nodiscard]] std::ptrdiff_t read_at(int descriptor, std::uint64_t offset, char* to, std::size_t size);
/// Writes bytes, at most `size`; returns how many. Negative: failed.
[[nodiscard]] std::ptrdiff_t write(int descriptor, const char* bytes, std::size_t size);
/// Sets the place of the next read(). False: failed.
[[nodiscard]] bool go_to(int descriptor, std::uint64_t offset);
/// Bytes of a regular file; 0 of all else.
[[nodiscard]] std::uint64_t size_of(int descriptor);

}  // namespace strata::system
