#include "core/io/zip_archive.h"

#include <tbb/parallel_for.h>
#include <zlib.h>
#if STRATA_WITH_LIBDEFLATE
#include <libdeflate.h>
#endif

#include <algorithm>
#include <bit>
#include <limits>
#include <vector>

#include "core/io/binary.h"

namespace strata::io {
namespace {

constexpr std::size_t end_size = 22, wide_locator_size = 20, wide_end_size = 56, entry_size = 46, local_size = 30;
constexpr std::uint32_t end_mark = 0x06054b50, wide_locator_mark = 0x07064b50, wide_end_mark = 0x06064b50,
                        entry_mark = 0x02014b50, local_mark = 0x04034b50;
constexpr std::uint64_t most_members = 1 << 16;

template <class T>
T field(std::string_view bytes, std::size_t at) {
  return load<T>(bytes.data() + at, std::endian::little);
}

std::string canonical(std::string_view name) {
  while (name.starts_with('/')) name.remove_prefix(1);
  std::string text(name);
  for (char& c : text)
    if (c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
    else if (c == '\\')
      c = '/';
  return text;
}

/// Where the record that ends the directory is: behind it there is a comment at most.
std::size_t find_end(std::string_view archive) {
  constexpr std::size_t longest_comment = 0xffff;
  if (archive.size() >= end_size) {
    const std::size_t last = archive.size() - end_size;
    const std::size_t first = last > longest_comment ? last - longest_comment : 0;
    for (std::size_t at = last + 1; at-- > first;)
      if (field<std::uint32_t>(archive, at) == end_mark) return at;
  }
  fail("no archive, or a truncated one: there is no end of a zip directory");
}

/// Fields of 32 bits that are too small are in an extra field with 64.
class WideFields {
 public:
  explicit WideFields(std::string_view extra) {
    while (extra.size() >= 4) {
      const std::size_t size = field<std::uint16_t>(extra, 2);
      if (size > extra.size() - 4) return;
      if (field<std::uint16_t>(extra, 0) == 1) {
        values_ = extra.substr(4, size);
        return;
      }
      extra.remove_prefix(4 + size);
    }
  }
  std::uint64_t value(std::uint32_t narrow) {
    if (narrow != std::numeric_limits<std::uint32_t>::max()) return narrow;
    if (values_.size() < 8) fail("a member of the archive is 4 GB and has no size in 64 bits");
    const auto wide = field<std::uint64_t>(values_, 0);
    values_.remove_prefix(8);
    return wide;
  }

 private:
  std::string_view values_;
};

/// Inflates raw deflated data to exactly the bytes that there is room for. False where the data are damaged.
#if STRATA_WITH_LIBDEFLATE
[[nodiscard]] bool inflate_to(std::string_view packed, UnpackedBytes& to) {
  const std::unique_ptr<libdeflate_decompressor, void (*)(libdeflate_decompressor*)> decompressor(
      libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
  if (decompressor == nullptr) throw std::bad_alloc();
  return libdeflate_deflate_decompress(decompressor.get(), packed.data(), packed.size(), to.data(), to.view().size(),
                                       nullptr) == LIBDEFLATE_SUCCESS;
}
#else
[[nodiscard]] bool inflate_to(std::string_view packed, UnpackedBytes& to) {
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw std::bad_alloc();
  const std::unique_ptr<z_stream, int (*)(z_streamp)> end(&stream, inflateEnd);
  std::size_t in = 0, out = 0;
  const std::size_t room = to.view().size();
  int status = Z_OK;
  char none = 0;
  while (status == Z_OK) {
    constexpr std::size_t most = 1U << 30;
    const std::size_t offered = std::min(packed.size() - in, most), asked = std::min(room - out, most);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + in));
    stream.avail_in = static_cast<uInt>(offered);
    stream.next_out = reinterpret_cast<Bytef*>(room == 0 ? &none : to.data() + out);
    stream.avail_out = static_cast<uInt>(asked);
    status = inflate(&stream, Z_NO_FLUSH);
    const std::size_t used = offered - stream.avail_in, made = asked - stream.avail_out;
    in += used;
    out += made;
    if (status == Z_OK && used == 0 && made == 0) break;
  }
  if (status == Z_MEM_ERROR) throw std::bad_alloc();
  return status == Z_STREAM_END && out == room;
}
#endif

/// CRC-32, of parts on all threads.
std::uint32_t checksum(std::string_view bytes) {
  constexpr std::size_t size = 1 << 20;
  std::vector<uLong> of_part(bytes.size() / size + 1);
  const auto part = [&](std::size_t i) { return bytes.substr(i * size, size); };
  tbb::parallel_for(std::size_t{0}, of_part.size(), [&](std::size_t i) {
    of_part[i] = crc32_z(0, reinterpret_cast<const Bytef*>(part(i).data()), part(i).size());
  });
  uLong whole = of_part[0];
  for (std::size_t i = 1; i < of_part.size(); ++i)
    whole = crc32_combine(whole, of_part[i], static_cast<z_off_t>(part(i).size()));
  return static_cast<std::uint32_t>(whole);
}

}  // namespace

ZipArchive::ZipArchive(std::string_view archive) : archive_(archive) {
  constexpr std::uint64_t least = std::uint64_t{64} << 20, ratio = 100;
  budget_ = least + ratio * archive.size();
  read_directory();
}

bool ZipArchive::is_archive(std::string_view bytes) {
  return bytes.size() >= 4 &&
         (field<std::uint32_t>(bytes, 0) == local_mark || field<std::uint32_t>(bytes, 0) == end_mark);
}

std::string_view ZipArchive::bytes_at(std::uint64_t offset, std::uint64_t size) const {
  if (offset > archive_.size() || size > archive_.size() - offset) fail("the archive is truncated or damaged");
  return archive_.substr(offset, size);
}

void ZipArchive::read_directory() {
  const std::size_t end = find_end(archive_);
  const std::string_view record = bytes_at(end, end_size);
  std::uint64_t count = field<std::uint16_t>(record, 10), at = field<std::uint32_t>(record, 16);
  if (end >= wide_locator_size && field<std::uint32_t>(archive_, end - wide_locator_size) == wide_locator_mark) {
    const std::string_view wide = bytes_at(field<std::uint64_t>(archive_, end - wide_locator_size + 8), wide_end_size);
    if (field<std::uint32_t>(wide, 0) != wide_end_mark) fail("the archive is damaged: no directory in 64 bits");
    count = field<std::uint64_t>(wide, 32);
    at = field<std::uint64_t>(wide, 48);
  }
  if (count > most_members) fail("an archive of more than 65536 members");
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::string_view entry = bytes_at(at, entry_size);
    if (field<std::uint32_t>(entry, 0) != entry_mark) fail("the directory of the archive is damaged");
    const std::size_t name = field<std::uint16_t>(entry, 28), extra = field<std::uint16_t>(entry, 30),
                      comment = field<std::uint16_t>(entry, 32);
    const std::string_view rest = bytes_at(at + entry_size, name + extra + comment);
    WideFields wide(rest.substr(name, extra));
    Member m;
    m.name = rest.substr(0, name);
    m.key = canonical(m.name);
    m.flags = field<std::uint16_t>(entry, 8);
    m.method = field<std::uint16_t>(entry, 10);
    m.checksum = field<std::uint32_t>(entry, 16);
    m.unpacked = wide.value(field<std::uint32_t>(entry, 24));
    m.packed = wide.value(field<std::uint32_t>(entry, 20));
    m.offset = wide.value(field<std::uint32_t>(entry, 42));
    members_.push_back(std::move(m));
    at += entry_size + rest.size();
  }
}

const ZipArchive::Member* ZipArchive::find(std::string_view name) const {
  const std::string wanted = canonical(name);
  const auto found = std::find_if(members_.begin(), members_.end(), [&](const Member& m) { return m.key == wanted; });
  return found == members_.end() ? nullptr : &*found;
}

std::string ZipArchive::first_with_end(std::string_view end) const {
  const std::string wanted = canonical(end);
  for (const Member& m : members_)
    if (m.key.ends_with(wanted)) return m.name;
  return {};
}

std::string_view ZipArchive::packed_bytes(const Member& member) const {
  const std::string_view local = bytes_at(member.offset, local_size);
  if (field<std::uint32_t>(local, 0) != local_mark)
    fail("member " + io::quoted(member.name) + " is not where it should be");
  const std::uint64_t skipped = local_size + field<std::uint16_t>(local, 26) + field<std::uint16_t>(local, 28);
  return bytes_at(member.offset + skipped, member.packed);
}

UnpackedBytes ZipArchive::unpack(std::string_view name) {
  constexpr std::uint64_t most_of_deflate = 1032;  // bytes for a byte
  constexpr std::uint16_t encrypted = 1, stored = 0, deflated = 8;
  const Member* const member = find(name);
  if (member == nullptr) fail("the archive has no member " + io::quoted(name));
  if ((member->flags & encrypted) != 0) fail("member " + io::quoted(name) + " of the archive is encrypted");
  if (member->method != stored && member->method != deflated)
    fail("member " + io::quoted(name) + " of the archive is packed by another method than deflate");
  const std::string_view packed = packed_bytes(*member);
  if (member->unpacked > budget_)
    fail("the archive unpacks to more than 64 MB and 100 times its size, which is refused");
  if (member->unpacked / most_of_deflate > packed.size())
    fail("member " + io::quoted(name) + " has an impossible size");
  budget_ -= member->unpacked;
  UnpackedBytes bytes(member->unpacked);
  bool is_whole = packed.size() == member->unpacked;
  if (member->method == deflated)
    is_whole = inflate_to(packed, bytes);
  else if (is_whole)
    std::copy(packed.begin(), packed.end(), bytes.data());
  if (!is_whole) fail("member " + io::quoted(name) + " of the archive is damaged");
  if (checksum(bytes.view()) != member->checksum)
    fail("member " + io::quoted(name) + " of the archive is damaged: its checksum differs");
  return bytes;
}

}  // namespace strata::io
