#include "common/output_file.h"

#include <iostream>

OutputFile::OutputFile(const std::string& path) {
  if (path == "-") {
    stream_.emplace(std::cout, "standard output");
  } else {
    file_.emplace(path);
  }
}

void OutputFile::write(std::string_view bytes) { file_ ? file_->write(bytes) : stream_->write(bytes); }

void OutputFile::finish() { file_ ? file_->finish() : stream_->finish(); }
