#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "openscad/csg_text.h"
#include "strata/io.h"
#include "strata/primitives.h"

using namespace strata;
using namespace strata::test;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// A folder for a model and what it imports.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("strata-import-" + std::to_string(++count))) {
    fs::remove_all(path_);
    fs::create_directories(path_ / "model");
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / "model" / name, std::ios::binary) << text;
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (path_ / "model" / name).string(); }

  [[nodiscard]] CsgModel read(const std::string& text, bool any_path = false) const {
    CsgOptions options;
    options.folder = (path_ / "model").string();
    options.any_path = any_path;
    return read_csg(text, "test.csg", options);
  }
  [[nodiscard]] Rational volume(const std::string& text) const { return read(text).expression.evaluate().volume(); }
  [[nodiscard]] double area(const std::string& text) const {
    const CsgModel model = read(text);
    return model.shape ? to_nearest_double(planar::area(*model.shape)) : 0;
  }
  [[nodiscard]] std::string error(const std::string& text) const {
    try {
      (void)read(text);
      return {};
    } catch (const CsgError& e) {
      return e.reason();
    }
  }
  [[nodiscard]] std::string notes(const std::string& text) const {
    std::string all;
    for (const std::string& n : read(text).notes) all += n + "\n";
    return all;
  }

 private:
  static inline int count = 0;
  fs::path path_;
};

Mesh doubled(double by) {
  Mesh mesh = make_box({0, 0, 0}, {2, 2, 2}).mesh();
  const Mesh other = make_box({by, by, by}, {2 + by, 2 + by, 2 + by}).mesh();
  for (const Triangle& t : other.triangles) mesh.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  return mesh;
}

std::string svg(const std::string& content, const std::string& attributes = "") {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" " + attributes + ">" + content + "</svg>";
}

std::string dxf(const std::string& entities) { return "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n"; }

std::string line(const std::string& x0, const std::string& y0, const std::string& x1, const std::string& y1,
                 const std::string& layer = "0") {
  return "0\nLINE\n8\n" + layer + "\n10\n" + x0 + "\n20\n" + y0 + "\n11\n" + x1 + "\n21\n" + y1 + "\n";
}

const std::string millimetres = "width=\"10mm\" height=\"10mm\" viewBox=\"0 0 10 10\"";

/// The bytes that hexadecimal digits write.
std::string bytes_of_hex(const std::string& digits) {
  std::string bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2)
    bytes.push_back(static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16)));
  return bytes;
}

/// Three by two pixels: red, green, blue; black, white, (10, 20, 30).
std::string png_of_colours() {
  return bytes_of_hex(
      "89504e470d0a1a0a0000000d49484452000000030000000208020000001216f14d0000001649444154789c63f8cfc0c000c30cff"
      "ffffe7129103003c3c063705481ef30000000049454e44ae426082");
}

/// Not used where there is no libpng.
[[maybe_unused]] double volume_of_picture(const Folder& folder, const std::string& bytes,
                                          const std::string& arguments = "") {
  folder.write("picture.any", bytes);
  return to_nearest_double(folder.volume("surface(file = \"picture.any\"" + arguments + ");"));
}

}  // namespace

TEST_CASE("meshes of all formats are imported", "[openscad]") {
  const Folder folder;
  for (const char* name : {"box.stl", "box.off", "box.obj", "box.ply", "box.3mf"}) {
    CAPTURE(name);
    write_mesh(folder.path(name), make_box({0, 0, 0}, {1, 2, 3}).mesh());
    CHECK(folder.volume(std::string("import(file = \"") + name + "\", convexity = 1, timestamp = 5);") == 6);
  }
}

TEST_CASE("a mesh that crosses itself is the solid that it winds around", "[openscad]") {
  const Folder folder;
  write_mesh(folder.path("crossing.off"), doubled(1));
  CHECK(folder.volume("import(\"crossing.off\");") == 15);
}

TEST_CASE("meshes that bound no solid are repaired, or refused by name", "[openscad]") {
  const Folder folder;
  Mesh mesh = make_box({0, 0, 0}, {1, 1, 1}).mesh();
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  write_mesh(folder.path("turned.off"), mesh);
  CHECK(folder.volume("import(\"turned.off\");") == 1);
  CHECK_THAT(folder.notes("import(\"turned.off\");"), Contains("repairs a mesh"));
  mesh.triangles.pop_back();
  write_mesh(folder.path("open.off"), mesh);
  CHECK_THAT(folder.error("import(\"open.off\");"), Contains("'open.off' bounds no solid") && Contains("open edge"));
}

// Catches: models that read whatever they like.
TEST_CASE("files are read beneath the model's folder only", "[openscad]") {
  const Folder folder;
  write_mesh(folder.path("../outside.off"), make_box({0, 0, 0}, {1, 1, 1}).mesh());
  const std::string outside = "import(file = \"../outside.off\");";
  CHECK_THAT(folder.error(outside), Contains("is not beneath the model's folder"));
  CHECK_THAT(folder.error("import(file = \"/etc/passwd\");"), Contains("is not beneath the model's folder"));
  CHECK(folder.read(outside, true).expression.evaluate().volume() == 1);
  std::error_code no_links;
  fs::create_symlink(folder.path("../outside.off"), folder.path("link.off"), no_links);
  if (!no_links)
    CHECK_THAT(folder.error("import(file = \"link.off\");"), Contains("is not beneath the model's folder"));
  CHECK_THAT(folder.error("import(file = \"none.stl\");"), Contains("is missing: there is no 'none.stl'"));
  CHECK_THAT(folder.error("surface(file = \"none.dat\");"), Contains("is missing"));
  folder.write("what.xyz", "?");
  CHECK_THAT(folder.error("import(file = \"what.xyz\");"), Contains("'what.xyz' is of another format"));
  folder.write("bad.off", "OFF\n1 x");
  CHECK_THAT(folder.error("import(file = \"bad.off\");"), Contains("is not read: ") && Contains("bad.off:2"));
  CHECK_THAT(error_of("import(file = \"a.stl\");"), Contains("the model has no folder"));
  CHECK(folder.volume("import(file = \"\"); cube(1);") == 1);
  CHECK_THAT(folder.notes("import(file = \"\");"), Contains("import without a file makes nothing"));
}

TEST_CASE("fields of heights are solids", "[openscad]") {
  const Folder folder;
  folder.write("flat.dat", "# a comment\n0 0 0\r\n\n0 0 0\n");
  CHECK(folder.volume("surface(file = \"flat.dat\");") == 2);
  CHECK(folder.volume("intersection() { surface(file = \"flat.dat\", center = true); "
                      "multmatrix([[1,0,0,-5],[0,1,0,-5],[0,0,1,-5]]) { cube([5,10,10]); } }") == 1);
  folder.write("high.dat", "2 3\n4 5\n");
  CHECK(folder.volume("surface(file = \"high.dat\");") == Rational(7, 2));  // as in OpenSCAD 2021.01
  folder.write("uneven.dat", "0 1 2\n3 5 4\n9 8 7.5");
  CHECK(folder.volume("surface(file = \"uneven.dat\");") == Rational(173, 8));
  folder.write("short.dat", "1 1\n1\n");
  CHECK(folder.volume("surface(file = \"short.dat\");") > 0);
  folder.write("row.dat", "1 2 3\n");
  CHECK_THAT(folder.notes("surface(file = \"row.dat\");"), Contains("less than two rows or columns"));
  folder.write("bad.dat", "1 2\n3 x\n");
  CHECK_THAT(folder.error("surface(file = \"bad.dat\");"), Contains("has no number in line 2: 'x'"));
}

#if STRATA_WITH_PNG
// The volumes are those of OpenSCAD 2021.01, whose files have six digits.
TEST_CASE("fields of heights are drawn by PNG files of all kinds", "[openscad]") {
  const Folder folder;
  const auto volume = [&](const std::string& bytes) { return Approx(volume_of_picture(folder, bytes)).epsilon(1e-6); };
  CHECK(96.703137 == volume(png_of_colours()));
  // Grey of 16 bits, 1 bit, a palette, grey with opacity, a gamma of 1.
  CHECK(38.647059 ==
        volume(bytes_of_hex(
            "89504e470d0a1a0a0000000d4948445200000002000000021000000000074d8ebb0000001249444154789c63606068f8cfc0f8ff"
            "ff7f000f82047ea384b80b0000000049454e44ae426082")));
  CHECK(51 ==
        volume(bytes_of_hex(
            "89504e470d0a1a0a0000000d49484452000000020000000201000000005acd30890000000c49444154789c637060680000014400"
            "c13a7a1c560000000049454e44ae426082")));
  CHECK(29.51 ==
        volume(bytes_of_hex(
            "89504e470d0a1a0a0000000d49484452000000020000000208030000004568fd1600000009504c5445000000ff000000ff00f483"
            "bf7e0000000e49444154789c6360606460640200000e00059f97d85f0000000049454e44ae426082")));
  CHECK(35.313725 ==
        volume(bytes_of_hex(
            "89504e470d0a1a0a0000000d4948445200000002000000020804000000d8bfc5af0000001249444154789c63486138f19fc1a881"
            "811d00114f02e5504d1f980000000049454e44ae426082")));
  CHECK(35.313725 ==
        volume(bytes_of_hex(
            "89504e470d0a1a0a0000000d494844520000000200000002080000000057dd52f80000000467414d41000186a031e8965f000000"
            "0e49444154789c634839c160c40000057e015fb313bf400000000049454e44ae426082")));
}

TEST_CASE("inverted pictures are those of OpenSCAD, centred ones begin left of zero", "[openscad]") {
  const Folder folder;
  CHECK(volume_of_picture(folder, png_of_colours(), ", invert = true") == Approx(107.296863).epsilon(1e-6));
  folder.write("picture.png", png_of_colours());
  const auto part = [&](const std::string& surface, const std::string& box) {
    return to_nearest_double(folder.volume("intersection() { " + surface + " " + box + " }"));
  };
  const std::string below = "multmatrix([[1,0,0,-5],[0,1,0,-5],[0,0,1,-150]]) { cube([10,10,100]); }";
  CHECK(part("surface(file = \"picture.png\", invert = true);", below) > 50);
  // The lowest row is the first.
  folder.write("same.dat", "0 100 7.2925490196\n21.26 71.52 7.22\n");
  const std::string front = "multmatrix([[1,0,0,-5],[0,1,0,-4.75],[0,0,1,-50]]) { cube([10,5,200]); }";
  CHECK(part("surface(file = \"picture.png\");", front) ==
        Approx(part("surface(file = \"same.dat\");", front)).epsilon(1e-6));
  CHECK(to_nearest_double(folder.volume("intersection() { surface(file = \"picture.png\", center = true); "
                                        "multmatrix([[1,0,0,-5],[0,1,0,-5],[0,0,1,-5]]) { cube([5,10,200]); } }")) ==
        Approx(49.195).epsilon(1e-6));
}

TEST_CASE("broken pictures are refused with their reason", "[openscad]") {
  const Folder folder;
  const auto error = [&](const std::string& bytes) {
    folder.write("picture.png", bytes);
    return folder.error("surface(file = \"picture.png\");");
  };
  const std::string good = png_of_colours();
  for (std::size_t size = 8; size + 12 < good.size(); ++size)
    CHECK_THAT(error(good.substr(0, size)), Contains("is a picture that is not read"));
  std::string bad = good;
  bad[18] = 7;  // the width, without its checksum
  CHECK_THAT(error(bad), Contains("is a picture that is not read"));
  CHECK_THAT(
      error(bytes_of_hex(
          "89504e470d0a1a0a0000000d49484452000f4240000f42400802000000d30faf2a0000000949444154789cab000000790079a531"
          "6cf30000000049454e44ae426082")),
      Contains("more than 67108864 pixels"));
}
#else
TEST_CASE("without libpng pictures are refused", "[openscad]") {
  const Folder folder;
  folder.write("picture.png", png_of_colours());
  CHECK_THAT(folder.error("surface(file = \"picture.png\");"), Contains("has no libpng"));
}
#endif

TEST_CASE("shapes of SVG files are filled by their rules, in millimetres, upright", "[openscad]") {
  const Folder folder;
  const auto area = [&](const std::string& content, const std::string& arguments = "") {
    folder.write("a.svg", svg(content, millimetres));
    return folder.area("import(file = \"a.svg\"" + arguments + ");");
  };
  CHECK(area("<rect x=\"1\" y=\"1\" width=\"2\" height=\"3\"/>") == 6);
  CHECK(area("<g transform=\"scale(2) translate(1 1)\"><rect width=\"2\" height=\"1\"/></g>") == 8);
  CHECK(area("<polygon points=\"0,0 4,0 0,4\"/><circle cx=\"8\" cy=\"8\" r=\"1\"/>", ", $fn = 4") == Approx(10));
  CHECK(area("<path d=\"M0 0h4v4h-4z m1 1h2v2h-2z\"/>") == 16);
  CHECK(area("<path fill-rule=\"evenodd\" d=\"M0 0h4v4h-4z m1 1h2v2h-2z\"/>") == 12);
  CHECK(area("<path d=\"M0 0L4 0L4 4Z\" style=\"fill:none;stroke:red\"/>") == 0);
  CHECK(area("<rect id=\"a\" width=\"1\" height=\"1\"/><rect id=\"b\" width=\"2\" height=\"2\"/>", ", id = \"b\"") ==
        4);
  CHECK_THAT(folder.notes("import(file = \"a.svg\");"), !Contains("left out"));
  folder.write("t.svg", svg("<text>A</text><rect width=\"1\" height=\"1\"/>"));
  CHECK_THAT(folder.notes("import(file = \"t.svg\");"), Contains("text is left out"));
  CHECK(folder.area("import(file = \"t.svg\", dpi = 25.4);") == 1);
  folder.write("y.svg", svg("<rect y=\"1\" width=\"1\" height=\"2\"/>", millimetres));
  const CsgModel upright = folder.read("import(file = \"y.svg\");");
  CHECK(planar::canonical_form(*upright.shape)[0][0] == planar::RationalPlacement{0, 7});
  const CsgModel centred = folder.read("import(file = \"y.svg\", center = true);");
  CHECK(planar::canonical_form(*centred.shape)[0][0] == planar::RationalPlacement{Rational(-1, 2), -1});
}

TEST_CASE("arcs and Bezier curves of SVG files are divided by $fn", "[openscad]") {
  const Folder folder;
  const auto area = [&](const std::string& data, const std::string& fn) {
    folder.write("a.svg", svg("<path d=\"" + data + "\"/>", millimetres));
    return folder.area("import(file = \"a.svg\", $fn = " + fn + ");");
  };
  CHECK(area("M3 5A2 2 0 1 1 7 5A2 2 0 1 1 3 5Z", "4") == Approx(8));
  CHECK(area("M3 5a2 2 0 1 1 4 0 2 2 0 1 1-4 0z", "200") == Approx(4 * 3.14159265).epsilon(1e-3));
  CHECK(area("M3 5A2 1 90 0 1 5 5Z", "200") > 0);
  CHECK(area("M0 0Q4 0 4 4L0 4Z", "1") == Approx(8));
  CHECK(area("M0 0Q4 0 4 4L0 4Z", "100") == Approx(8 + 16.0 / 3).epsilon(1e-3));
  CHECK(area("M0 0C0 4 4 4 4 0Z", "100") == Approx(9.6).epsilon(1e-3));
  CHECK(area("M0 0C0 2 1 3 2 3S4 2 4 0Z", "50") > 0);
  CHECK(area("M0 0Q1 2 2 0T4 0Z", "50") > 0);
  CHECK(area("M0 0A0 5 0 0 1 4 0L4 4Z", "50") == 8);  // an arc without radius is a line
  for (const char* bad : {"L0 0", "M0", "M0 0L1 x", "M0 0A1 1 0 2 0 1 1", "M0 0W1 1"}) {
    CAPTURE(bad);
    folder.write("bad.svg", svg(std::string("<path d=\"") + bad + "\"/>"));
    CHECK_THAT(folder.error("import(file = \"bad.svg\");"), Contains("path data at byte"));
  }
  folder.write("broken.svg", "<svg>\n<path");
  CHECK_THAT(folder.error("import(file = \"broken.svg\");"), Contains("no XML"));
  folder.write("other.svg", "<html/>");
  CHECK_THAT(folder.error("import(file = \"other.svg\");"), Contains("no element svg"));
}

TEST_CASE("lines of DXF files are joined into loops", "[openscad]") {
  const Folder folder;
  const std::string square =
      line("0", "0", "4", "0") + line("4", "4", "4", "0.0000001") + line("4", "4", "0", "4") + line("0", "0", "0", "4");
  folder.write("a.dxf", dxf(square + line("9", "9", "8", "8") + "0\nCIRCLE\n8\nround\n10\n2\n20\n2\n40\n1\n"));
  CHECK(folder.area("import(file = \"a.dxf\", $fn = 4);") == Approx(14));
  CHECK(folder.area("import(file = \"a.dxf\", layer = \"round\", $fn = 4);") == Approx(2));
  CHECK(folder.area("import(file = \"a.dxf\", layer = \"none\");") == 0);
  CHECK(folder.area("import(file = \"a.dxf\", scale = 2, $fn = 4);") == Approx(56));
  CHECK_THAT(folder.notes("import(file = \"a.dxf\");"), Contains("1 chains of lines do not close"));
  folder.write("open.dxf", dxf(line("0", "4", "0", "0") + line("0", "0", "4", "0")));
  CHECK(folder.area("import(file = \"open.dxf\");") == 8);
  folder.write("p.dxf", dxf("0\nLWPOLYLINE\n8\n0\n70\n1\n10\n0\n20\n0\n10\n2\n20\n0\n10\n2\n20\n2\n0\nSPLINE\n8\n0\n"));
  CHECK(folder.area("import(file = \"p.dxf\");") == 2);
  CHECK_THAT(folder.notes("import(file = \"p.dxf\");"), Contains("SPLINE is left out"));
  folder.write("arc.dxf", dxf("0\nARC\n8\n0\n10\n0\n20\n0\n40\n1\n50\n90\n51\n270\n" + line("0", "1", "0", "-1")));
  CHECK(folder.area("import(file = \"arc.dxf\", $fn = 4);") == Approx(1));
  folder.write("e.dxf", dxf("0\nELLIPSE\n8\n0\n10\n0\n20\n0\n11\n2\n21\n0\n40\n0.5\n41\n0\n42\n6.283185307179586\n"));
  CHECK(folder.area("import(file = \"e.dxf\", $fn = 4);") == Approx(4));
  folder.write("i.dxf", "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nb\n" + square + "0\nENDBLK\n0\nENDSEC\n" +
                            dxf("0\nINSERT\n8\n0\n2\nb\n10\n9\n20\n9\n41\n2\n42\n1\n50\n90\n"));
  CHECK(folder.area("import(file = \"i.dxf\");") == Approx(32));
  folder.write("bad.dxf", "0\nSECTION\nx\n");
  CHECK_THAT(folder.error("import(file = \"bad.dxf\");"), Contains("DXF:3: expected the code of a group"));
  folder.write("worse.dxf", dxf("0\nLINE\n10\nabc\n"));
  CHECK_THAT(folder.error("import(file = \"worse.dxf\");"), Contains("expected a number"));
}

TEST_CASE("drawings that are written are read again", "[openscad]") {
  const Folder folder;
  folder.write("w.dxf", to_dxf(*read_csg("difference() { square(4); circle(1, $fn = 5); }", "t.csg").shape));
  CHECK(folder.read("import(file = \"w.dxf\");").notes.empty());
  CHECK(folder.area("import(file = \"w.dxf\");") ==
        to_nearest_double(planar::area(*read_csg("difference() { square(4); circle(1, $fn = 5); }", "t.csg").shape)));
}
