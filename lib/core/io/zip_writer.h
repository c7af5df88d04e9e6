#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/sink.h"

namespace strata::io {

/// Writes a zip archive into a sink, member after member. A member is deflated in blocks of a quarter megabyte, in
/// parallel: the same bytes for any number of threads. What is deflated stays in memory until the member ends.
class ZipWriter {
 public:
  explicit ZipWriter(Sink& sink) : sink_(sink) {}

  /// A member that is text or the like.
  void add(std::string_view name, std::string_view bytes);
  /// A member that is compressed already.
  void store(std::string_view name, std::string_view bytes);
  /// The directory.
  void finish();

  /// A member that is written piece by piece, and ends with finish().
  class Member : public Sink {
   public:
    Member(ZipWriter& zip, std::string name) : zip_(zip), name_(std::move(name)) {}
    void write(std::string_view bytes) override;
    void finish();

   private:
    void deflate_waiting(bool all);

    ZipWriter& zip_;
    std::string name_;
    std::string waiting_, packed_;
    std::uint64_t unpacked_ = 0;
    std::uint32_t checksum_ = 0;
  };

 private:
  struct Entry {
    std::string name;
    std::uint16_t method;
    std::uint32_t checksum;
    std::uint64_t packed, unpacked, offset;
  };
  void put(Entry entry, std::string_view packed);
  void write(std::string_view bytes);

  Sink& sink_;
  std::uint64_t written_ = 0;
  std::vector<Entry> entries_;
};

}  // namespace strata::io
