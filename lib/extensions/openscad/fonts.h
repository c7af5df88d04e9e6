#pragma once
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "strata/planar.h"

namespace strata::openscad {

/// What a `text` node says.
struct TextStyle {
  std::string text;       ///< UTF-8 without zeros
  std::string font;       ///< a pattern of Fontconfig: "Liberation Sans:style=Bold"; empty: Liberation Sans
  std::string direction;  ///< as HarfBuzz names it ("ltr"); empty: by the script
  std::string language;   ///< of BCP 47
  std::string script;     ///< of ISO 15924; empty: that of the letters, if they have one
  std::string halign;     ///< "left", "center", "right"
  std::string valign;     ///< "baseline", "top", "center", "bottom"
  double size = 10;
  double spacing = 1;             ///< factor of the advances
  std::uint32_t curve_lines = 2;  ///< lines of a curve
};

struct TextOutlines {
  std::vector<std::vector<planar::PlanePoint>> polygons;  ///< the text is what they wind around
  std::vector<std::string> notes;
};

/// A text that cannot be set.
class FontError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The fonts of the system and those of further files. They are looked up when the first text is set. Not for many
/// threads at once.
class Fonts {
 public:
  explicit Fonts(std::vector<std::string> files);
  ~Fonts();
  Fonts(const Fonts&) = delete;
  Fonts& operator=(const Fonts&) = delete;

  /// Whether this build has the libraries that texts need. If not, `outlines` throws.
  [[nodiscard]] static bool are_supported();

  /// The glyphs of a text as OpenSCAD 2021.01 places them. Fontconfig chooses the font, HarfBuzz the glyphs and their
  /// advances, FreeType their outlines, at a fixed size, which is then scaled. So advances are 1000/1024 of the font's.
  /// Glyphs that the font lacks are drawn as its own substitute. Another font than the named one, and what is missing,
  /// is noted. Throws FontError where there is no font, or files are no fonts, or the polygons might have more than
  /// `most_corners` corners, before they are made. The same for the same fonts and versions of the libraries.
  [[nodiscard]] TextOutlines outlines(const TextStyle& style);

 private:
  struct Libraries;
  std::vector<std::string> files_;
  std::unique_ptr<Libraries> libraries_;
};

}  // namespace strata::openscad
