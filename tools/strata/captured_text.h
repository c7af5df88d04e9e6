#pragma once
#include <cstddef>
#include <string>

#include "strata/function.h"

/// What a record has of a text of so many bytes: the first and the last kilobytes of a long one, with a line
/// "[... bytes]" in place of the rest. `part` gives bytes from a place on.
[[nodiscard]] std::string captured_text(std::size_t size,
                                        strata::FunctionRef<std::string(std::size_t offset, std::size_t size)> part);
