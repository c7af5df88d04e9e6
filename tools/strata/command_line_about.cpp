#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "about.h"
#include "command_line.h"
#include "common/description.h"
#include "common/text_file.h"
#include "suite.h"

namespace {

/// All verbs, with those that `strata-verify` has where it is there.
Json describe_all(const CLI::App& app) {
  Json program = describe(app);
  const Json suite = suite_description();
  for (Json& verb : program["verbs"])
    for (const Json& other : suite)
      if (other["name"] == verb["name"]) verb = other;
  return program;
}

void add_schema(CommandLine& line) {
  CLI::App* verb = line.app.add_subcommand("schema", "The JSON Schema of what --report writes");
  const auto words = std::make_shared<std::vector<std::string>>();
  verb->add_option("VERB", *words, "The verb, as union, or planar union; none: lists those that have a schema");
  verb->footer("Example:\n  strata schema union > union.schema.json");
  line.on(*verb, [words] {
    if (words->empty())
      fmt::print("{}\n", fmt::join(verbs_with_schema(), "\n"));
    else
      fmt::print("{}\n", report_schema(fmt::format("{}", fmt::join(*words, " "))).dump(2));
    return ExitCode::ok;
  });
}

void add_completion(CommandLine& line) {
  CLI::App* verb = line.app.add_subcommand("completion", "A script that completes verbs, options and their words");
  const auto shell = std::make_shared<std::string>();
  verb->add_option("SHELL", *shell, "bash, zsh or fish")->required()->check(CLI::IsMember({"bash", "zsh", "fish"}));
  verb->footer(
      "Examples:\n  source <(strata completion bash)\n  strata completion zsh > ~/.zfunc/_strata\n"
      "  strata completion fish > ~/.config/fish/completions/strata.fish");
  line.on(*verb, [&line, shell] {
    write_text("-", completion(describe_all(line.app), *shell));
    return ExitCode::ok;
  });
}

void add_manual(CommandLine& line) {
  CLI::App* verb = line.app.add_subcommand("manual", "A manual page, as man(1) reads it");
  const auto words = std::make_shared<std::vector<std::string>>();
  const auto folder = std::make_shared<std::string>();
  verb->add_option("VERB", *words, "The verb, as union, or planar union; none: the page of the program");
  verb->add_option("--all", *folder, "Write all pages into this folder")->type_name("DIR");
  verb->footer("Examples:\n  strata manual union | man -l -\n  strata manual --all share/man/man1");
  line.on(*verb, [&line, words, folder] {
    const Json program = describe_all(line.app);
    if (!folder->empty())
      write_manual(program, *folder);
    else
      write_text("-", manual_page(program, *words));
    return ExitCode::ok;
  });
}

}  // namespace

void add_about_verbs(CommandLine& line) {
  if (line.wants({"formats"})) {
    CLI::App* verb = line.app.add_subcommand("formats", "The formats of files that can be read and written");
    line.on(*verb, print_formats);
  }
  if (line.wants({"schema"})) add_schema(line);
  if (line.wants({"completion"})) add_completion(line);
  if (line.wants({"manual"})) add_manual(line);
  if (line.wants({"describe"})) {  // for tools/site and tests
    CLI::App* verb = line.app.add_subcommand("describe", "All verbs and options in JSON")->group("");
    line.on(*verb, [&line] {
      write_text("-", describe_all(line.app).dump(1) + "\n");
      return ExitCode::ok;
    });
  }
}
