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

using Verbs = std::initializer_list<const char*>;

/// Verbs that are named in no help, and refused.
[[maybe_unused]] void add_missing(CommandLine& line, const char* extension, Verbs verbs) {
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

ExitCode run_model([[maybe_unused]] Settings& settings) {
#if STRATA_HAS_OPENSCAD
  return run_model_file(settings);
#else
  refuse("a model (.csg, .scad)", "openscad");
#endif
}

void add_extension_verbs(CommandLine& line) {
  if (const Verbs verbs = {"chain"}; line.wants(verbs))
#if STRATA_HAS_INCREMENTAL
    add_chain_verb(line);
#else
    add_missing(line, "incremental", verbs);
#endif
  if (const Verbs verbs = {"draw", "layers", "locate", "ray"}; line.wants(verbs))
#if STRATA_HAS_SCENE
    add_scene_verbs(line);
#else
    add_missing(line, "scene", verbs);
#endif
  if (const Verbs verbs = {"bsp", "intervals"}; line.wants(verbs))
#if STRATA_HAS_BSP
    add_partition_verbs(line);
#else
    add_missing(line, "bsp", verbs);
#endif
  if (const Verbs verbs = {"topology"}; line.wants(verbs))
#if STRATA_HAS_COMPLEX
    add_complex_verbs(line);
#else
    add_missing(line, "complex", verbs);
#endif
  if (const Verbs verbs = {"contacts"}; line.wants(verbs))
#if STRATA_HAS_CONTACT
    add_contact_verbs(line);
#else
    add_missing(line, "contact", verbs);
#endif
  if (const Verbs verbs = {"clip", "split", "imprint", "cells"}; line.wants(verbs))
#if STRATA_HAS_SURFACE
    add_surface_verbs(line);
#else
    add_missing(line, "surface", verbs);
#endif
  if (const Verbs verbs = {"section", "slice"}; line.wants(verbs))
#if STRATA_HAS_SECTION
    add_section_verbs(line);
#else
    add_missing(line, "section", verbs);
#endif
  if (const Verbs verbs = {"decompose", "hull", "minkowski", "erosion", "offset"}; line.wants(verbs))
#if STRATA_HAS_CONVEX
    add_shape_verbs(line);
#else
    add_missing(line, "convex", verbs);
#endif
  if (const Verbs verbs = {"planar"}; line.wants(verbs))
#if STRATA_HAS_PLANAR
    add_planar_verbs(line);
#else
    add_missing(line, "planar", verbs);
#endif
}
