#include "core/io/gltf_buffers.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "core/containers/huge_pages.h"
#include "core/io/binary.h"
#include "core/io/face_list.h"
#include "core/io/folder_of_model.h"

namespace strata::io {
namespace {

constexpr std::size_t byte = 5120, unsigned_byte = 5121, signed_short = 5122, unsigned_short = 5123,
                      unsigned_int = 5125, float32 = 5126;

std::size_t size_of(std::size_t type) {
  if (type == byte || type == unsigned_byte) return 1;
  if (type == signed_short || type == unsigned_short) return 2;
  return type == unsigned_int || type == float32 ? 4 : 0;
}

std::size_t components_of(const GltfValue& type) {
  constexpr std::array<std::pair<std::string_view, std::size_t>, 4> known{
      std::pair<std::string_view, std::size_t>{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
  for (const auto& [name, components] : known)
    if (type.text() == name) return components;
  type.refuse("accessors of this type are not read");
}

template <class T>
double load_double(const char* at) {
  return static_cast<double>(load<T>(at, std::endian::little));
}

double number_at(const char* at, std::size_t type) {
  if (type == float32) return load_double<float>(at);
  if (type == unsigned_int) return load_double<std::uint32_t>(at);
  if (type == unsigned_short) return load_double<std::uint16_t>(at);
  if (type == signed_short) return load_double<std::int16_t>(at);
  return type == byte ? load_double<std::int8_t>(at) : load_double<std::uint8_t>(at);
}

/// Numbers of one type, in parallel. False: some are not finite.
template <class T>
bool decode(const char* from, std::size_t stride, std::size_t components, std::vector<double>& to) {
  std::atomic<bool> are_finite = true;
  const std::size_t count = to.size() / components;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1 << 14), [&](const auto& range) {
    bool all = true;
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      for (std::size_t k = 0; k < components; ++k) {
        const double x = load_double<T>(from + i * stride + k * sizeof(T));
        if constexpr (std::is_floating_point_v<T>) all = all && std::isfinite(x);
        to[i * components + k] = x;
      }
    if (!all) are_finite = false;
  });
  return are_finite;
}

bool decode(const char* from, std::size_t stride, std::size_t components, std::size_t type, std::vector<double>& to) {
  if (type == float32) return decode<float>(from, stride, components, to);
  if (type == unsigned_int) return decode<std::uint32_t>(from, stride, components, to);
  if (type == unsigned_short) return decode<std::uint16_t>(from, stride, components, to);
  if (type == signed_short) return decode<std::int16_t>(from, stride, components, to);
  if (type == byte) return decode<std::int8_t>(from, stride, components, to);
  return decode<std::uint8_t>(from, stride, components, to);
}

[[noreturn]] void refuse_not_finite(const GltfValue& accessor) { accessor.refuse("has a number that is not finite"); }

double divisor_of(std::size_t type) {
  if (type == byte) return 127;
  if (type == unsigned_byte) return 255;
  return type == signed_short ? 32767 : 65535;
}

}  // namespace

/// Where elements are.
struct GltfBuffers::Layout {
  std::string_view bytes;  ///< from the first element on
  std::size_t stride;
};

GltfBuffers::GltfBuffers(const GltfValue& document, std::string_view chunk, const std::filesystem::path* folder)
    : document_(document), chunk_(chunk), folder_(folder) {
  constexpr std::uint64_t least = 8'000'000;
  left_ = least + 2 * chunk.size();
}

void GltfBuffers::use(std::uint64_t numbers) {
  if (numbers > left_)
    fail("accessors unfold to more than 8 million numbers and twice the bytes of the buffers, which is refused");
  left_ -= numbers;
}

std::optional<std::string> GltfBuffers::resource(const std::string& uri) {
  constexpr std::string_view mark = ";base64,";
  if (uri.starts_with("data:")) {
    const std::size_t found = uri.find(mark);
    if (found == std::string::npos) return {};
    return base64_decoded(std::string_view(uri).substr(found + mark.size()));
  }
  const auto path = file_beneath(folder_, percent_decoded(uri));
  if (!path) return {};
  const File file(*path);
  return std::string(FileBytes(file).view());
}

std::string_view GltfBuffers::buffer(std::size_t index) {
  const GltfValue value = document_.at("buffers").at(index);
  const std::size_t length = value.at("byteLength").index();
  std::string_view bytes = chunk_;
  if (value.has("uri") || index > 0) {
    const auto [place, is_new] = buffers_.try_emplace(index);
    if (is_new) {
      const GltfValue place_of_data = value.at("uri");
      const std::string& uri = place_of_data.text();
      auto loaded = resource(uri);
      if (!loaded)
        value.refuse(uri.starts_with("data:")
                         ? "its data are not in base64"
                         : "there is no file " + io::quoted(uri) + " beneath the folder of the model");
      place->second = std::move(*loaded);
      left_ += 2 * place->second.size();
    }
    bytes = place->second;
  }
  if (bytes.size() < length)
    value.refuse("has " + std::to_string(bytes.size()) + " bytes in place of " + std::to_string(length));
  return bytes.substr(0, length);
}

std::string_view GltfBuffers::view(std::size_t index) {
  const GltfValue view = document_.at("bufferViews").at(index);
  const std::string_view bytes = buffer(view.at("buffer").index());
  const std::size_t offset = view.index_or("byteOffset", 0), length = view.at("byteLength").index();
  if (offset > bytes.size() || length > bytes.size() - offset) view.refuse("exceeds its buffer");
  if (view.has("extensions") && view.at("extensions").has("EXT_meshopt_compression"))
    view.refuse("is compressed (EXT_meshopt_compression), which is not read");
  return bytes.substr(offset, length);
}

GltfBuffers::Layout GltfBuffers::layout(const GltfValue& accessor, std::size_t view_index, std::size_t offset,
                                        std::size_t count, std::size_t type, std::size_t components) {
  const std::string_view bytes = view(view_index);
  const std::size_t size = size_of(type) * components;
  const std::size_t stride = document_.at("bufferViews").at(view_index).index_or("byteStride", size);
  constexpr std::size_t most_stride = 1 << 20;
  if (stride < size || stride > most_stride) accessor.refuse("has an impossible stride");
  const bool fits =
      offset <= bytes.size() &&
      (count == 0 || (bytes.size() - offset >= size && count - 1 <= (bytes.size() - offset - size) / stride));
  if (!fits) accessor.refuse("exceeds its part of the buffer");
  return {bytes.substr(offset), stride};
}

const GltfNumbers& GltfBuffers::accessor(std::size_t index) {
  const auto [place, is_new] = accessors_.try_emplace(index);
  if (!is_new) return place->second;
  const GltfValue value = document_.at("accessors").at(index);
  GltfNumbers numbers;
  const std::size_t type = value.at("componentType").index();
  if (size_of(type) == 0) value.refuse("has an unknown type of components");
  numbers.components = components_of(value.at("type"));
  numbers.count = value.at("count").index();
  if (numbers.count > most_items) value.refuse("has more than 2^32 - 2 elements");
  if (type != float32) {
    const bool is_normalized = value.is_true("normalized") && type != unsigned_int;
    numbers.kind = !is_normalized          ? GltfNumbers::Kind::integers
                   : type == unsigned_byte ? GltfNumbers::Kind::bytes
                                           : GltfNumbers::Kind::scaled;
    if (is_normalized) numbers.divisor = divisor_of(type);
  }
  read_plain(value, numbers, type);
  if (value.has("sparse")) read_sparse(value, numbers, type);
  if (numbers.divisor != 1)
    for (double& x : numbers.values) x = std::max(x, -numbers.divisor);  // -128 stands for -1 as well
  return place->second = std::move(numbers);
}

void GltfBuffers::read_plain(const GltfValue& accessor, GltfNumbers& numbers, std::size_t type) {
  const std::size_t components = numbers.components;
  if (!accessor.has("bufferView")) {
    use(numbers.count * components);
    numbers.values.resize(numbers.count * components);
    return;
  }
  const Layout where = layout(accessor, accessor.at("bufferView").index(), accessor.index_or("byteOffset", 0),
                              numbers.count, type, components);
  use(numbers.count * components);
  resize_fresh(numbers.values, numbers.count * components);
  if (!decode(where.bytes.data(), where.stride, components, type, numbers.values)) refuse_not_finite(accessor);
}

void GltfBuffers::read_sparse(const GltfValue& accessor, GltfNumbers& numbers, std::size_t type) {
  const GltfValue sparse = accessor.at("sparse"), at = sparse.at("indices"), of = sparse.at("values");
  const std::size_t count = sparse.at("count").index();
  const std::size_t index_type = at.at("componentType").index();
  if (index_type != unsigned_byte && index_type != unsigned_short && index_type != unsigned_int)
    at.refuse("has an unknown type of components");
  const Layout indices = layout(at, at.at("bufferView").index(), at.index_or("byteOffset", 0), count, index_type, 1);
  const Layout values =
      layout(of, of.at("bufferView").index(), of.index_or("byteOffset", 0), count, type, numbers.components);
  use(count * numbers.components);
  for (std::size_t i = 0; i < count; ++i) {
    const auto element = static_cast<std::size_t>(number_at(indices.bytes.data() + i * indices.stride, index_type));
    if (element >= numbers.count) at.refuse("has an index out of range");
    for (std::size_t k = 0; k < numbers.components; ++k) {
      const double x = number_at(values.bytes.data() + i * values.stride + k * size_of(type), type);
      if (!std::isfinite(x)) refuse_not_finite(accessor);
      numbers.values[element * numbers.components + k] = x;
    }
  }
}

std::vector<std::uint32_t> GltfBuffers::indices(std::size_t index, std::size_t limit) {
  const GltfValue value = document_.at("accessors").at(index);
  const std::size_t type = value.at("componentType").index(), count = value.at("count").index();
  if (type != unsigned_byte && type != unsigned_short && type != unsigned_int)
    value.refuse("has no type that indices have");
  if (value.has("sparse")) value.refuse("indices that are sparse are not read");
  const Layout where = layout(value, value.at("bufferView").index(), value.index_or("byteOffset", 0), count, type, 1);
  use(count);
  std::vector<std::uint32_t> indices;
  resize_fresh(indices, count);
  std::atomic<bool> are_below = true;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1 << 14), [&](const auto& range) {
    bool all = true;
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const char* const at = where.bytes.data() + i * where.stride;
      indices[i] = type == unsigned_int ? load<std::uint32_t>(at, std::endian::little)
                                        : static_cast<std::uint32_t>(number_at(at, type));
      all = all && indices[i] < limit;
    }
    if (!all) are_below = false;
  });
  if (are_below) return indices;
  const auto wrong = std::find_if(indices.begin(), indices.end(), [&](std::uint32_t v) { return v >= limit; });
  value.refuse("vertex index " + std::to_string(*wrong) + " is out of range, of " + std::to_string(limit));
}

}  // namespace strata::io
