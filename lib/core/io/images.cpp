#include "core/io/images.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <set>
#include <string_view>

#include "core/io/file.h"

namespace strata::io {
namespace {

bool starts_with(const Image& image, std::string_view bytes) {
  return image.bytes.size() >= bytes.size() && std::memcmp(image.bytes.data(), bytes.data(), bytes.size()) == 0;
}

/// Letters, digits, and what no system minds; nothing hidden.
std::string safe_name(const Image& image) {
  std::string name = image.name;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '-' && c != '_') c = '_';
  while (name.starts_with('.')) name.erase(0, 1);
  if (name.empty()) name = "texture";
  const std::string type = media_type_of(image);
  if (!std::filesystem::path(name).has_extension()) name += type == "image/jpeg" ? ".jpg" : ".png";
  return name;
}

}  // namespace

std::string media_type_of(const Image& image) {
  if (!image.media_type.empty()) return image.media_type;
  return starts_with(image, "\xff\xd8") ? "image/jpeg" : "image/png";
}

std::vector<std::string> file_names_of(const std::vector<Image>& images) {
  std::vector<std::string> names;
  std::set<std::string> used;
  for (const Image& image : images) {
    const std::string wanted = safe_name(image);
    std::string name = wanted;
    for (std::size_t n = 1; !used.insert(name).second; ++n) name = std::to_string(n) + "_" + wanted;
    names.push_back(name);
  }
  return names;
}

std::vector<std::string> write_beside(const std::vector<Image>& images, FilesBeside& beside) {
  std::vector<std::string> names = file_names_of(images);
  for (std::size_t i = 0; i < names.size(); ++i) {
    names[i].insert(0, beside.stem() + "-");
    beside.add(names[i]).write({reinterpret_cast<const char*>(images[i].bytes.data()), images[i].bytes.size()});
  }
  return names;
}

Image read_image(const std::filesystem::path& path) {
  const File file(path);
  const FileBytes bytes(file);
  const auto* data = reinterpret_cast<const std::byte*>(bytes.view().data());
  std::string extension = path.extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  const char* const type = extension == ".jpg" || extension == ".jpeg" ? "image/jpeg"
                           : extension == ".png"                       ? "image/png"
                                                                       : "";
  return {path.filename().string(), type, {data, data + bytes.view().size()}};
}

std::string note_of_missing_image(const std::string& name) {
  return "the image '" + name.substr(0, 100) + "' left out: there is no such file beneath the folder of the model";
}

}  // namespace strata::io
