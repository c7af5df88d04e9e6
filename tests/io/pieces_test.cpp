// Reading in pieces must not show: every piece size gives the same mesh, the same notes and the same errors.
#include "core/io/pieces.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <fstream>
#include <limits>
#include <random>

#include "core/io/binary.h"
#include "core/io/readers.h"
#include "core/system/program.h"
#include "tetrahedron.h"

using namespace strata;
using namespace strata::test;
namespace fs = std::filesystem;

namespace {

constexpr std::size_t whole = std::numeric_limits<std::size_t>::max();

/// What reading comes to, in a form that can be compared.
struct Outcome {
  MeshFile file;
  std::string error;

  friend bool operator==(const Outcome& a, const Outcome& b) {
    const auto same = [](const ExactVertex& x, const ExactVertex& y) {
      return x.vertex == y.vertex && x.position == y.position;
    };
    const auto &p = a.file.exact, &q = b.file.exact;
    return a.error == b.error && a.file.mesh == b.file.mesh && a.file.notes == b.file.notes &&
           a.file.polygon_of_triangle == b.file.polygon_of_triangle && a.file.attributes == b.file.attributes &&
           std::equal(p.begin(), p.end(), q.begin(), q.end(), same);
  }
};

Outcome outcome(std::string_view text, Format format, std::size_t piece) {
  try {
    return {io::read({"test", text, piece}, format), {}};
  } catch (const IoError& error) {
    return {{}, error.what()};
  }
}

void check_all_sizes(const std::string& text, Format format) {
  const Outcome expected = outcome(text, format, whole);
  for (const std::size_t piece : {1, 2, 3, 7, 16, 61, 250, 1000}) {
    CAPTURE(name(format), piece, text.substr(0, 300), expected.error);
    CHECK(outcome(text, format, piece) == expected);
  }
}

/// Reads in small pieces and wants a mesh: the text keeps the assumptions or does not, it is well-formed.
Mesh read_small(const std::string& text, Format format, std::size_t piece = 20) {
  check_all_sizes(text, format);
  return io::read({"test", text, piece}, format).mesh;
}

/// A strip of triangles over points that come again and again, in any order.
Mesh shuffled_strip(std::uint32_t seed, std::uint32_t size) {
  std::mt19937 random(seed);
  Mesh mesh;
  for (std::uint32_t i = 0; i < size; ++i)
    mesh.vertices.push_back(
        {static_cast<double>(random() % 1000) / 8, static_cast<double>(i), i % 2 == 0 ? 0.0 : -0.0});
  for (std::uint32_t i = 0; i < 3 * size; ++i) {
    const auto corner = [&] { return static_cast<std::uint32_t>(random() % size); };
    mesh.triangles.push_back({corner(), corner(), corner()});
  }
  return mesh;
}

std::string with_line_ends(const std::string& text, const std::string& end) {
  std::string result;
  for (const char c : text) result += c == '\n' ? end : std::string(1, c);
  return result;
}

constexpr Format text_formats[] = {Format::stl_ascii, Format::obj, Format::off, Format::xoff, Format::ply_ascii};
constexpr Format all_formats[] = {Format::stl,  Format::stl_ascii, Format::obj,       Format::off,
                                  Format::xoff, Format::ply,       Format::ply_ascii, Format::ply_big_endian};

const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";

}  // namespace

TEST_CASE("Texts are split at line ends that end a line in any case", "[io][pieces]") {
  const std::string text = "aaaa\r\nbb\\\ncccc\rdd\n\neeee";
  // Not between CR and LF, not behind the backslash.
  CHECK(io::next_line(text, 0) == 6);
  CHECK(io::next_line(text, 5) == 6);
  CHECK(io::next_line(text, 6) == 15);
  CHECK(io::next_line(text, 9) == 15);
  CHECK(io::next_line(text, 18) == 19);
  CHECK(io::next_line(text, 19) == text.size());
  for (std::size_t size = 1; size < 30; ++size) {
    const auto pieces = io::split_at_lines(text, 2, size);
    CHECK(pieces.front().first == 2);
    CHECK(pieces.back().last == text.size());
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
      CHECK(pieces[i].last == pieces[i + 1].first);
      CHECK(pieces[i].size() >= size);
    }
  }
  CHECK(io::split_at_lines(text, 0, 1).size() == 4);
}

TEST_CASE("A mesh is read alike in pieces of any size", "[io][pieces][property]") {
  const auto seed = GENERATE(range(0u, 5u));
  const Mesh mesh = shuffled_strip(seed, 40);
  for (const Format format : all_formats) check_all_sizes(to_string(mesh, format), format);
}

TEST_CASE("Line ends of all kinds, and none at the end, are read alike in pieces", "[io][pieces]") {
  const Mesh mesh = shuffled_strip(1, 20);
  for (const Format format : text_formats)
    for (const char* end : {"\n", "\r\n", "\r", "\n\n", " \n\t\r\n"}) {
      std::string text = with_line_ends(to_string(mesh, format), end);
      // Blank lines are not for the header of a PLY file.
      if (format == Format::ply_ascii && std::string_view(end).size() > 2) continue;
      CHECK(read_small(text, format).triangles.size() <= mesh.triangles.size());
      while (text.back() <= ' ') text.pop_back();
      CHECK(read_small(text, format).vertices.size() <= mesh.vertices.size());
    }
}

TEST_CASE("One line longer than all pieces is read alike", "[io][pieces]") {
  // Catches a search for line ends that gives up at the end of a piece.
  std::string fan = "f", flat = "OFF\n3000 1 0\n", face = "3000";
  std::string points;
  for (int i = 1; i <= 3000; ++i) {
    const std::string point = std::to_string(i) + " " + std::to_string(i * i) + " 0\n";
    points.append("v ").append(point);
    fan.append(" ").append(std::to_string(i));
    flat.append(point);
    face.append(" ").append(std::to_string(i - 1));
  }
  CHECK(read_small(points + fan + "\nv 1 2 3", Format::obj).triangles.size() == 2998);
  CHECK(read_small(std::string(20'000, '#') + "\n" + corners + "f 1 2 3\n", Format::obj).triangles.size() == 1);
  CHECK(read_small(flat + face, Format::off).triangles.size() == 2998);
  std::string stl = to_string(tetrahedron, Format::stl_ascii);
  for (char& c : stl)
    if (c == '\n') c = ' ';
  // The name of a solid ends with its line.
  stl.replace(stl.find("strata ") + 6, 1, "\n");
  CHECK(read_small(stl, Format::stl_ascii).triangles.size() == 4);
}

TEST_CASE("OBJ faces see the vertices of all pieces", "[io][pieces][obj]") {
  CHECK(read_small("f 1 2 4\n" + corners + "f -3 -2 -1\n" + corners + "f 8 -8 4\nf -1 -2 -8\n", Format::obj)
            .triangles.back() == Triangle{7, 6, 0});
  check_all_sizes(corners + "f -1 -2 -3\n" + corners + "f -1 -2 -9\n", Format::obj);
  check_all_sizes(corners + "f 1 2 3\nf 1 2 9\n" + corners, Format::obj);
  check_all_sizes("f 1 2 3\nf 1 2 3 4\nf 1 2 9\n" + corners + "f 1 1 2 # flat\nf 1 2 4 3\n", Format::obj);
}

TEST_CASE("OBJ lines that are continued stay in one piece", "[io][pieces][obj]") {
  std::string text = corners;
  for (int i = 0; i < 20; ++i)
    text += "v 0 0 \\\n 1\nf 1 \\\r\n\\\n  2 3\n# not continued \\\nv 0 0 2 # nor this \\\nv 0 0 3\n";
  const Mesh mesh = read_small(text, Format::obj);
  CHECK(mesh.vertices.size() == 4 + 3 * 20);
  CHECK(mesh.triangles.size() == 20);
}

TEST_CASE("Records that share lines, or spread over them, are read alike in pieces", "[io][pieces]") {
  // Catches readers that take a line for a record: the counts fit by chance here.
  const std::string off =
      "OFF\n4 4 0\n0 0\n0\n# comment\n1 0 0 9 9 9\n\n0 1 0\n0 0 1\n3 0 2 1\n3 0\n1 3\n3 1 2 3\n3 2 0 3\n";
  CHECK(read_small(off, Format::off) == tetrahedron);
  CHECK(read_small("OFF\n4 4\n0\n" + off.substr(10), Format::off).triangles.size() == 4);
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 4\n"
      "property list uchar int vertex_indices\nend_header\n";
  for (const char* data : {"0 0 0 1\n0 0 0 1 0\n0 0\n1 3 0 2 1\n3 0 1 3\n3 1 2\n3 3 2 0 3\n",
                           "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1 3\n0 1 3\n3 1 2 3\n3 2 0 3\n",
                           "0 0 0\n\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\nmore\nand more\n",
                           "0 0 0 1 0 0 0 1 0 0 0 1 3 0 2 1 3 0 1 3 3 1 2 3 3 2 0 3"})
    CHECK(read_small(header + data, Format::ply) == tetrahedron);
}

TEST_CASE("Binary PLY records of equal and of different sizes are read alike in pieces", "[io][pieces][ply]") {
  std::string text =
      "ply\nformat binary_little_endian 1.0\nelement vertex 5\nproperty uchar x\nproperty uchar y\nproperty uchar z\n"
      "property list uchar uchar more\nelement face 60\nproperty list uchar uchar vertex_indices\nend_header\n";
  for (char i = 0; i < 5; ++i) text += std::string{i, static_cast<char>(i * i), 0, 1, 7};
  std::string equal = text, different = text, compensating = text;
  for (int i = 0; i < 60; ++i) {
    equal += std::string{3, 0, 1, static_cast<char>(2 + i % 3)};
    different += i % 7 == 5 ? std::string{4, 0, 1, 2, 3} : std::string{3, 0, 1, 2};
    // As long as triangles on the whole.
    compensating += i % 6 == 2   ? std::string{4, 0, 1, 2, 3}
                    : i % 6 == 3 ? std::string{2, 0, 1}
                                 : std::string{3, 0, 1, 2};
  }
  CHECK(read_small(equal, Format::ply).triangles.size() == 60);
  CHECK(read_small(different, Format::ply).triangles.size() == 68);
  CHECK(read_small(compensating, Format::ply).triangles.size() == 60);
  check_all_sizes(equal + "tail", Format::ply);
  check_all_sizes(equal.substr(0, equal.size() - 1), Format::ply);
  equal[equal.size() - 70] = 5;
  check_all_sizes(equal, Format::ply);
}

TEST_CASE("Properties of binary PLY are read alike in pieces, with lists and without", "[io][pieces][ply]") {
  std::string text =
      "ply\nformat binary_big_endian 1.0\nelement vertex 5\nproperty uchar x\nproperty uchar y\nproperty uint q\n"
      "property uchar z\nproperty short s\nelement face 60\nproperty list uchar uchar texcoords\n"
      "comment channel 1 linear c\nproperty list uchar float c\nproperty list uchar uchar vertex_indices\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n";
  using namespace std::string_literals;
  for (char i = 0; i < 5; ++i) text += std::string{i, static_cast<char>(i * i), i, 0, 0, i, 0, '\xff', i};
  std::string equal = text, different = text;
  for (char i = 0; i < 60; ++i) {
    const std::string values = "\x3f\x80\0\0"s + std::string{i, i, i, i} + "\x40\0\0\0"s;
    const std::string colors{i, static_cast<char>(2 * i), 7};
    equal += std::string{1, 9, 3} + values + std::string{3, 0, 1, static_cast<char>(2 + i % 3)} + colors;
    different += i % 7 == 5 ? std::string{0, 4} + values + values.substr(4, 4) + std::string{4, 0, 1, 2, 3} + colors
                            : std::string{0, 3} + values + std::string{3, 0, 1, 2} + colors;
  }
  CHECK(read_small(equal, Format::ply).triangles.size() == 60);
  CHECK(read_small(different, Format::ply).triangles.size() == 68);
  CHECK(outcome(different, Format::ply, whole).file.attributes.channels.size() == 4);
  check_all_sizes(equal + "tail", Format::ply);
  check_all_sizes(equal.substr(0, equal.size() - 1), Format::ply);
  check_all_sizes(different.substr(0, different.size() - 40), Format::ply);
}

TEST_CASE("What stands behind records of OFF and text PLY is read alike in pieces", "[io][pieces]") {
  std::string off = "STCNOFF\n12 12 0\n",
              ply =
                  "ply\nformat ascii 1.0\nelement vertex 12\nproperty float x\nproperty float q\nproperty float y\n"
                  "property float z\nelement face 12\nproperty list uchar int vertex_indices\nproperty list uchar "
                  "float texcoord\n"
                  "property int material\nend_header\n";
  std::string off_faces, ply_faces;
  for (int i = 0; i < 12; ++i) {
    const std::string n = std::to_string(i);
    off += n + " 1 " + n + " 0 0 1 " + n + (i == 5 ? " 2" : " 2 3 4 0.5 ") + n + "\n";
    off_faces += i % 4 == 3 ? "4 0 1 2 3 7\n" : "3 0 1 " + n + "\n";
    ply += n + (i == 7 ? " odd 1 " : " 0.5 1 ") + n + "\n";
    ply_faces += i % 4 == 3 ? "4 0 1 2 3 8 1 2 3 4 5 6 7 8 " : "3 0 1 2 6 1 2 3 4 5 6 ";
    ply_faces += n + "\n";
  }
  check_all_sizes(off + off_faces, Format::off);
  check_all_sizes(ply + ply_faces, Format::ply);
  CHECK(outcome(ply + ply_faces, Format::ply, whole).file.attributes.channels.size() == 3);
  CHECK(outcome(off + off_faces, Format::off, whole).file.attributes.channels.size() == 3);
  check_all_sizes(ply + ply_faces.substr(0, ply_faces.size() - 9), Format::ply);
}

TEST_CASE("PLY counts that overflow when they are added up are refused alike in pieces", "[io][pieces][ply]") {
  // Catches readers that take the sum for the number of lines and then make room for 2^63 - 1 vertices.
  const std::string huge = "9223372036854775807";
  const std::string text = "ply\nformat ascii 1.0\nelement vertex " + huge +
                           "\nproperty float x\nproperty float y\nproperty float z\nelement a " + huge +
                           "\nproperty int i\nelement b 6\nproperty int i\nend_header\n1 2 3\n4\n5\n6\n7\n";
  CHECK(outcome(text, Format::ply, whole).error.find("room for") != std::string::npos);
  check_all_sizes(text, Format::ply);
}

TEST_CASE("Text STL of several solids, and with words where none are expected, is read alike in pieces",
          "[io][pieces][stl]") {
  const std::string facet =
      " facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\n endfacet\n";
  std::string text;
  for (int i = 0; i < 5; ++i) text += "solid facet\n" + facet + facet + "endsolid facet\nfacets\n";
  check_all_sizes(text, Format::stl_ascii);
  text.clear();
  for (int i = 0; i < 5; ++i) text += "solid facet\n" + facet + facet + "endsolid facet\n";
  CHECK(read_small(text, Format::stl_ascii).triangles.size() == 10);
  check_all_sizes(text + facet, Format::stl_ascii);
  check_all_sizes(text + "solid\n" + facet, Format::stl_ascii);
  // A line that starts with "facet" but is no facet: part of a normal.
  CHECK(read_small("solid\nfacet normal\nfacet normal\nfacet 0 0 1\n" + facet.substr(20) + facet + "endsolid\n",
                   Format::stl_ascii)
            .triangles.size() == 2);
}

TEST_CASE("Corners of STL triangles become one vertex across pieces, numbered by first use", "[io][pieces][stl]") {
  // Catches numbering by anything that depends on pieces: first uses come in another order than last ones.
  Mesh mesh = shuffled_strip(3, 200);
  std::vector<Vertex> in_order_of_use;
  for (const Triangle& t : mesh.triangles)
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
      for (const std::uint32_t v : t)
        if (std::find(in_order_of_use.begin(), in_order_of_use.end(), mesh.vertices[v]) == in_order_of_use.end())
          in_order_of_use.push_back(mesh.vertices[v]);
  std::erase_if(mesh.triangles, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  for (const Format format : {Format::stl, Format::stl_ascii}) {
    const Mesh read = read_small(to_string(mesh, format), format);
    CHECK(read.vertices == in_order_of_use);
    CHECK(read.triangles.size() == mesh.triangles.size());
    for (std::size_t i = 0; i < read.triangles.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(read.vertices[read.triangles[i][k]] == mesh.vertices[mesh.triangles[i][k]]);
  }
}

TEST_CASE("Of many errors the first in the file is reported, with its line", "[io][pieces]") {
  // Catches verdicts from whatever piece fails first, and lines counted from the start of a piece.
  const Mesh mesh = shuffled_strip(5, 2000);
  for (const Format format : text_formats) {
    std::string text = to_string(mesh, format);
    const std::size_t bad = text.find('\n', text.size() * 9 / 10) + 1;
    const auto line =
        static_cast<std::uint64_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(bad), '\n')) + 1;
    for (std::size_t at = bad; at < text.size() && at != 0; at = text.find('\n', at + 2000) + 1)
      text.insert(at, "f % ");
    for (const std::size_t piece : {std::size_t{100}, std::size_t{5000}, whole}) {
      CAPTURE(name(format), piece);
      try {
        (void)io::read({"test", text, piece}, format);
        FAIL_CHECK("accepted");
      } catch (const IoError& error) {
        CHECK(error.line() == line);
      }
    }
  }
  std::string bytes = to_string(mesh, Format::stl);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const std::size_t triangle : {5555, 4321, 5000})
    io::store(bytes.data() + 84 + 50 * triangle + 40, nan, std::endian::little);
  CHECK(outcome(bytes, Format::stl, 1000).error.find("corner 2 of triangle 4321") != std::string::npos);
  check_all_sizes(bytes, Format::stl);
}

TEST_CASE("Results do not depend on the number of threads", "[io][pieces]") {
  const Mesh mesh = shuffled_strip(7, 3000);
  for (const Format format : all_formats) {
    const std::string text = to_string(mesh, format);
    const Outcome expected = outcome(text, format, whole);
    for (const std::size_t threads : {1, 2, 4}) {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      CAPTURE(name(format), threads);
      CHECK(outcome(text, format, 4096) == expected);
      CHECK(to_string(mesh, format) == text);
    }
  }
}

TEST_CASE("Large binary files are read piece by piece as they are in memory", "[io][pieces][files]") {
  const fs::path path = fs::temp_directory_path() / ("strata_pieces_" + std::to_string(system::process_number()));
  const Mesh mesh = shuffled_strip(9, 500);
  for (const Format format : {Format::stl, Format::ply, Format::ply_big_endian, Format::ply_ascii, Format::obj}) {
    const std::string text = to_string(mesh, format);
    for (const std::string& bytes : {text, text + "tail", text.substr(0, text.size() - 1)}) {
      CAPTURE(name(format), bytes.size());
      std::ofstream(path, std::ios::binary) << bytes;
      Outcome read;
      try {
        read.file = io::read(io::File(path), format, 1000);
      } catch (const IoError& error) {
        read.error = "test" + std::string(error.what()).substr(path.string().size());
      }
      CHECK(read == outcome(bytes, format, whole));
    }
  }
  fs::remove(path);
}
