#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/// SHA-256 of bytes that come in pieces. O(bytes).
/// Source: FIPS 180-4, sections 4.1.2, 4.2.2, 5.1.1, 5.3.3 and 6.2.
class Sha256 {
 public:
  void add(std::string_view bytes);

  /// 64 hexadecimal digits, as sha256sum prints them. Requires that it is asked once, after the last piece.
  [[nodiscard]] std::string digest();

 private:
  static constexpr std::size_t block_size = 64;
  void compress(const unsigned char* block);

  std::array<std::uint32_t, 8> state_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                         0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<unsigned char, block_size> block_ = {};  // the first filled_ bytes of it wait for more
  std::size_t filled_ = 0;
  std::uint64_t length_ = 0;  // in bytes
};

[[nodiscard]] std::string sha256(std::string_view bytes);

/// Of a file's content. Throws strata::IoError when it cannot be read.
[[nodiscard]] std::string sha256_of_file(const std::string& path);
