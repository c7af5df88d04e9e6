#include "core/io/mtl.h"

#include <algorithm>
#include <array>

#include "core/io/folder_of_model.h"
#include "core/io/images.h"
#include "core/io/line_end.h"
#include "core/io/text_lines.h"
#include "core/system/decimal.h"

namespace strata::io {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = std::min(text.find_first_not_of(blanks), text.size());
  return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

/// Splits the first word off.
std::string_view next_word(std::string_view& text) {
  text = trimmed(text);
  const std::size_t end = std::min(text.find_first_of(blanks), text.size());
  const std::string_view word = text.substr(0, end);
  text = trimmed(text.substr(end));
  return word;
}

bool read_number(std::string_view& text, double& x) {
  const std::string_view word = next_word(text);
  const auto [end, error] = system::from_chars(word.data(), word.data() + word.size(), x);
  return error == std::errc{} && end == word.data() + word.size() && x >= 0 && x <= 1;
}

class MtlReader {
 public:
  MtlReader(const std::filesystem::path& folder, const std::filesystem::path& library, Attributes& attributes)
      : folder_(folder), library_(library), attributes_(attributes) {}

  void read_line(std::string_view line) {
    const std::string_view word = next_word(line);
    if (word == "newmtl") {
      attributes_.materials.push_back({});
      attributes_.materials.back().name = line;
      is_open_ = true;
    }
    if (!is_open_) return;
    Material& m = attributes_.materials.back();
    double x = 0;
    if (word == "Kd") {
      std::array<double, 3> color{};
      if (read_number(line, color[0]) && read_number(line, color[1]) && read_number(line, color[2]))
        std::copy(color.begin(), color.end(), m.color.begin());
    } else if (word == "d" && read_number(line, x)) {
      m.color[3] = x;
    } else if (word == "Tr" && read_number(line, x)) {
      m.color[3] = 1 - x;
    } else if (word == "Pm" && read_number(line, x)) {
      m.metallic = x;
    } else if (word == "Pr" && read_number(line, x)) {
      m.roughness = x;
    } else if (word == "map_Kd") {
      read_map(line, m);
    }
  }

  std::vector<std::string> notes;

 private:
  /// Options may precede the name, which may have blanks: the whole, or the last word.
  void read_map(std::string_view line, Material& m) {
    std::string name(line);
    std::replace(name.begin(), name.end(), '\\', '/');
    const std::filesystem::path beside = library_.parent_path();
    auto path = file_beneath(&folder_, (beside / name).string());
    if (!path) {
      name = name.substr(name.find_last_of(blanks) + 1);
      path = file_beneath(&folder_, (beside / name).string());
    }
    if (!path) {
      notes.push_back(note_of_missing_image(name));
      return;
    }
    const auto found = std::find(paths_.begin(), paths_.end(), *path);
    if (found != paths_.end()) {
      m.image = static_cast<std::uint32_t>(first_image_ + static_cast<std::size_t>(found - paths_.begin()));
      return;
    }
    m.image = static_cast<std::uint32_t>(attributes_.images.size());
    attributes_.images.push_back(read_image(*path));
    paths_.push_back(*path);
  }

  const std::filesystem::path& folder_;
  const std::filesystem::path& library_;
  Attributes& attributes_;
  std::size_t first_image_ = attributes_.images.size();
  std::vector<std::filesystem::path> paths_;
  bool is_open_ = false;
};

}  // namespace

std::vector<std::string> read_mtl(std::string_view text, const std::filesystem::path& folder,
                                  const std::filesystem::path& library, Attributes& attributes) {
  MtlReader reader(folder, library, attributes);
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end) {
    const char* const stop = find_line_end(at, end);
    reader.read_line({at, static_cast<std::size_t>(stop - at)});
    at = stop == end ? end : behind_line_end(stop, end);
  }
  return std::move(reader.notes);
}

std::string mtl_name(const Attributes& attributes, std::size_t material) {
  std::string name = attributes.materials[material].name;
  for (char& c : name)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  name = std::string(trimmed(name));
  return name.empty() ? "material" + std::to_string(material) : name;
}

std::string mtl_text(const Attributes& attributes, const std::vector<std::string>& image_names) {
  std::string text;
  for (std::size_t i = 0; i < attributes.materials.size(); ++i) {
    const Material& m = attributes.materials[i];
    text += "newmtl " + mtl_name(attributes, i) + "\nKd";
    for (std::size_t k = 0; k < 3; ++k) text += " " + number_text(m.color[k]);
    text += "\nd " + number_text(m.color[3]) + "\nPm " + number_text(m.metallic) + "\nPr " + number_text(m.roughness) +
            "\n";
    if (m.image) text += "map_Kd " + image_names[*m.image] + "\n";
  }
  return text;
}

}  // namespace strata::io
