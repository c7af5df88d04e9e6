#pragma once
#include <deque>
#include <filesystem>
#include <string>
#include <utility>

#include "core/io/sink.h"

namespace strata::io {

/// Files that belong to a target and stand beside it. Like the target, they become visible when all are complete.
class FilesBeside {
 public:
  explicit FilesBeside(std::filesystem::path target) : target_(std::move(target)) {}

  /// The target's name without its extension, with which names of files beside it start.
  [[nodiscard]] std::string stem() const { return target_.stem().string(); }
  Sink& add(const std::string& name) { return files_.emplace_back(target_.parent_path() / name); }

  void complete() {
    for (FileSink& file : files_) file.complete();
  }
  void finish() {
    for (FileSink& file : files_) file.finish();
  }

 private:
  std::filesystem::path target_;
  std::deque<FileSink> files_;
};

}  // namespace strata::io
