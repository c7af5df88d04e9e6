#pragma once
#include <iosfwd>
#include <string>

#include "strata/complex/selective_complex.h"

namespace strata::complex {

/// Writes the text of a complex: sgc.md. Equal sets give equal bytes.
void write_sgc(std::ostream& out, const SelectiveComplex& s);
/// To a file, which is complete or not there. Throws IoError.
void write_sgc(const std::string& path, const SelectiveComplex& s);

/// Reads it and checks that cells meet as it says, by arranging them anew. Throws IoError with the line.
[[nodiscard]] SelectiveComplex read_sgc(std::istream& in, const std::string& name);
[[nodiscard]] SelectiveComplex read_sgc(const std::string& path);

}  // namespace strata::complex
