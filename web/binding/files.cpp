// Files and models as arrays of bytes.
#include "call.h"
#include "handle.h"
#include "strata/carry_attributes.h"
#include "strata/io.h"
#include "strata/openscad.h"

using namespace strata;
using namespace strata::web;

namespace {

Format format_of_word(const char* word, std::size_t size) {
  const std::optional<Format> format = format_named({word, size});
  if (!format) throw std::invalid_argument("unknown format '" + std::string(word, size) + "'");
  return *format;
}

MeshFile read_file(const char* bytes, std::size_t size, const char* word, std::size_t word_size) {
  return read_mesh(std::string_view(bytes, size), format_of_word(word, word_size), "file");
}

/// Notes as lines of the answer.
void note(const std::vector<std::string>& notes) {
  for (const std::string& one : notes) answer().bytes += one + '\n';
}

}  // namespace

STRATA_WEB(read)
unsigned strata_read(const char* bytes, std::size_t size, const char* word, std::size_t word_size, unsigned input) {
  return guarded([&] {
    MeshFile file = read_file(bytes, size, word, word_size);
    Options options = watched();
    options.input = all_input_classes.at(input);
    const unsigned handle = keep(Solid(ExactMesh{std::move(file.mesh), std::move(file.exact)}, options));
    note(file.notes);
    return handle;
  });
}

/// The mesh of a file, which need not bound a solid: coordinates and corners.
STRATA_WEB(read_mesh)
unsigned strata_read_mesh(const char* bytes, std::size_t size, const char* word, std::size_t word_size) {
  return guarded([&] {
    const MeshFile file = read_file(bytes, size, word, word_size);
    for (const Vertex& v : file.mesh.vertices) answer().reals.insert(answer().reals.end(), v.begin(), v.end());
    for (const Triangle& t : file.mesh.triangles) answer().ints.insert(answer().ints.end(), t.begin(), t.end());
    note(file.notes);
    return 1U;
  });
}

STRATA_WEB(write) unsigned strata_write(Handle handle, const char* word, std::size_t word_size) {
  return guarded([&] {
    answer().bytes = to_string(solid_of(handle).exact_mesh(), format_of_word(word, word_size));
    return 1U;
  });
}

STRATA_WEB(parse_csg) unsigned strata_parse_csg(const char* text, std::size_t size) {
  return guarded([&] {
    const CsgModel model = read_csg({text, size}, "model");
    const unsigned handle = keep(model.expression.evaluate(watched()));
    note(model.notes);
    return handle;
  });
}
