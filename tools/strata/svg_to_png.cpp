#include "svg_to_png.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "common/scratch.h"
#include "strata/io.h"

namespace fs = std::filesystem;

namespace {

/// Runs a program found on the path, without a shell; what it says on standard error is dropped. True when it succeeds.
bool succeeds(std::vector<std::string> command) {
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int failed = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) return false;
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return false;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

std::string svg_to_png(const std::string& svg) {
  const Scratch scratch;
  const fs::path in = scratch.path() / "picture.svg", out = scratch.path() / "picture.png";
  std::ofstream(in, std::ios::binary) << svg;
  if (!succeeds({"rsvg-convert", "--format", "png", "--output", out.string(), in.string()}))
    throw strata::IoError("PNG", {},
                          "rsvg-convert (package librsvg2-bin) is not installed, or failed; SVG needs no help");
  std::ifstream file(out, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}
