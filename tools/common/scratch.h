#pragma once
#include <filesystem>

/// A folder for temporary files, removed with all that is in it.
class Scratch {
 public:
  Scratch();  ///< throws std::filesystem::filesystem_error
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};
