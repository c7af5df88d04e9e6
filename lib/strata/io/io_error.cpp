#include "strata/io/io_error.h"

#include <utility>

namespace strata {
namespace {

std::string sentence(const std::string& path, const IoError::Place& place, const std::string& reason) {
  std::string text = path;
  if (place.line) text.append(":").append(std::to_string(*place.line));
  if (place.byte) text.append(": byte ").append(std::to_string(*place.byte));
  return text.append(": ").append(reason);
}

}  // namespace

IoError::IoError(std::string path, Place place, std::string reason)
    : std::runtime_error(sentence(path, place, reason)),
      path_(std::move(path)),
      place_(place),
      reason_(std::move(reason)) {}

}  // namespace strata
