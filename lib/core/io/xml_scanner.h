#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/input.h"

namespace strata::io {

/// Reads the tags of an XML document one after the other, without a tree: for large meshes in XML. UTF-8 only. Entities
/// are the five that XML has, and characters by number; document types, which define others, are refused. Elements may
/// be nested 200 deep. Failures are Malformed, with the offset.
class XmlScanner {
 public:
  struct Attribute {
    std::string_view name;   ///< without prefix
    std::string_view value;  ///< as it stands there; unescaped() gives the text
  };

  explicit XmlScanner(std::string_view text);

  /// Goes to the next start of an element within the element whose start is nearest before; false at its end. An
  /// element whose content is of no interest has to be left by skip().
  [[nodiscard]] bool next_child();
  /// The name of the element, without prefix.
  [[nodiscard]] std::string_view name() const { return name_; }
  [[nodiscard]] const std::vector<Attribute>& attributes() const { return attributes_; }
  /// The value of an attribute as it stands there; null if there is none.
  [[nodiscard]] const std::string_view* find(std::string_view attribute) const;
  /// The text of an attribute; empty if there is none.
  [[nodiscard]] std::string text_of(std::string_view attribute) const;
  /// Leaves the element.
  void skip();
  /// The text of an element without children, up to its end, which is passed.
  [[nodiscard]] std::string_view content();

  /// What is before the next end tag, cut at starts of tags into texts of some 100 kB; a single one if it is short. If
  /// a scanner of its own can read each of them, without Malformed, then together they find the elements that this one
  /// would find. Other texts, such as a list with comments across a cut, have to be read by this scanner.
  [[nodiscard]] std::vector<std::string_view> pieces() const;
  /// Goes behind `pieces`, as if next_child had returned all elements in them.
  void pass(const std::vector<std::string_view>& pieces);

  [[nodiscard]] std::size_t offset() const { return tag_; }  ///< of the last tag
  [[noreturn]] void fail_here(const std::string& reason) const { fail_at_line(tag_, reason); }

  /// A finite number; `what` is for the message.
  [[nodiscard]] double number(std::string_view value, const char* what) const;
  /// A whole number, at least 0.
  [[nodiscard]] std::uint32_t index(std::string_view value, const char* what) const;

 private:
  void skip_misc();   ///< text, comments, instructions
  void read_start();  ///< the tag at which it stands
  void read_end();
  void skip_blanks();
  [[nodiscard]] std::string_view read_name();
  void skip_behind(std::string_view mark, const char* what);

  std::string_view text_;
  std::size_t at_ = 0, tag_ = 0;
  std::vector<std::string_view> open_;  ///< whole names
  bool closed_ = false;                 ///< the element ended with its start: <a/>
  std::string_view name_;
  std::vector<Attribute> attributes_;
};

/// The text that an attribute's value or an element's content stands for.
[[nodiscard]] std::string unescaped(std::string_view raw);
/// A text that stands for this one in XML. Characters that XML has not are left out.
[[nodiscard]] std::string escaped(std::string_view text);

}  // namespace strata::io
