#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>

#include "common/description.h"
#include "common/run.h"
#include "common/text_file.h"
#include "core/system/streams.h"
#include "verify/fuzz/fuzz.h"
#include "verify/verify.h"

namespace {

void add_verify(CLI::App& app, VerifySettings& verify, OutputSettings& output, Action& action) {
  CLI::App* verb = app.add_subcommand("verify", "Cases with one right answer, asked of this engine or of others");
  add_verify_options(*verb, verify, output);
  verb->footer(fmt::format(R"(Examples:
  strata verify
  strata verify --tag contact --engine strata --engine manifold3d --report board.html --report results.xml
  strata verify --case ulp-gap-face-union --engine "mine=./my-engine --boolean"

{})",
                           exit_codes));
  verb->callback([&] { action = [&] { return run_verify(verify, output); }; });
}

void add_fuzz(CLI::App& app, FuzzSettings& fuzz, OutputSettings& output, Action& action) {
  CLI::App* verb = app.add_subcommand("fuzz", "Random search for broken laws, in this engine or in others");
  add_fuzz_options(*verb, fuzz, output);
  verb->footer(fmt::format(
      R"(Rounds are questions about solids that touch, of which laws are known: volumes of union and intersection add up, operands
commute, images of results are results of images, ... What does not hold is made small and kept as a case.

Examples:
  strata fuzz --seed 1 --minutes 10
  strata fuzz --seed 1 --rounds 50 --engine manifold3d --engine "mine=./my-engine --boolean"
  strata fuzz --seed 1 --round 17
  strata fuzz --case strata-fuzz-findings/fuzz-volumes-1-17 --engine manifold3d

{})",
      exit_codes));
  verb->callback([&] { action = [&] { return run_fuzz(fuzz, output); }; });
}

/// For `strata completion`, `strata manual` and the site.
void add_description(CLI::App& app, Action& action) {
  CLI::App* verb = app.add_subcommand("describe", "All verbs and options in JSON")->group("");
  verb->callback([&] {
    action = [&] {
      write_text("-", describe(app).dump(1) + "\n");
      return ExitCode::ok;
    };
  });
}

}  // namespace

// Called by `strata verify` and `strata fuzz`, whose name it has in messages.
int main(int argc, char** argv) {
  strata::system::use_binary_streams();
  VerifySettings verify;
  FuzzSettings fuzz;
  OutputSettings output;
  Action action;
  CLI::App app("The exactness suite and the random search of Strata", "strata");
  app.allow_windows_style_options(false);  // /a is a path
  app.set_version_flag("--version", "strata " STRATA_VERSION);
  app.require_subcommand(1);
  app.footer(exit_codes);
  add_verify(app, verify, output, action);
  add_fuzz(app, fuzz, output, action);
  add_description(app, action);
  return run_program(app, argc, argv, action, {});
}
