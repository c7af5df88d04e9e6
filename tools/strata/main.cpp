#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

#include "draw.h"
#include "exit_code.h"
#include "settings.h"
#include "strata/io/mesh_file.h"
#include "strata/mesh/defect.h"
#include "verbs.h"

namespace {

using Action = std::function<ExitCode()>;

constexpr const char* exit_codes =
    "Exit codes: 0 ok; 1 the answer is no (different, not a solid); 2 usage; 3 a file cannot be read or written;\n"
    "4 invalid input; 5 the result is not certified; 6 cancelled, out of time or out of memory.";

constexpr const char* examples = R"(Examples:
  strata union left.stl right.stl -o both.stl
  strata difference block.obj drill1.stl drill2.ply -o part.ply --certify --report part.json
  strata intersection a.glb b.3mf -o common.obj --input repair
  cat a.off | strata xor - b.off --input-format off -o - --format off > changed.off
  strata check scan.stl
  strata compare yesterday.stl today.obj

)";

void add_boolean(CLI::App& app, Settings& settings, Action& action, strata::Operation operation, const char* name,
                 const std::string& what) {
  CLI::App* verb = app.add_subcommand(name, what);
  add_common_options(*verb, settings, 2, 0);
  add_input_class(*verb, settings);
  add_output_options(*verb, settings);
  verb->footer(fmt::format("Example:\n  strata {} A.stl B.stl -o OUT.stl\n\n{}", name, exit_codes));
  verb->callback(
      [&, operation, name] { action = [&, operation, name] { return run_boolean(operation, name, settings); }; });
}

void add_verbs(CLI::App& app, Settings& settings, Action& action) {
  using strata::Operation;
  add_boolean(app, settings, action, Operation::unite, "union", "What is in any of the meshes");
  add_boolean(app, settings, action, Operation::intersect, "intersection", "What is in all of the meshes");
  add_boolean(app, settings, action, Operation::subtract, "difference", "What is in the first mesh and in no other");
  add_boolean(app, settings, action, Operation::exclude, "xor", "What is in an odd number of the meshes");

  CLI::App* check =
      app.add_subcommand("check", "Is the mesh the boundary of a solid? Lists every defect, writes nothing");
  add_common_options(*check, settings, 1, 1);
  check->footer(fmt::format("Example:\n  strata check scan.stl\n\n{}", exit_codes));
  check->callback([&] { action = [&] { return run_check(settings); }; });

  CLI::App* info = app.add_subcommand("info", "Counts, measures and defects of a mesh, whatever its state");
  add_common_options(*info, settings, 1, 1);
  info->footer(fmt::format("Example:\n  strata info scan.stl --report -\n\n{}", exit_codes));
  info->callback([&] { action = [&] { return run_info(settings); }; });

  CLI::App* compare = app.add_subcommand("compare", "Are two meshes equal as point sets, exactly?");
  add_common_options(*compare, settings, 2, 2);
  add_input_class(*compare, settings);
  compare->footer(fmt::format("Example:\n  strata compare before.stl after.obj\n\n{}", exit_codes));
  compare->callback([&] { action = [&] { return run_compare(settings); }; });
}

void add_draw(CLI::App& app, Settings& settings, DrawSettings& draw_settings, Action& action) {
  CLI::App* draw = app.add_subcommand("draw", "A picture, hidden lines removed exactly, as SVG or PNG");
  add_common_options(*draw, settings, 1, 0);
  add_input_class(*draw, settings);
  add_draw_options(*draw, draw_settings);
  draw->add_option("-o,--output", settings.output, "The picture, .svg or .png; - is standard output")
      ->required()
      ->type_name("OUT");
  draw->footer(fmt::format("Example:\n  strata draw part.stl --direction 1,2,-1 -o part.svg\n\n{}", exit_codes));
  draw->callback([&] { action = [&] { return run_draw(draw_settings, settings); }; });
}

ExitCode complain(ExitCode code, const std::string& message) {
  std::fputs(("strata: " + message + "\n").c_str(), stderr);
  return code;
}

ExitCode complain(const strata::InputError& error, const Settings& settings) {
  const std::string& path = settings.operands.at(error.operand());
  for (const strata::Defect& defect : error.defects()) {
    fmt::print(stderr, "strata: {}: {}: {}\n", path, strata::name(defect.severity), strata::describe(defect));
  }
  return complain(ExitCode::invalid_input, path + " is not what was declared; no result was written");
}

ExitCode run(const Action& action, const Settings& settings) {
  try {
    check_streams(settings);
    const ExitCode code = action();
    return std::fflush(stdout) == 0 ? code : complain(ExitCode::file, "standard output cannot be written");
  } catch (const UsageError& error) {
    return complain(ExitCode::usage, error.what());
  } catch (const strata::IoError& error) {
    return complain(ExitCode::file, error.what());
  } catch (const std::system_error& error) {
    return complain(ExitCode::file, error.what());
  } catch (const strata::InputError& error) {
    return complain(error, settings);
  } catch (const strata::Cancelled& error) {
    return complain(ExitCode::stopped, std::string(error.what()) + "; no result was written");
  } catch (const std::bad_alloc&) {
    return complain(ExitCode::stopped, "out of memory");
  } catch (const std::length_error& error) {
    return complain(ExitCode::stopped, error.what());
  } catch (const std::exception& error) {
    return complain(ExitCode::not_certified, std::string("an error of the program, please report it: ") + error.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  DrawSettings draw_settings;
  Action action;
  CLI::App app("Exact Booleans of meshes, on the doubles in the files", "strata");
  app.set_version_flag("--version", "strata " STRATA_VERSION);
  app.require_subcommand(1);
  app.footer(std::string(examples) + exit_codes);
  add_verbs(app, settings, action);
  add_draw(app, settings, draw_settings, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::usage);
  }
  return static_cast<int>(run(action, settings));
}
