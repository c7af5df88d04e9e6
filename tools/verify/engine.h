#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "verify/case.h"
#include "verify/child.h"
#include "verify/outcome.h"

namespace verify {

/// What came of asking an engine: a file with a mesh, or a verdict why there is none.
struct Answer {
  std::filesystem::path file;  ///< empty: none
  Verdict why_not;
  std::string collapsed = {};  ///< why the file may hold another solid: features that its numbers cannot hold
  double seconds = 0;          ///< of all processes
  std::uint64_t peak_bytes = 0;
};

/// An engine that is asked for the results of cases.
class Engine {
 public:
  virtual ~Engine() = default;
  /// As it is called in reports.
  [[nodiscard]] virtual std::string name() const = 0;
  /// Half the distance of neighbouring numbers of size 1 in the engine's coordinates: 2^-53 for doubles.
  [[nodiscard]] virtual double unit_roundoff() const { return 0x1p-53; }
  /// Evaluates a case in processes of its own; files go to `folder`. Safe to call from many threads.
  [[nodiscard]] virtual Answer ask(const Case& c, const std::filesystem::path& folder, const Limits& limits) const = 0;
};

/// Where engines that are scripts are found.
struct EngineFolders {
  std::string python = "python3";
  std::filesystem::path scripts;
};

/// The words that call a script. Throws std::runtime_error where there is none, or it says that it cannot run.
/// `unit_roundoff`, if given, is set to what the script says of its numbers.
[[nodiscard]] std::vector<std::string> script_command(const EngineFolders& folders, const std::filesystem::path& script,
                                                      double* unit_roundoff = nullptr);

/// "strata" (this program, exact files), "strata-doubles" and "strata-floats" (the same, results rounded), the name of
/// a script in the folder of scripts, or a command: NAME=WORDS or WORDS, to which OPERATION A B OUT is appended for
/// every operation. Throws std::runtime_error where there is no such script, or it says that it cannot run.
[[nodiscard]] std::unique_ptr<Engine> make_engine(const std::string& name, const EngineFolders& folders);

/// "result": the answer is this file, whatever is asked.
[[nodiscard]] std::unique_ptr<Engine> make_given_result(const std::filesystem::path& file, double unit_roundoff);

/// What the end of a process means for programs that keep the rule: 0 done, 3 refused with the reason on standard
/// error, all else crashed. `exact` for 0.
[[nodiscard]] Verdict verdict_of(const ChildEnd& end);

}  // namespace verify
