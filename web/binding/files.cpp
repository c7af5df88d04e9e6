// Files and models as arrays of bytes.
#include "call.h"
#include "handle.h"
#include "strata/carry_attributes.h"
#include "strata/io.h"
#include "strata/openscad.h"
#include "strata/rounding.h"

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

/// What a file of a format holds in place of an exact solid: one that is a solid in the numbers of the format.
struct Written {
  ExactMesh mesh;
  Attributes attributes;
};

Written rounded_for(Format format, const Solid& solid) {
  const Written exact{solid.exact_mesh(), solid.attributes()};
  if (format == Format::xoff) return exact;
  CoordinateGrid grid;
  if (holds_floats(format)) grid.format = CoordinateGrid::Format::float32;
  RoundedMesh rounded = round_to_solid(exact.mesh, grid, watched());
  if (!holds_floats(format) && !rounded.report.is_rearranged) return exact;
  Attributes attributes;
  if (!exact.attributes.empty())
    attributes = carry_attributes({exact.mesh, &exact.attributes}, rounded, grid, watched());
  return {{std::move(rounded.mesh), {}}, std::move(attributes)};
}

/// A solid with what the file says beside its shape.
Solid with_attributes_of(const ExactMesh& mesh, const Attributes& attributes, const Solid& solid) {
  if (attributes.empty()) return solid;
  const AttributedMesh given{mesh, &attributes};
  return solid.with_attributes(carry_attributes({&given, 1}, solid.exact_mesh(), solid.sources(), watched()));
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
    const ExactMesh mesh{std::move(file.mesh), std::move(file.exact)};
    const unsigned handle = keep(with_attributes_of(mesh, file.attributes, Solid(mesh, options)));
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
    WriteOptions options;
    options.format = format_of_word(word, word_size);
    const Written written = rounded_for(*options.format, solid_of(handle));
    options.attributes = &written.attributes;
    answer().bytes = to_string(written.mesh, options);
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
