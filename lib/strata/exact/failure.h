#pragma once
#include <stdexcept>
#include <string>

namespace strata {

/// An invariant of the library does not hold: our fault, or an operand that is not what was declared.
class LogicError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Throws LogicError naming the face in question.
[[noreturn]] inline void fail(const char* what, unsigned face) {
  throw LogicError(std::string(what) + " (face " + std::to_string(face) + ")");
}

}  // namespace strata
