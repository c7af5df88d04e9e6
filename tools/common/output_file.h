#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "core/io/sink.h"

/// Where a verb's data goes: a file that appears when it is complete, or standard output for "-". Without finish() no
/// file appears. Throws strata::IoError.
class OutputFile : public strata::io::Sink {
 public:
  explicit OutputFile(const std::string& path);
  void write(std::string_view bytes) override;
  void finish();

 private:
  std::optional<strata::io::FileSink> file_;
  std::optional<strata::io::StreamSink> stream_;
};
