#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <string>
#include <vector>

#include "module.h"
#include "run_command.h"
#include "suite.h"

namespace strata::python {

namespace {

/// What main() of the command line does.
int run_command_line(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const nanobind::gil_scoped_release released;
  if (words.size() > 1 && is_suite_verb(words[1])) return become_suite(arguments.data());
  return run_command(static_cast<int>(words.size()), arguments.data());
}

}  // namespace

void bind_command_line(nanobind::module_& m) {
  m.def("_run_command_line", run_command_line, nanobind::arg("words"),
        "Runs the command line `strata` in this process: its exit code.");
}

}  // namespace strata::python
