#include "svg_to_png.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "common/scratch.h"
#include "core/system/program.h"
#include "strata/io.h"

namespace fs = std::filesystem;

std::string svg_to_png(const std::string& svg) {
  const Scratch scratch;
  const fs::path in = scratch.path() / "picture.svg", out = scratch.path() / "picture.png";
  std::ofstream(in, std::ios::binary) << svg;
  strata::system::Process program(
      {.words = {"rsvg-convert", "--format", "png", "--output", out.string(), in.string()}});
  if (const auto end = program.wait(); end.crashed || end.code != 0)
    throw strata::IoError("PNG", {},
                          "rsvg-convert (package librsvg2-bin) is not installed, or failed; SVG needs no help");
  std::ifstream file(out, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}
