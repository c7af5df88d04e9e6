#include "openscad_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>
#include <utility>

#include "common/scratch.h"
#include "common/text_file.h"
#include "core/system/program.h"
#include "strata/errors.h"

namespace fs = std::filesystem;

namespace {

/// Runs a program; what it says goes to a file. Its end.
strata::system::ProcessEnd run(std::vector<std::string> command, const fs::path& messages, const Watch& watch) {
  strata::system::Process program({.words = std::move(command), .output = messages, .error = messages});
  while (true) {
    if (const auto end = program.end()) return *end;
    if (watch.token().is_cancelled()) throw strata::Cancelled("cancelled by the caller");
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

/// The lines that tell errors, or all.
std::string reason_in(const std::string& messages) {
  std::string errors;
  for (std::size_t at = 0; at < messages.size();) {
    const std::size_t end = std::min(messages.find('\n', at), messages.size());
    const std::string line = messages.substr(at, end - at);
    if (line.starts_with("ERROR")) errors.append(errors.empty() ? "" : "; ").append(line);
    at = end + 1;
  }
  return errors.empty() ? messages.substr(0, messages.find('\n')) : errors;
}

}  // namespace

std::string csg_of(const std::string& scad, const std::vector<std::string>& definitions, const std::string& program,
                   const Watch& watch) {
  (void)read_file(scad);  // says why it cannot be read
  const Scratch scratch;
  const fs::path csg = scratch.path() / "model.csg", messages = scratch.path() / "messages";
  std::vector<std::string> command{program, "-o", csg.string()};
  for (const std::string& d : definitions) command.insert(command.end(), {"-D", d});
  command.push_back(scad);
  const auto end = run(std::move(command), messages, watch);
  constexpr int not_started = 127;
  if (!end.crashed && end.code == not_started)
    throw strata::IoError(scad, {},
                          fmt::format("the program '{}' cannot be started: install OpenSCAD, name it by --openscad, or "
                                      "give the .csg file that it writes elsewhere",
                                      program));
  if (end.crashed)
    throw strata::IoError(scad, {},
                          fmt::format("{} was ended by {}", program, strata::system::name_of_crash(end.code)));
  if (end.code != 0 || !fs::exists(csg))
    throw strata::IoError(scad, {}, fmt::format("{} says: {}", program, reason_in(read_file(messages.string()))));
  return read_file(csg.string());
}
