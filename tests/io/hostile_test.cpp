#include <catch2/catch.hpp>
#include <random>

#include "core/io/readers.h"
#include "support/rounds.h"
#include "tetrahedron.h"

using namespace strata;
using namespace strata::test;

namespace {

/// Changes a few bytes of a valid file: flips, digits, signs, deletions, repetitions, truncation.
std::string damaged(std::string text, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
  constexpr std::string_view alphabet = "0123456789-+.eEnx/ \t\r\n\\#f\0\xff";
  for (std::size_t k = below(4) + 1; k-- > 0 && !text.empty();) {
    const std::size_t at = below(text.size());
    switch (below(6)) {
      case 0:
        text[at] = static_cast<char>(random());
        break;
      case 1:
        text[at] = alphabet[below(alphabet.size())];
        break;
      case 2:
        text.erase(at, below(8) + 1);
        break;
      case 3:
        text.insert(at, text.substr(below(text.size()), below(16)));
        break;
      case 4:
        text.insert(at, 1, alphabet[below(alphabet.size())]);
        break;
      case 5:
        if (below(4) == 0) text.resize(at);
        break;
    }
  }
  return text;
}

/// Reading in pieces of a few bytes comes to the same as reading as a whole.
bool same_in_pieces(const std::string& bytes, Format format) {
  const auto outcome = [&](std::size_t piece) {
    std::pair<MeshFile, std::string> result;
    try {
      result.first = io::read({"test", bytes, piece}, format);
    } catch (const IoError& error) {
      result.second = error.what();
    }
    return result;
  };
  const auto [whole, error] = outcome(std::string::npos);
  const auto [pieces, error_in_pieces] = outcome(5);
  return error == error_in_pieces && whole.mesh == pieces.mesh && whole.notes == pieces.notes &&
         whole.polygon_of_triangle == pieces.polygon_of_triangle && whole.exact.size() == pieces.exact.size();
}

const std::string polygons_obj =
    "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 1 0\nv 0 2 1\nf 1 2 3 4 5\nf -1 -2//3 -3/1\nl 1 2\nf 1 \\\n2 3\n";
const std::string polygons_off = "OFF\n5 2 0\n0 0 0\n2 0 0\n2 2 0\n1 1 0\n0 2 1\n5 0 1 2 3 4\n3 2 1 0 1 0 0\n";
const std::string polygons_xoff =
    "XOFF\n8 2 0\n0 0 1/3\n6 0 1/3\n6 6 2/6\n0 6 1/3\n1 1 1/3\n1 2 1/3\n2 2 1/3\n12/8 1 1/3\n"
    "4 0 1 2 3 + 4 4 5 6 7\n3 2 1 0 # all\n";
const std::string polygons_ply =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty double y\nproperty short z\nproperty uchar "
    "red\n"
    "element face 2\nproperty list uchar int vertex_indices\nproperty list uint8 float uv\nelement tristrips 1\n"
    "property list int int vertex_indices\nend_header\n0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n4 0 1 2 3 1 0.5\n3 0 2 1 0\n"
    "5 0 1 2 -1 3\n";

}  // namespace

TEST_CASE("Damaged files are read or refused, and nothing else happens", "[io][hostile]") {
  const std::pair<Format, std::string> files[] = {{Format::obj, polygons_obj},
                                                  {Format::off, polygons_off},
                                                  {Format::xoff, polygons_xoff},
                                                  {Format::ply, polygons_ply},
                                                  {Format::ply, to_string(tetrahedron, Format::ply)},
                                                  {Format::ply, to_string(tetrahedron, Format::ply_big_endian)},
                                                  {Format::stl, to_string(tetrahedron, Format::stl)},
                                                  {Format::stl, to_string(tetrahedron, Format::stl_ascii)}};
  const int count = test::is_sanitized ? 5'000 : 20'000;
  for (const auto& [format, text] : files) {
    REQUIRE_NOTHROW(read_text(text, format));
    std::mt19937 random(7);
    int refused = 0;
    for (int i = 0; i < count; ++i) {
      const std::string bytes = damaged(text, random);
      if (i % 4 == 0) CHECK(same_in_pieces(bytes, format));
      try {
        const auto file = read_text(bytes, format);
        // Whatever is accepted is fit to be written, unless it does not fit into floats.
        if (i % 16 == 0) (void)to_string(file.mesh, Format::ply);
      } catch (const IoError& error) {
        ++refused;
        if (error.path() != "test" || error.reason().empty()) FAIL(error.what());
      }
    }
    CAPTURE(name(format), refused);
    CHECK(refused * 20 > count);
    CHECK(refused < count);
  }
}

TEST_CASE("Files cut off anywhere are read or refused", "[io][hostile]") {
  for (const Format format : {Format::stl, Format::stl_ascii, Format::obj, Format::off, Format::xoff, Format::ply,
                              Format::ply_ascii, Format::ply_big_endian}) {
    const std::string whole = to_string(tetrahedron, format);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      CAPTURE(name(format), size);
      // The last line end is no loss; an OBJ file says nowhere how long it is.
      if (format == Format::obj || size + 1 == whole.size()) continue;
      const bool name_of_solid = format == Format::stl_ascii && size >= whole.size() - 8;
      if (!name_of_solid) CHECK_FALSE(refusal(std::string_view(whole).substr(0, size), format).empty());
    }
  }
}
