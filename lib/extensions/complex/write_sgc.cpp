#include <ostream>
#include <sstream>

#include "core/io/sink.h"
#include "extensions/complex/face_geometry.h"
#include "strata/complex.h"

namespace strata::complex {
namespace {

using Index = std::uint32_t;

class Writer {
 public:
  Writer(std::ostream& out, const Cells& cells) : out_(out), cells_(cells) {}

  void write() {
    out_ << "SGC 1\ndimension " << cells_.dimension << '\n';
    write_vertices();
    write_edges();
    write_faces();
    if (cells_.dimension == 3) write_volumes();
    out_ << "end\n";
  }

 private:
  [[nodiscard]] int mark(std::size_t d, Index i) const { return cells_.marks[d][i]; }

  void write_vertices() {
    out_ << "vertices " << cells_.count(0) << '\n';
    for (Index v = 0; v < cells_.count(0); ++v) {
      for (const Rational& x : cells_.position(v)) out_ << x.str() << ' ';
      out_ << mark(0, v) << '\n';
    }
  }

  void write_edges() {
    out_ << "edges " << cells_.count(1) << '\n';
    for (Index e = 0; e < cells_.count(1); ++e)
      out_ << cells_.edges[e][0] << ' ' << cells_.edges[e][1] << ' ' << mark(1, e) << '\n';
  }

  void write_faces() {
    const WingsOfFaces wings(cells_);
    std::vector<std::vector<Index>> isolated(cells_.count(2));
    for (const Isolated& i : cells_.vertices_in_faces) isolated[i.in].push_back(i.cell);
    out_ << "faces " << cells_.count(2) << '\n';
    for (Index f = 0; f < cells_.count(2); ++f) {
      if (cells_.dimension == 3) out_ << cells_.sides[f][0] << ' ' << cells_.sides[f][1] << ' ';
      out_ << mark(2, f);
      for (const Wing& w : wings[f]) out_ << (w.left ? " L" : " R") << w.edge;
      for (const Index v : isolated[f]) out_ << " V" << v;
      out_ << '\n';
    }
  }

  void write_volumes() {
    out_ << "volumes " << cells_.count(3) << '\n';
    for (Index v = 0; v < cells_.count(3); ++v) out_ << mark(3, v) << '\n';
    out_ << "isolated " << cells_.vertices_in_volumes.size() + cells_.edges_in_volumes.size() << '\n';
    for (const Isolated& i : cells_.vertices_in_volumes) out_ << 'V' << i.cell << ' ' << i.in << '\n';
    for (const Isolated& i : cells_.edges_in_volumes) out_ << 'E' << i.cell << ' ' << i.in << '\n';
  }

  std::ostream& out_;
  const Cells& cells_;
};

}  // namespace

void write_sgc(std::ostream& out, const SelectiveComplex& s) { Writer(out, s.cells()).write(); }

void write_sgc(const std::string& path, const SelectiveComplex& s) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  write_sgc(text, s);
  io::FileSink sink(path);
  sink.write(text.str());
  sink.finish();
}

}  // namespace strata::complex
