// Complexes: what is read is a complex, and is written as it was read.
#include <algorithm>
#include <sstream>
#include <string>

#include "fuzz.h"
#include "io_error_law.h"
#include "strata/complex.h"

namespace strata::fuzz {
namespace {

using complex::SelectiveComplex;

SelectiveComplex read(std::string_view text, const char* name) {
  std::istringstream in{std::string(text)};
  return complex::read_sgc(in, name);
}

std::string written(const SelectiveComplex& s) {
  std::ostringstream out;
  complex::write_sgc(out, s);
  return out.str();
}

void check_written(const SelectiveComplex& s) {
  const std::string text = written(s);
  const SelectiveComplex again = read(text, "written");
  require(again == s, "what is written reads back the same");
  require(written(again) == text, "what was written is written again");
}

/// Laws of the operators that need no arrangement.
void check_operators(const SelectiveComplex& s) {
  const SelectiveComplex interior = complex::interior(s), closure = complex::closure(s);
  require(~~s == s, "the complement's complement is the set");
  require(complex::interior(interior) == interior && complex::closure(closure) == closure, "operators are idempotent");
  require(complex::closure(~s) == ~interior, "closure and interior are dual");
}

/// A complex is read by arranging it, every two triangles of it: long files are passed over.
bool is_costly(std::string_view text) { return std::count(text.begin(), text.end(), '\n') > 250; }

void check(std::string_view text) {
  if (is_costly(text)) return;
  const char* file_name = "fuzz.sgc";
  try {
    const SelectiveComplex s = read(text, file_name);
    require(s.count(s.dimension()) > 0, "there is an unbounded cell");
    check_written(s);
    check_written(~s);
    check_operators(s);
  } catch (const IoError& error) {
    check_error(error, file_name);
  }
}

}  // namespace
}  // namespace strata::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return strata::fuzz::run(data, size, [](std::string_view text) { strata::fuzz::check(text); });
}
