#include "extensions.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <initializer_list>
#include <string>

#include "command_line.h"
#if STRATA_HAS_SCENE
#include "strata/query.h"
#endif
#if STRATA_HAS_BSP
#include "strata/bsp.h"
#endif
#if STRATA_HAS_OPENSCAD
#include "model_file.h"
#endif

namespace {

[[noreturn]] void refuse(const std::string& what, const char* extension) {
  throw UsageError(fmt::format("{} needs the extension {}, which this build of strata does not have", what, extension));
}

/// Verbs that are named in no help, and refused.
[[maybe_unused]] void add_missing(CommandLine& line, const char* extension, std::initializer_list<const char*> verbs) {
  for (const char* name : verbs) {
    CLI::App* verb = line.app.add_subcommand(name)->group("")->prefix_command();
    verb->set_help_flag();
    line.on(*verb, [name, extension]() -> ExitCode { refuse(name, extension); });
  }
}

}  // namespace

std::vector<const strata::Engine*> boolean_engines() {
  std::vector<const strata::Engine*> engines = formula_engines();
#if STRATA_HAS_BSP
  engines.push_back(&strata::bsp_engine);
#endif
  return engines;
}

std::vector<const strata::Engine*> formula_engines() {
#if STRATA_HAS_SCENE
  return {&strata::layer_engine};
#else
  return {};
#endif
}

std::vector<const strata::Engine*> locating_engines() {
#if STRATA_HAS_BSP
  return {&strata::bsp_engine};
#else
  return {};
#endif
}

strata::Expression read_model([[maybe_unused]] const Settings& settings) {
#if STRATA_HAS_OPENSCAD
  return read_model_file(settings);
#else
  refuse("a model (.csg)", "openscad");
#endif
}

void add_extension_verbs(CommandLine& line) {
#if STRATA_HAS_INCREMENTAL
  add_chain_verb(line);
#else
  add_missing(line, "incremental", {"chain"});
#endif
#if STRATA_HAS_SCENE
  add_scene_verbs(line);
#else
  add_missing(line, "scene", {"draw", "layers", "locate", "ray"});
#endif
#if STRATA_HAS_BSP
  add_partition_verbs(line);
#else
  add_missing(line, "bsp", {"bsp", "intervals"});
#endif
#if STRATA_HAS_COMPLEX
  add_complex_verbs(line);
#else
  add_missing(line, "complex", {"topology"});
#endif
#if STRATA_HAS_CONTACT
  add_contact_verbs(line);
#else
  add_missing(line, "contact", {"contacts"});
#endif
#if STRATA_HAS_SURFACE
  add_surface_verbs(line);
#else
  add_missing(line, "surface", {"clip", "split", "imprint", "cells"});
#endif
#if STRATA_HAS_SECTION
  add_section_verbs(line);
#else
  add_missing(line, "section", {"section", "slice"});
#endif
#if STRATA_HAS_CONVEX
  add_shape_verbs(line);
#else
  add_missing(line, "convex", {"decompose", "hull", "minkowski", "erosion", "offset"});
#endif
#if STRATA_HAS_PLANAR
  add_planar_verbs(line);
#else
  add_missing(line, "planar", {"planar"});
#endif
}
