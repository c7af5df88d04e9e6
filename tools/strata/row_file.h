#pragma once
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "common/output_file.h"

/// A file of rows after a header that may say how many there are. Where the count is known only in the end, rows wait
/// in a temporary file, not in memory.
class RowFile {
 public:
  using Header = std::function<std::string(std::uint64_t count)>;

  /// `count`: of rows, where it is known or the header does not say it. Throws strata::IoError.
  RowFile(const std::string& path, Header header, std::optional<std::uint64_t> count);

  void write(std::string_view rows);
  /// Requires the number of rows written. Throws strata::IoError.
  void finish(std::uint64_t count);

 private:
  struct CloseFile {
    void operator()(std::FILE* f) const { std::fclose(f); }
  };
  void copy_waiting_rows();
  [[noreturn]] static void fail_waiting();

  OutputFile file_;
  Header header_;
  std::unique_ptr<std::FILE, CloseFile> waiting_;
};
