#pragma once
#include <memory>
#include <string>
#include <vector>

#include "verify/engine.h"

namespace verify {

/// Any program that is called as `COMMAND OPERATION A B OUT` with OFF files, where OPERATION is union, intersection,
/// difference or symmetric-difference. An expression is evaluated step by step, results of steps being operands of the
/// next ones. Exit status: 0 done; 3 refused, 5 has no such operation, both with the reason on standard error; else
/// crashed.
[[nodiscard]] std::unique_ptr<Engine> make_command_engine(std::string name, std::vector<std::string> command,
                                                          double unit_roundoff);

}  // namespace verify
