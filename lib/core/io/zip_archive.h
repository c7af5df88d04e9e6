#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/containers/huge_pages.h"
#include "core/io/input.h"

namespace strata::io {

/// Bytes that were unpacked.
class UnpackedBytes {
 public:
  UnpackedBytes() = default;
  explicit UnpackedBytes(std::size_t size) : bytes_(std::make_unique_for_overwrite<char[]>(size)), size_(size) {
    prefer_huge_pages(bytes_.get(), size);
  }
  [[nodiscard]] std::string_view view() const { return {bytes_.get(), size_}; }
  [[nodiscard]] char* data() { return bytes_.get(); }

 private:
  std::unique_ptr<char[]> bytes_;
  std::size_t size_ = 0;
};

/// A zip archive in memory: its directory, and its members one by one. Nothing is written to disk, so names of members
/// lead nowhere. All that is unpacked takes 64 MB at most plus 100 times the bytes of the archive: more is an error, as
/// are members that are encrypted, of other methods than deflate, or whose sizes or checksums are not as stated. Throws
/// Malformed.
class ZipArchive {
 public:
  explicit ZipArchive(std::string_view archive);

  /// True for archives, by their first bytes.
  [[nodiscard]] static bool is_archive(std::string_view bytes);
  [[nodiscard]] bool has(std::string_view name) const { return find(name) != nullptr; }
  /// The first member whose name ends so, or an empty name.
  [[nodiscard]] std::string first_with_end(std::string_view end) const;
  /// Unpacks a member. Names are compared without case and without a slash before them.
  [[nodiscard]] UnpackedBytes unpack(std::string_view name);

 private:
  struct Member {
    std::string name, key;  ///< as it stands there, and as it is compared
    std::uint16_t flags = 0, method = 0;
    std::uint32_t checksum = 0;
    std::uint64_t packed = 0, unpacked = 0, offset = 0;
  };
  [[nodiscard]] const Member* find(std::string_view name) const;
  [[nodiscard]] std::string_view bytes_at(std::uint64_t offset, std::uint64_t size) const;
  [[nodiscard]] std::string_view packed_bytes(const Member& member) const;
  void read_directory();

  std::string_view archive_;
  std::vector<Member> members_;
  std::uint64_t budget_;  ///< bytes that may still be unpacked
};

}  // namespace strata::io
