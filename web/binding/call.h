#pragma once
/// What every function for JavaScript shares: names, errors, and what is answered besides a number.
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "strata/errors.h"
#include "strata/function.h"
#include "strata/options.h"

/// A function by its own name in the module.
#define STRATA_WEB(name) extern "C" __attribute__((export_name("strata_" #name)))

namespace strata::web {

/// What JavaScript copies after a call: valid until the next one.
struct Answer {
  std::string bytes;           ///< files, texts, JSON
  std::vector<double> reals;   ///< coordinates, numbers
  std::vector<unsigned> ints;  ///< handles, indices
  std::string error;           ///< JSON of what was thrown; empty if the call succeeded
};
[[nodiscard]] Answer& answer();

/// Runs a function. What it throws becomes the error of the answer, and the call returns 0. What JavaScript throws in a
/// callback goes through unchanged, since `catch` sees the exceptions of C++ only.
unsigned guarded(FunctionRef<unsigned()> work);

/// Options whose progress goes to JavaScript, which stops an operation by throwing there.
[[nodiscard]] Options watched();

/// Defects as JSON.
[[nodiscard]] std::string defects_text(std::span<const Defect> defects);

}  // namespace strata::web
