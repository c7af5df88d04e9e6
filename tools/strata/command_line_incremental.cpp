#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "chain.h"
#include "command_line.h"
#include "settings.h"

void add_chain_verb(CommandLine& line) {
  Settings& settings = line.settings;
  const auto chain = std::make_shared<ChainSettings>();
  CLI::App* verb =
      line.app.add_subcommand("chain", "Many steps, one after the other, exactly; may be stopped and resumed");
  add_chain_options(*verb, *chain, settings);
  add_run_options(*verb, settings);
  add_input_class(*verb, settings);
  add_attribute_options(*verb, settings);
  add_output_options(*verb, settings);
  verb->footer(fmt::format(
      R"text(STEPS.json, with paths relative to it; "start" may be null, "label", "input" and "transform" left out:
  {{"start": {{"file": "block.stl"}},
   "steps": [{{"operation": "difference", "file": "drill.stl", "label": "hole", "input": "solid",
              "transform": [[1, 0, 0, "1/3"], [0, 1, 0, 2], [0, 0, 1, 0.5], [0, 0, 0, 1]]}}]}}

Examples:
  strata chain part.json -o part.xoff --report part-report.json --exact-volumes
  strata chain part.json -o part.stl --checkpoint part.save --checkpoint-every 100 --timeout 3600
  strata chain part.json -o part.stl --checkpoint part.save --resume part.save

{})text",
      exit_codes));
  line.on(*verb, [&settings, chain] { return run_chain(*chain, settings); });
}
