#include "svg_to_png.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "strata/io/mesh_file.h"

namespace {

namespace fs = std::filesystem;

/// A directory that goes away with all that is in it.
class ScratchDirectory {
 public:
  ScratchDirectory() {
    std::string name = (fs::temp_directory_path() / "strata-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw strata::IoError(name, {}, "cannot make a scratch directory");
    path_ = name;
  }
  ~ScratchDirectory() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;
  [[nodiscard]] fs::path operator/(const char* name) const { return path_ / name; }

 private:
  fs::path path_;
};

}  // namespace

std::string svg_to_png(const std::string& svg) {
  const ScratchDirectory scratch;
  const fs::path in = scratch / "picture.svg", out = scratch / "picture.png";
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
