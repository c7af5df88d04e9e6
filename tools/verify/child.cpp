#include "verify/child.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <fstream>
#include <iterator>
#include <optional>
#include <thread>

#include "core/system/program.h"

namespace verify {
namespace {

/// The end of the process, which is killed when time is over.
ChildEnd wait_for(strata::system::Process& process, double seconds) {
  using Clock = std::chrono::steady_clock;
  ChildEnd end;
  const auto start = Clock::now();
  const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  auto pause = std::chrono::microseconds(200);
  std::optional<strata::system::ProcessEnd> ended = process.end();
  for (; !ended; ended = process.end()) {
    if (passed() > seconds && end.how != ChildEnd::How::timed_out) {
      end.how = ChildEnd::How::timed_out;
      process.kill();
    }
    std::this_thread::sleep_for(pause);
    pause = std::min(pause * 5 / 4, std::chrono::microseconds(10'000));
  }
  end.seconds = passed();
  end.peak_bytes = ended->peak_bytes;
  if (end.how == ChildEnd::How::timed_out) return end;
  end.how = ended->crashed ? ChildEnd::How::crashed : ChildEnd::How::exited;
  end.code = ended->code;
  return end;
}

std::string end_of_file(const std::filesystem::path& path) {
  constexpr std::size_t most = 2000;
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.pop_back();
  return text.size() <= most ? text : "... " + text.substr(text.size() - most);
}

}  // namespace

ChildEnd run_child(const std::vector<std::string>& command, const Limits& limits, const std::filesystem::path& folder) {
  constexpr double cpu_per_second = 64;  // many threads; the clock decides, this only ends what outlives the caller
  const std::filesystem::path error = folder / "stderr";
  strata::system::Process process({.words = command,
                                   .folder = folder,
                                   .output = {},
                                   .error = error,
                                   .seconds = limits.seconds * cpu_per_second + 1,
                                   .bytes = limits.bytes});
  ChildEnd end = wait_for(process, limits.seconds);
  end.error = end_of_file(error);
  return end;
}

}  // namespace verify
