#pragma once
#include <initializer_list>
#include <string_view>

#include "common/run.h"
#include "settings.h"

/// Verbs are added to `app`; their options go to `settings`. Outlives the parsing.
struct CommandLine {
  CLI::App& app;
  Settings& settings;
  Action& action;          ///< of the verb that is named
  std::string_view asked;  ///< the verb that is named, where others need not be added; empty: all are

  /// Is one of these to be added? Adding all verbs takes longer than a small Boolean.
  [[nodiscard]] bool wants(std::initializer_list<const char*> verbs) const;

  /// `run` is the action of `verb`.
  void on(CLI::App& verb, Action run);
};

/// union, intersection, difference, symmetric-difference, eval, check, info, convert, compare, view.
void add_boolean_verbs(CommandLine& line);

/// The verbs of the extensions that this build has; those of others are refused with a sentence.
void add_extension_verbs(CommandLine& line);

// Of the extensions scene, bsp, incremental, planar, convex, complex, contact, surface and section.
void add_scene_verbs(CommandLine& line);      ///< draw, layers, locate, ray
void add_partition_verbs(CommandLine& line);  ///< bsp, intervals
void add_chain_verb(CommandLine& line);
void add_planar_verbs(CommandLine& line);   ///< planar, with verbs of its own
void add_shape_verbs(CommandLine& line);    ///< decompose, hull, minkowski, erosion, offset
void add_complex_verbs(CommandLine& line);  ///< topology
void add_contact_verbs(CommandLine& line);  ///< contacts
void add_section_verbs(CommandLine& line);  ///< section, slice
void add_surface_verbs(CommandLine& line);  ///< clip, split, imprint, cells

/// batch: many command lines.
void add_batch_verb(CommandLine& line);

/// formats, schema, completion, manual: what the program says about itself. These need all verbs to be added.
void add_about_verbs(CommandLine& line);

/// verify, fuzz: names of verbs that `strata-verify` has.
void add_suite_verbs(CommandLine& line);
