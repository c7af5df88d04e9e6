#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "command_line.h"
#include "fuzz/fuzz.h"
#include "settings.h"
#include "verify/verify.h"

namespace {

void add_verify(CommandLine& line) {
  Settings& settings = line.settings;
  const auto verify = std::make_shared<VerifySettings>();
  CLI::App* verb = line.app.add_subcommand("verify", "Cases with one right answer, asked of this engine or of others");
  add_verify_options(*verb, *verify, settings);
  verb->footer(fmt::format(R"(Examples:
  strata verify
  strata verify --tag contact --engine strata --engine manifold3d --report board.html --report results.xml
  strata verify --case ulp-gap-face-union --engine "mine=./my-engine --boolean"

{})",
                           exit_codes));
  line.on(*verb, [&settings, verify] { return run_verify(*verify, settings); });
}

void add_fuzz(CommandLine& line) {
  Settings& settings = line.settings;
  const auto fuzz = std::make_shared<FuzzSettings>();
  CLI::App* verb = line.app.add_subcommand("fuzz", "Random search for broken laws, in this engine or in others");
  add_fuzz_options(*verb, *fuzz, settings);
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
  line.on(*verb, [&settings, fuzz] { return run_fuzz(*fuzz, settings); });
}

}  // namespace

void add_suite_verbs(CommandLine& line) {
  add_verify(line);
  add_fuzz(line);
}
