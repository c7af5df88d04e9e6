#pragma once
#include <filesystem>

/// A folder that comes with the program, such as "data/cases": below the working directory, else below a folder that
/// holds the program, in `share/strata` there or plainly (a source tree that was built in). Nothing is compiled in, so
/// that an installed tree can be moved. Returns `name` itself where none is found.
[[nodiscard]] std::filesystem::path shared_folder(const std::filesystem::path& name);
