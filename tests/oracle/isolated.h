#pragma once
#include <functional>
#include <string>

namespace strata::oracle {

/// The text that `work` returns, found in a child process: a crash there is OracleFailed here, and so is an exception,
/// or that it takes longer than that many seconds.
/// The child inherits everything and changes nothing. POSIX.
[[nodiscard]] std::string in_child(const std::function<std::string()>& work, unsigned seconds = 60);

}  // namespace strata::oracle
