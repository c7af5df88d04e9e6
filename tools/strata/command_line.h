#pragma once
#include <functional>

#include "exit_code.h"
#include "settings.h"

/// What runs once the command line is understood.
using Action = std::function<ExitCode()>;

/// Verbs are added to `app`; their options go to `settings`. Outlives the parsing.
struct CommandLine {
  CLI::App& app;
  Settings& settings;
  Action& action;  ///< of the verb that is named

  /// `run` is the action of `verb`.
  void on(CLI::App& verb, Action run);
};

/// The end of every help text.
inline constexpr const char* exit_codes =
    "Exit codes: 0 ok; 1 the answer is no (different, not a solid); 2 usage; 3 a file cannot be read or written;\n"
    "4 invalid input; 5 the result is not certified; 6 cancelled, out of time or out of memory;\n"
    "70 an error of the program itself.";

/// union, intersection, difference, symmetric-difference, eval, chain, check, info, compare.
void add_boolean_verbs(CommandLine& line);

/// draw, layers, bsp, topology, contacts, locate, ray.
void add_query_verbs(CommandLine& line);

/// decompose, hull, minkowski, erosion, offset.
void add_shape_verbs(CommandLine& line);

/// planar, with verbs of its own.
void add_planar_verbs(CommandLine& line);

/// verify, fuzz.
void add_suite_verbs(CommandLine& line);
