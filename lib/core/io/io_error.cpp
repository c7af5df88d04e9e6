#include <utility>

#include "strata/errors.h"

namespace strata {
namespace {

std::string sentence(const std::string& path, const IoError::Place& place, const std::string& reason) {
  std::string text = path;
  if (place.line) text.append(":").append(std::to_string(*place.line));
  if (place.byte) text.append(": byte ").append(std::to_string(*place.byte));
  return text.append(": ").append(reason);
}

/// Escapes unprintable characters: reasons quote the file, which may contain anything.
std::string printable(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return text;
}

}  // namespace

IoError::IoError(std::string path, Place place, std::string reason)
    : std::runtime_error(sentence(path, place, printable(reason))),
      path_(std::move(path)),
      place_(place),
      reason_(printable(std::move(reason))) {}

}  // namespace strata
