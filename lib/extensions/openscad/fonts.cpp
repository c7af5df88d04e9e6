#include "extensions/openscad/fonts.h"

#if STRATA_WITH_FONTS

#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include <hb-ft.h>
#include <hb.h>
#include FT_FREETYPE_H
#include FT_GLYPH_H
#include FT_OUTLINE_H

#include <algorithm>
#include <map>
#include <string_view>
#include <type_traits>
#include <utility>

#include "extensions/openscad/glyph_pen.h"
#include "extensions/openscad/primitives.h"

namespace strata::openscad {
namespace {

template <auto destroy>
struct Destroy {
  template <class T>
  void operator()(T* p) const {
    destroy(p);
  }
};
template <class T, auto destroy>
using Owned = std::unique_ptr<T, Destroy<destroy>>;

using Config = Owned<FcConfig, FcConfigDestroy>;
using Pattern = Owned<FcPattern, FcPatternDestroy>;
using Library = Owned<std::remove_pointer_t<FT_Library>, FT_Done_FreeType>;
using Face = Owned<std::remove_pointer_t<FT_Face>, FT_Done_Face>;
using Buffer = Owned<hb_buffer_t, hb_buffer_destroy>;
using Font = Owned<hb_font_t, hb_font_destroy>;
using Glyph = Owned<std::remove_pointer_t<FT_Glyph>, FT_Done_Glyph>;

/// Glyphs are taken at this size, in 64ths of a point, with 100 dots per inch. So outlines are about 1 / (100 000)
/// high.
constexpr FT_F26Dot6 fixed_size = 100'000;
constexpr FT_UInt dots_per_inch = 100;
constexpr double outline_units = 1e5;      ///< of a size
constexpr double advance_units = 1.024e5;  ///< OpenSCAD divides advances and alignments by another number

const FcChar8* bytes(const std::string& text) { return reinterpret_cast<const FcChar8*>(text.c_str()); }

std::string first_of(const FcPattern* pattern, const char* object) {
  FcChar8* value = nullptr;
  if (FcPatternGetString(pattern, object, 0, &value) != FcResultMatch) return {};
  return reinterpret_cast<const char*>(value);
}

/// Whether a pattern has a value, among others, in whatever case.
bool has(const FcPattern* pattern, const char* object, const std::string& value) {
  FcChar8* other = nullptr;
  for (int i = 0; FcPatternGetString(pattern, object, i, &other) == FcResultMatch; ++i)
    if (FcStrCmpIgnoreCase(other, bytes(value)) == 0) return true;
  return false;
}

std::string trimmed(const std::string& text) {
  constexpr const char* blanks = " \t\n\v\f\r";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? std::string() : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

struct ChosenFont {
  Face face;
  std::string name;
  std::string note;  ///< empty if it is the one that was asked for
};

/// The script that all letters have which have one; otherwise one that HarfBuzz takes as none.
hb_script_t script_of(const TextStyle& style) {
  const hb_script_t given = hb_script_from_string(style.script.c_str(), -1);
  if (given != HB_SCRIPT_INVALID) return given;
  const Buffer letters(hb_buffer_create());
  hb_buffer_add_utf8(letters.get(), style.text.c_str(), -1, 0, -1);
  unsigned count = 0;
  const hb_glyph_info_t* const infos = hb_buffer_get_glyph_infos(letters.get(), &count);
  hb_script_t script = HB_SCRIPT_INVALID;
  for (unsigned i = 0; i < count; ++i) {
    const hb_script_t s = hb_unicode_script(hb_unicode_funcs_get_default(), infos[i].codepoint);
    if (s == HB_SCRIPT_COMMON || s == HB_SCRIPT_INHERITED || s == HB_SCRIPT_UNKNOWN) continue;
    if (script != HB_SCRIPT_INVALID && script != s) return HB_SCRIPT_INVALID;
    script = s;
  }
  return script;
}

hb_direction_t direction_of(const TextStyle& style, hb_script_t script) {
  const hb_direction_t given = hb_direction_from_string(style.direction.c_str(), -1);
  if (given != HB_DIRECTION_INVALID) return given;
  const hb_direction_t usual = hb_script_get_horizontal_direction(script);
  return usual == HB_DIRECTION_INVALID ? HB_DIRECTION_LTR : usual;
}

std::string code_point(std::uint32_t code) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string text;
  for (; code != 0 || text.size() < 4; code /= 16) text.insert(text.begin(), digits[code % 16]);
  return "U+" + text;
}

constexpr hb_codepoint_t missing_glyph = 0;

/// One line of text in a font.
class Line {
 public:
  Line(FT_Face face, std::string name, const TextStyle& style)
      : face_(face), name_(std::move(name)), style_(style), buffer_(hb_buffer_create()) {
    if (FT_Set_Char_Size(face, 0, fixed_size, dots_per_inch, dots_per_inch) != 0)
      throw FontError("the font '" + name_ + "' has no outlines");
    shape();
    load();
  }

  TextOutlines drawn() {
    GlyphPen pen(style_.size, style_.curve_lines);
    auto [x, y] = start();
    for (const Placed& glyph : glyphs_) {
      pen.set_origin({x + glyph.position.x_offset / advance_units, y + glyph.position.y_offset / advance_units});
      draw(glyph, pen);
      x += advance_x(glyph);
      y += advance_y(glyph);
    }
    return {pen.take(), std::move(notes_)};
  }

 private:
  struct Placed {
    Glyph glyph;
    hb_glyph_position_t position;
  };

  void shape() {
    hb_buffer_t* const buffer = buffer_.get();
    const hb_script_t script = script_of(style_);
    hb_buffer_set_direction(buffer, direction_of(style_, script));
    hb_buffer_set_script(buffer, script);
    hb_buffer_set_language(buffer, hb_language_from_string(style_.language.c_str(), -1));
    // A glyph tells its first letter, also where marks belong to letters.
    hb_buffer_set_cluster_level(buffer, HB_BUFFER_CLUSTER_LEVEL_CHARACTERS);
    hb_buffer_add_utf8(buffer, style_.text.c_str(), -1, 0, -1);
    unsigned count = 0;
    const hb_glyph_info_t* const letters = hb_buffer_get_glyph_infos(buffer, &count);
    std::map<std::uint32_t, std::uint32_t> letter_at;
    for (unsigned i = 0; i < count; ++i) letter_at[letters[i].cluster] = letters[i].codepoint;
    const Font font(hb_ft_font_create(face_, nullptr));
    hb_shape(font.get(), buffer, nullptr, 0);
    const hb_glyph_info_t* const glyphs = hb_buffer_get_glyph_infos(buffer, &count);
    for (unsigned i = 0; i < count; ++i)
      if (glyphs[i].codepoint == missing_glyph)
        notes_.push_back("has a character that the font '" + name_ +
                         "' lacks: " + code_point(letter_at[glyphs[i].cluster]));
  }

  /// As many as are drawn, or more: each curve has a control point of its own.
  [[nodiscard]] std::size_t corners_of(const FT_Outline& outline) const {
    std::size_t corners = 0;
    for (int i = 0; i < outline.n_points; ++i)
      corners += (FT_CURVE_TAG(outline.tags[i]) == FT_CURVE_TAG_ON) ? 1 : style_.curve_lines;
    return corners;
  }

  void load() {
    unsigned count = 0;
    std::size_t corners = 0;
    const hb_glyph_info_t* const infos = hb_buffer_get_glyph_infos(buffer_.get(), &count);
    const hb_glyph_position_t* const positions = hb_buffer_get_glyph_positions(buffer_.get(), &count);
    for (unsigned i = 0; i < count; ++i) {
      FT_Glyph glyph = nullptr;
      if (FT_Load_Glyph(face_, infos[i].codepoint, FT_LOAD_DEFAULT) == 0 &&
          face_->glyph->format == FT_GLYPH_FORMAT_OUTLINE && FT_Get_Glyph(face_->glyph, &glyph) == 0) {
        glyphs_.push_back({Glyph(glyph), positions[i]});
        corners += corners_of(face_->glyph->outline);
        if (corners > most_corners) throw FontError("has too many corners: at most " + std::to_string(most_corners));
      } else {
        notes_.push_back("leaves out a glyph of the font '" + name_ + "' that has no outline");
      }
    }
  }

  [[nodiscard]] double advance_x(const Placed& g) const {
    return g.position.x_advance / advance_units * style_.spacing;
  }
  [[nodiscard]] double advance_y(const Placed& g) const {
    return g.position.y_advance / advance_units * style_.spacing;
  }

  /// Where the first glyph stands, in sizes. Heights are those of control points, in whole dots.
  planar::PlanePoint start() {
    double width = 0, ascent = 0, descent = 0;
    const bool is_horizontal = HB_DIRECTION_IS_HORIZONTAL(hb_buffer_get_direction(buffer_.get()));
    for (const Placed& g : glyphs_) {
      FT_BBox box;
      FT_Glyph_Get_CBox(g.glyph.get(), FT_GLYPH_BBOX_GRIDFIT, &box);
      if (is_horizontal) {
        width += advance_x(g);
        ascent = std::max(ascent, static_cast<double>(box.yMax) / advance_units);
        descent = std::max(descent, -static_cast<double>(box.yMin) / advance_units);
      } else {
        width = std::max(width, static_cast<double>(box.xMax - box.xMin) / advance_units);
        ascent += advance_y(g);
      }
    }
    return {x_of(width), y_of(ascent, descent)};
  }

  double x_of(double width) {
    if (style_.halign == "right") return -width;
    if (style_.halign == "center") return -width / 2;
    if (style_.halign != "left" && style_.halign != "default")
      notes_.push_back("has no halign '" + style_.halign + "': it is aligned left");
    return 0;
  }

  double y_of(double ascent, double descent) {
    if (style_.valign == "top") return -ascent;
    if (style_.valign == "center") return (descent - ascent) / 2;
    if (style_.valign == "bottom") return descent;
    if (style_.valign != "baseline" && style_.valign != "default")
      notes_.push_back("has no valign '" + style_.valign + "': it is aligned at the baseline");
    return 0;
  }

  static planar::PlanePoint point(const FT_Vector* v) {
    return {static_cast<double>(v->x) / outline_units, static_cast<double>(v->y) / outline_units};
  }

  static void draw(const Placed& placed, GlyphPen& pen) {
    FT_Outline_Funcs functions{};
    functions.move_to = [](const FT_Vector* p, void* to) { return static_cast<GlyphPen*>(to)->move_to(point(p)), 0; };
    functions.line_to = [](const FT_Vector* p, void* to) { return static_cast<GlyphPen*>(to)->line_to(point(p)), 0; };
    functions.conic_to = [](const FT_Vector* c, const FT_Vector* p, void* to) {
      return static_cast<GlyphPen*>(to)->curve_to(point(c), point(p)), 0;
    };
    functions.cubic_to = [](const FT_Vector* c, const FT_Vector* d, const FT_Vector* p, void* to) {
      return static_cast<GlyphPen*>(to)->curve_to(point(c), point(d), point(p)), 0;
    };
    FT_Outline_Decompose(&reinterpret_cast<FT_OutlineGlyph>(placed.glyph.get())->outline, &functions, &pen);
  }

  FT_Face face_;
  std::string name_;
  const TextStyle& style_;
  Buffer buffer_;
  std::vector<Placed> glyphs_;
  std::vector<std::string> notes_;
};

}  // namespace

struct Fonts::Libraries {
  explicit Libraries(const std::vector<std::string>& files) : config(FcInitLoadConfigAndFonts()) {
    FT_Library opened = nullptr;
    if (!config || FT_Init_FreeType(&opened) != 0)
      throw FontError("cannot be set: the fonts of the system are not found");
    library.reset(opened);
    for (const std::string& file : files)
      if (FcConfigAppFontAddFile(config.get(), bytes(file)) != FcTrue)
        throw FontError("cannot be set: there is no font in '" + file + "'");
  }

  const ChosenFont& font(const std::string& pattern) {
    const auto known = fonts.find(pattern);
    return known != fonts.end() ? known->second : fonts.emplace(pattern, chosen(pattern)).first->second;
  }

  [[nodiscard]] ChosenFont chosen(const std::string& asked) const {
    const Pattern pattern(FcNameParse(bytes(asked)));
    if (!pattern) throw FontError("has a font that is no pattern: '" + asked + "'");
    const std::string family = first_of(pattern.get(), FC_FAMILY), style = first_of(pattern.get(), FC_STYLE);
    FcPatternAddBool(pattern.get(), FC_OUTLINE, FcTrue);
    FcPatternAddBool(pattern.get(), FC_SCALABLE, FcTrue);
    FcConfigSubstitute(config.get(), pattern.get(), FcMatchPattern);
    FcDefaultSubstitute(pattern.get());
    FcResult result = FcResultMatch;
    const Pattern match(FcFontMatch(config.get(), pattern.get(), &result));
    if (!match) throw FontError("has a font that is not found, and there is no other: '" + asked + "'");
    ChosenFont font;
    font.face = opened(first_of(match.get(), FC_FILE), match.get());
    font.name = first_of(match.get(), FC_FAMILY) + ":style=" + first_of(match.get(), FC_STYLE);
    if ((!family.empty() && !has(match.get(), FC_FAMILY, family)) ||
        (!style.empty() && !has(match.get(), FC_STYLE, style)))
      font.note = "has a font that is not found: '" + asked + "'; '" + font.name + "' takes its place";
    return font;
  }

  [[nodiscard]] Face opened(const std::string& file, const FcPattern* match) const {
    int index = 0;
    FcPatternGetInteger(match, FC_INDEX, 0, &index);
    FT_Face face = nullptr;
    if (FT_New_Face(library.get(), file.c_str(), index, &face) != 0)
      throw FontError("has a font that is not read: '" + file + "'");
    Face owned(face);
    if (FT_Select_Charmap(face, FT_ENCODING_UNICODE) != 0 && FT_Select_Charmap(face, FT_ENCODING_MS_SYMBOL) != 0 &&
        (face->num_charmaps == 0 || FT_Set_Charmap(face, face->charmaps[0]) != 0))
      throw FontError("has a font that has no table of characters: '" + file + "'");
    return owned;
  }

  Config config;
  Library library;
  std::map<std::string, ChosenFont> fonts;  ///< by their patterns; they end before the library
};

Fonts::Fonts(std::vector<std::string> files) : files_(std::move(files)) {}
Fonts::~Fonts() = default;

bool Fonts::are_supported() { return true; }

TextOutlines Fonts::outlines(const TextStyle& style) {
  if (!libraries_) libraries_ = std::make_unique<Libraries>(files_);
  const std::string pattern = trimmed(style.font);
  const ChosenFont& font = libraries_->font(pattern.empty() ? "Liberation Sans:style=Regular" : pattern);
  TextOutlines outlines = Line(font.face.get(), font.name, style).drawn();
  if (!font.note.empty()) outlines.notes.insert(outlines.notes.begin(), font.note);
  return outlines;
}

}  // namespace strata::openscad

#else

namespace strata::openscad {

struct Fonts::Libraries {};

Fonts::Fonts(std::vector<std::string> files) : files_(std::move(files)) {}
Fonts::~Fonts() = default;

bool Fonts::are_supported() { return false; }

TextOutlines Fonts::outlines(const TextStyle&) {
  throw FontError("is not supported: this build reads no fonts (STRATA_WITH_FONTS)");
}

}  // namespace strata::openscad

#endif
