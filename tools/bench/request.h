#pragma once
#include <CLI/CLI.hpp>
#include <string>

#include "strata/options.h"

namespace bench {

/// What is to be measured, and for how long at most.
struct Request {
  std::string case_file;
  strata::Operation operation = strata::Operation::union_;
  strata::InputClass input = strata::InputClass::solid;
  bool one_by_one = false;  ///< operand after operand is joined to the result so far, instead of all at once
  unsigned threads = 1;
  unsigned repetitions = 5;
  double budget = 10;       ///< seconds; no repetition begins after it
  std::string result_file;  ///< where the result of the last repetition goes, unless empty
};

/// The same options for every program that measures.
void add_options(CLI::App& app, Request& request);

}  // namespace bench
