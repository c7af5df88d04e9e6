#include "extensions/openscad/picture.h"

#include <cstdint>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string_view>

#if STRATA_WITH_PNG
#include <png.h>

#include <csetjmp>
#endif

namespace strata::openscad {
namespace {

#if STRATA_WITH_PNG
constexpr std::uint64_t most_pixels = 1 << 26;

/// libpng leaves its functions by longjmp. So each function that calls it has no object with a destructor, and returns
/// false where `error_` holds the reason.
class PngReader {
 public:
  explicit PngReader(std::string_view bytes) : bytes_(bytes) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw std::bad_alloc();
    }
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  Picture picture() {
    if (!read_header()) throw std::runtime_error(error_);
    const std::uint64_t width = png_get_image_width(png_, info_), height = png_get_image_height(png_, info_);
    if (width > most_pixels / height) throw std::runtime_error("it has more than 67108864 pixels");
    Picture picture{width, height, std::vector<unsigned char>(3 * width * height)};
    for (std::size_t y = 0; y < height; ++y) rows_.push_back(picture.colours.data() + 3 * width * y);
    if (!read_rows()) throw std::runtime_error(error_);
    return picture;
  }

 private:
  bool read_header() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_read_fn(png_, this, give);
    png_read_info(png_, info_);
    png_set_palette_to_rgb(png_);
    png_set_expand_gray_1_2_4_to_8(png_);
    png_set_gray_to_rgb(png_);
    png_set_strip_16(png_);
    png_set_strip_alpha(png_);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return true;
  }
  bool read_rows() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_image(png_, rows_.data());
    png_read_end(png_, nullptr);
    return true;
  }

  static void give(png_structp png, png_bytep to, std::size_t size) {
    auto& self = *static_cast<PngReader*>(png_get_io_ptr(png));
    if (size > self.bytes_.size()) png_error(png, "it ends too early");
    std::memcpy(to, self.bytes_.data(), size);
    self.bytes_.remove_prefix(size);
  }
  static void on_error(png_structp png, png_const_charp message) {
    auto& self = *static_cast<PngReader*>(png_get_error_ptr(png));
    std::strncpy(self.error_, message, sizeof self.error_ - 1);
    png_longjmp(png, 1);
  }
  static void on_warning(png_structp /*png*/, png_const_charp /*message*/) {}

  std::string_view bytes_;
  std::vector<png_bytep> rows_;
  char error_[128] = {};
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};
#endif

}  // namespace

bool is_png(const std::string& bytes) { return bytes.rfind("\x89PNG\r\n\x1a\n", 0) == 0; }

Picture picture_of_png([[maybe_unused]] const std::string& bytes) {
#if STRATA_WITH_PNG
  return PngReader(bytes).picture();
#else
  throw std::runtime_error("this build has no libpng");
#endif
}

std::vector<std::vector<double>> heights_of(const Picture& picture, bool is_inverted) {
  std::vector<std::vector<double>> rows;
  rows.reserve(picture.height);
  for (std::size_t y = picture.height; y-- > 0;) {
    std::vector<double>& row = rows.emplace_back();
    row.reserve(picture.width);
    for (std::size_t x = 0; x < picture.width; ++x) {
      const unsigned char* colour = &picture.colours[3 * (y * picture.width + x)];
      const double luminance = 0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2];
      row.push_back(100.0 / 255 * (is_inverted ? 1 - luminance : luminance));
    }
  }
  return rows;
}

}  // namespace strata::openscad
