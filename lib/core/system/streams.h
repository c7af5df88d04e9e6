#pragma once
/// Streams of this process, and what else only programs need of files. As in file.h, `errno` says why a call failed.
#include <filesystem>

namespace strata::system {

/// Descriptors of a process's streams.
inline constexpr int standard_input = 0, standard_output = 1, standard_error = 2;

/// Waits until there is something to read, or the end, or an error. False when time is over.
[[nodiscard]] bool wait_to_read(int descriptor, int milliseconds);
[[nodiscard]] bool is_terminal(int descriptor);
/// Lets standard input and output pass all bytes as they are, which only Windows does not do by itself.
void use_binary_streams();

/// Another descriptor of the same file, which no program that is started has. Negative: failed.
[[nodiscard]] int duplicate(int descriptor);

/// Makes a new, empty folder for temporary files, which others may not read. Throws std::filesystem::filesystem_error.
[[nodiscard]] std::filesystem::path make_scratch_folder();

}  // namespace strata::system
