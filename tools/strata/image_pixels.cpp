#include "image_pixels.h"

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>

#if STRATA_WITH_JPEG
#include <jpeglib.h>

#include <csetjmp>
#include <cstdio>  // before the header of libjpeg, which needs it
#endif
#if STRATA_WITH_PNG
#include <png.h>
#endif

namespace {

constexpr std::uint64_t most_pixels = 1 << 26;

[[noreturn]] void fail(const strata::Image& image, const std::string& why) {
  throw std::runtime_error("the image " + image.name + " " + why);
}

/// Memory for a picture. Not used where there is no decoder.
[[maybe_unused]] ImagePixels blank(const strata::Image& image, std::uint64_t width, std::uint64_t height) {
  if (width == 0 || height == 0) fail(image, "is empty");
  if (width > most_pixels / height) fail(image, "is too large");
  return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height),
          std::vector<std::uint8_t>(3 * width * height)};
}

template <std::size_t N>
bool begins_with(const strata::Image& image, const std::array<unsigned char, N>& magic) {
  if (image.bytes.size() < N) return false;
  for (std::size_t i = 0; i < N; ++i)
    if (std::to_integer<unsigned char>(image.bytes[i]) != magic[i]) return false;
  return true;
}

#if STRATA_WITH_PNG
ImagePixels pixels_of_png(const strata::Image& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const auto ensure = [&](int done) {
    if (done != 0) return;
    const std::string why = png.message;
    png_image_free(&png);
    fail(image, "cannot be decoded: " + why);
  };
  ensure(png_image_begin_read_from_memory(&png, image.bytes.data(), image.bytes.size()));
  png.format = PNG_FORMAT_RGB;
  ImagePixels pixels;
  try {
    pixels = blank(image, png.width, png.height);
  } catch (...) {
    png_image_free(&png);
    throw;
  }
  const png_color white{255, 255, 255};
  ensure(png_image_finish_read(&png, &white, pixels.rgb.data(), 0, nullptr));
  return pixels;
}
#endif

#if STRATA_WITH_JPEG
/// Errors of libjpeg come back by a jump, in which no destructors may lie: between `setjmp` and `error_exit` there are
/// only those of C.
struct JpegErrors {
  jpeg_error_mgr manager;
  std::jmp_buf back;
  std::array<char, JMSG_LENGTH_MAX> message;
};

[[noreturn]] void jump_back(j_common_ptr decoder) {
  auto* const errors = reinterpret_cast<JpegErrors*>(decoder->err);
  decoder->err->format_message(decoder, errors->message.data());
  std::longjmp(errors->back, 1);
}

/// Reads the header, or with `rgb` the pixels as well. False: `errors` says why.
bool read_jpeg(jpeg_decompress_struct& decoder, JpegErrors& errors, const strata::Image& image, std::uint8_t* rgb) {
  decoder.err = jpeg_std_error(&errors.manager);
  errors.manager.error_exit = jump_back;
  errors.manager.emit_message = [](j_common_ptr, int) {};
  if (setjmp(errors.back) != 0) {
    jpeg_destroy_decompress(&decoder);
    return false;
  }
  jpeg_create_decompress(&decoder);
  jpeg_mem_src(&decoder, reinterpret_cast<const unsigned char*>(image.bytes.data()), image.bytes.size());
  jpeg_read_header(&decoder, TRUE);
  if (rgb != nullptr) {
    decoder.out_color_space = JCS_RGB;
    jpeg_start_decompress(&decoder);
    while (decoder.output_scanline < decoder.output_height) {
      JSAMPROW row = rgb + std::size_t{3} * decoder.output_width * decoder.output_scanline;
      jpeg_read_scanlines(&decoder, &row, 1);
    }
  }
  jpeg_destroy_decompress(&decoder);
  return true;
}

ImagePixels pixels_of_jpeg(const strata::Image& image) {
  jpeg_decompress_struct decoder{};
  JpegErrors errors{};
  const auto ensure = [&](bool done) {
    if (!done) fail(image, std::string("cannot be decoded: ") + errors.message.data());
  };
  ensure(read_jpeg(decoder, errors, image, nullptr));
  ImagePixels pixels = blank(image, decoder.image_width, decoder.image_height);
  ensure(read_jpeg(decoder, errors, image, pixels.rgb.data()));
  return pixels;
}
#endif

}  // namespace

ImagePixels pixels_of(const strata::Image& image) {
  if (begins_with(image, std::array<unsigned char, 4>{0x89, 'P', 'N', 'G'})) {
#if STRATA_WITH_PNG
    return pixels_of_png(image);
#else
    fail(image, "is a PNG, which this program was built without");
#endif
  }
  if (begins_with(image, std::array<unsigned char, 3>{0xff, 0xd8, 0xff})) {
#if STRATA_WITH_JPEG
    return pixels_of_jpeg(image);
#else
    fail(image, "is a JPEG, which this program was built without");
#endif
  }
  fail(image, "is neither PNG nor JPEG");
}
