#include "files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <utility>

#include "threads.h"

namespace {

namespace fs = std::filesystem;
using strata::Format;

constexpr const char* writable = "stl, stl-ascii, obj, off, xoff, ply, ply-ascii, ply-big-endian";

void print_notes(const std::string& path, const std::vector<std::string>& notes, const Settings& settings) {
  if (settings.quiet) return;
  for (const std::string& note : notes) fmt::print(stderr, "strata: {}: note: {}\n", path, note);
}

std::string read_all(std::istream& stream, const std::string& name) {
  constexpr std::size_t block = 1 << 20;
  std::string bytes;
  while (stream) {
    const std::size_t before = bytes.size();
    bytes.resize(before + block);
    stream.read(bytes.data() + before, block);
    bytes.resize(before + static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) throw strata::IoError(name, {}, "read error");
  return bytes;
}

std::optional<Format> input_format(const Settings& settings) {
  if (settings.input_format.empty()) return {};
  const auto format = strata::format_named(settings.input_format);
  if (!format) throw UsageError("unknown input format: " + settings.input_format);
  return format;
}

// For formats that are not ours the reader goes by the extension, which the bytes' name supplies where asked for.
strata::MeshFile read_operand(const std::string& path, const Settings& settings) {
  const auto format = input_format(settings);
  if (path == "-") {
    const std::string bytes = read_all(std::cin, "standard input");
    return strata::read_mesh(std::string_view(bytes), *format, "stdin." + settings.input_format);
  }
  if (format == Format::other && fs::is_regular_file(path)) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw strata::IoError(path, {}, std::strerror(errno));
    const std::string bytes = read_all(file, path);
    return strata::read_mesh(std::string_view(bytes), *format, path + "." + settings.input_format);
  }
  return strata::read_mesh(path, format);
}

[[noreturn]] void fail_writing(const std::string& path) { throw strata::IoError(path, {}, std::strerror(errno)); }

void write_and_close(std::FILE* file, const std::string& path, std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0;
  const int error = errno;
  const bool closed = std::fclose(file) == 0;
  if (written && closed) return;
  if (!written) errno = error;
  fail_writing(path);
}

// A path that is no regular file (a device, a pipe) is written in place, all others beside and then renamed.
void write_file(const std::string& path, std::string_view text) {
  const fs::file_status status = fs::status(path);
  const bool in_place = fs::exists(status) && !fs::is_regular_file(status);
  const std::string target = in_place ? path : fmt::format("{}.{}.part", path, getpid());
  std::FILE* file = std::fopen(target.c_str(), "wb");
  if (file == nullptr) fail_writing(path);
  try {
    write_and_close(file, path, text);
    if (!in_place && std::rename(target.c_str(), path.c_str()) != 0) fail_writing(path);
  } catch (const strata::IoError&) {
    if (!in_place) std::remove(target.c_str());
    throw;
  }
}

}  // namespace

std::vector<LoadedMesh> read_operands(const Settings& settings) {
  std::vector<LoadedMesh> operands;
  for (const std::string& path : settings.operands) {
    strata::MeshFile file = on_threads(settings, [&] { return read_operand(path, settings); });
    print_notes(path, file.notes, settings);
    operands.push_back({path, {std::move(file.mesh), std::move(file.exact)}, std::move(file.polygon_of_triangle)});
  }
  return operands;
}

Format output_format(const Settings& settings) {
  if (!settings.output_format.empty()) {
    const auto format = strata::format_named(settings.output_format);
    if (format && *format != Format::other) return *format;
    throw UsageError(
        fmt::format("cannot write the format {}; these can be written: {}", settings.output_format, writable));
  }
  if (settings.output == "-") return Format::stl;
  const Format format = strata::format_of(settings.output);
  if (format != Format::other) return format;
  throw UsageError(
      fmt::format("cannot tell a format from {}; use --format with one of: {}", settings.output, writable));
}

void write_output(const Settings& settings, Format format, const strata::ExactMesh& mesh) {
  if (settings.output == "-") {
    const auto write = [&] { return strata::write_mesh(std::cout, mesh, format, "standard output"); };
    print_notes("standard output", on_threads(settings, write), settings);
    if (!std::cout.flush()) throw strata::IoError("standard output", {}, std::strerror(errno));
  } else {
    const auto write = [&] { return strata::write_mesh(settings.output, mesh, format); };
    print_notes(settings.output, on_threads(settings, write), settings);
  }
}

void write_text(const std::string& where, std::string_view text) {
  if (where != "-") return write_file(where, text);
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    fail_writing("standard output");
  }
}
