#include "model_file.h"

#include <fmt/format.h>

#include <utility>

#include "strata/errors.h"
#include "strata/openscad.h"

strata::Expression read_model_file(const Settings& settings) {
  try {
    strata::CsgModel model = strata::read_csg_file(settings.expression, settings.placement);
    if (!settings.quiet)
      for (const std::string& note : model.notes)
        fmt::print(stderr, "strata: {}: note: {}\n", settings.expression, note);
    return std::move(model.expression);
  } catch (const strata::CsgError& error) {
    throw strata::IoError(error.file(), {error.line(), {}},
                          fmt::format("column {}: {}", error.column(), error.reason()));
  }
}
