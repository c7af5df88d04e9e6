#pragma once

/// What `strata ARGUMENTS` does, from the parsing to the exit code, in this process. `arguments` begins with the name
/// of the program and ends with a null pointer, as those of main() do. May be called many times, one call after the
/// other. `threads`: how many are used where no -j says otherwise; 0: all cores.
[[nodiscard]] int run_command(int count, char** arguments, unsigned threads = 0);
