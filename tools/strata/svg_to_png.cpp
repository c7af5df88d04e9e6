#include "svg_to_png.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "scratch.h"
#include "strata/io/mesh_file.h"

namespace fs = std::filesystem;

std::string svg_to_png(const std::string& svg) {
  const Scratch scratch;
  const fs::path in = scratch.path() / "picture.svg", out = scratch.path() / "picture.png";
  std::ofstream(in, std::ios::binary) << svg;
  // The paths are our own: no characters that a shell would read.
  const std::string command =
      "rsvg-convert --format png --output '" + out.string() + "' '" + in.string() + "' 2>/dev/null";
  if (std::system(command.c_str()) != 0)
    throw strata::IoError("PNG", {},
                          "rsvg-convert (package librsvg2-bin) is not installed, or failed; SVG needs no help");
  std::ifstream file(out, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}
