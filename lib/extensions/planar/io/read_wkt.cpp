#include "extensions/planar/io/scanner.h"

namespace strata::planar {
namespace {

class WktReader {
 public:
  WktReader(std::string_view text, std::vector<std::string>& notes) : scanner_(text), notes_(notes) {}

  Loops read() {
    // Several geometries in sequence, as in a table.
    for (scanner_.skip_space(); !scanner_.at_end(); scanner_.skip_space()) {
      geometry(0);
      scanner_.accept(';');
    }
    if (left_out_) notes_.emplace_back("more than two coordinates: the others were left out");
    return rings_.finish();
  }

 private:
  void geometry(int depth) {
    std::string kind = scanner_.word();
    if (kind == "SRID") {  // as PostGIS writes it
      scanner_.expect('=');
      static_cast<void>(scanner_.number(false));
      scanner_.expect(';');
      kind = scanner_.word();
    }
    std::string tag = scanner_.word();
    if (tag == "Z" || tag == "M" || tag == "ZM") tag = scanner_.word();
    if (tag == "EMPTY") {
      check(kind);
    } else if (!tag.empty()) {
      scanner_.fail("expected '(' or EMPTY, found " + io::quoted(tag));
    } else {
      check(kind);
      body(kind, depth);
    }
  }
  void check(const std::string& kind) const {
    if (kind != "POLYGON" && kind != "MULTIPOLYGON" && kind != "GEOMETRYCOLLECTION")
      scanner_.fail("expected POLYGON, MULTIPOLYGON or GEOMETRYCOLLECTION, found " + io::quoted(kind));
  }
  void body(const std::string& kind, int depth) {
    if (kind == "POLYGON") return polygon();
    const bool is_collection = kind == "GEOMETRYCOLLECTION";
    if (is_collection && depth == deepest) scanner_.fail("collections are nested too deeply");
    scanner_.expect('(');
    do {
      if (is_collection) {
        geometry(depth + 1);
      } else if (!accept_empty()) {
        polygon();
      }
    } while (scanner_.accept(','));
    scanner_.expect(')');
  }
  bool accept_empty() {
    scanner_.skip_space();
    if (scanner_.peek() == '(') return false;
    if (scanner_.word() != "EMPTY") scanner_.fail_expected("'(' or EMPTY");
    return true;
  }
  void polygon() {
    scanner_.expect('(');
    bool is_shell = true;
    do {
      if (!accept_empty()) ring();
      rings_.end_ring(is_shell);
      is_shell = false;
    } while (scanner_.accept(','));
    scanner_.expect(')');
  }
  void ring() {
    scanner_.expect('(');
    do {
      CoordinatePair p;
      for (io::ExactCoordinate& x : p) x = scanner_.number(true);
      for (; scanner_.is_at_number(); left_out_ = true) static_cast<void>(scanner_.number(true));
      rings_.add(std::move(p));
    } while (scanner_.accept(','));
    scanner_.expect(')');
  }

  static constexpr int deepest = 512;  ///< collections within collections: one call each
  Scanner scanner_;
  std::vector<std::string>& notes_;
  RingCollector rings_;
  bool left_out_ = false;
};

}  // namespace

Loops read_wkt(std::string_view text, std::vector<std::string>& notes) { return WktReader(text, notes).read(); }

}  // namespace strata::planar
