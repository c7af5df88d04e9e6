#pragma once

/// What the process tells its caller.
enum class ExitCode : int {
  ok = 0,
  negative = 1,       ///< the answer is no: different, not a solid, not all jobs ok
  usage = 2,          ///< the command line makes no sense
  file = 3,           ///< a file cannot be read or written
  invalid_input = 4,  ///< an operand is not what was declared
  not_certified = 5,  ///< the result was made, but is not certified
  stopped = 6,        ///< cancelled, out of time or out of memory
  internal = 70,      ///< an error of the program itself; the number is that of EX_SOFTWARE in sysexits.h
};

/// The end of every help text.
inline constexpr const char* exit_codes =
    "Exit codes: 0 ok; 1 the answer is no (different, not a solid, not all jobs ok); 2 usage; 3 a file cannot be read "
    "or\n"
    "written; 4 invalid input; 5 the result is not certified; 6 cancelled, out of time or out of memory;\n"
    "70 an error of the program itself.";
