#include "openscad_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <optional>
#include <thread>

#include "common/scratch.h"
#include "common/text_file.h"
#include "strata/errors.h"

namespace fs = std::filesystem;

namespace {

/// Runs a program found on the path, without a shell; what it says goes to a file. Its status; none if it cannot be
/// started.
std::optional<int> run(std::vector<std::string> command, const fs::path& messages, const Watch& watch) {
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, stream, messages.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
  pid_t child = 0;
  const int failed = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) return std::nullopt;
  int status = 0;
  while (true) {
    const pid_t ended = waitpid(child, &status, WNOHANG);
    if (ended == child) break;
    if (ended < 0 && errno != EINTR) return std::nullopt;
    if (watch.token().is_cancelled()) {
      kill(child, SIGKILL);
      while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
      throw strata::Cancelled("cancelled by the caller");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
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
  const std::optional<int> status = run(std::move(command), messages, watch);
  if (!status || *status == 127)
    throw strata::IoError(scad, {},
                          fmt::format("the program '{}' cannot be started: install OpenSCAD, name it by --openscad, or "
                                      "give the .csg file that it writes elsewhere",
                                      program));
  if (*status != 0 || !fs::exists(csg))
    throw strata::IoError(scad, {}, fmt::format("{} says: {}", program, reason_in(read_file(messages.string()))));
  return read_file(csg.string());
}
