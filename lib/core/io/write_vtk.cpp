#include <algorithm>
#include <bit>
#include <string>
#include <type_traits>
#include <variant>

#include "core/io/binary.h"
#include "core/io/losses.h"
#include "core/io/text_lines.h"
#include "core/io/writers.h"

namespace strata::io {
namespace {

/// Names of arrays have no blanks.
std::string word_of(std::string name) {
  for (char& c : name)
    if (static_cast<unsigned char>(c) <= ' ') c = '_';
  return name.empty() ? "unnamed" : name;
}

template <class T>
const char* type_name() {
  if (std::is_same_v<T, float>) return "float";
  if (std::is_same_v<T, double>) return "double";
  return std::is_same_v<T, std::uint8_t> ? "unsigned_char" : "int";
}

/// Numbers, `per_line` on a line of a text, or in big-endian order.
template <class T>
void write_numbers(Sink& sink, const T* numbers, std::size_t count, std::size_t per_line, bool ascii) {
  if (ascii)
    write_blocks(sink, count, longest_number + 1, [&](std::size_t i, char* at) {
      at = std::to_chars(at, at + longest_number, numbers[i]).ptr;
      *at++ = (i + 1) % per_line == 0 ? '\n' : ' ';
      return at;
    });
  else
    write_blocks(sink, count, sizeof(T),
                 [&](std::size_t i, char* at) { return store(at, numbers[i], std::endian::big); });
  if (!ascii) sink.write("\n");
}

void write_arrays(const Target& target, Element element, std::size_t count, const char* title, bool ascii) {
  bool is_first = true;
  for (const Channel& c : target.attributes.channels) {
    if (c.element != element) continue;
    if (is_first) target.sink.write(std::string(title) + " " + std::to_string(count) + "\n");
    is_first = false;
    std::visit(
        [&](const auto& values) {
          using T = typename std::decay_t<decltype(values)>::value_type;
          target.sink.write("SCALARS " + word_of(c.name) + " " + type_name<T>() + " " + std::to_string(c.components) +
                            "\nLOOKUP_TABLE default\n");
          write_numbers(target.sink, values.data(), values.size(), c.components, ascii);
        },
        c.values);
  }
}

}  // namespace

Notes write_vtk(const Target& target, bool ascii) {
  const MeshView mesh = target.mesh;
  Sink& sink = target.sink;
  const std::string vertices = std::to_string(mesh.vertices.size());
  sink.write("# vtk DataFile Version 3.0\nstrata\n" + std::string(ascii ? "ASCII" : "BINARY") +
             "\nDATASET POLYDATA\nPOINTS " + vertices + " double\n");
  write_numbers(sink, mesh.vertices.empty() ? nullptr : mesh.vertices[0].data(), 3 * mesh.vertices.size(), 3, ascii);
  sink.write("POLYGONS " + std::to_string(mesh.triangles.size()) + " " + std::to_string(4 * mesh.triangles.size()) +
             "\n");
  if (ascii)
    write_blocks(sink, mesh.triangles.size(), longest_line("3 "),
                 [&](std::size_t i, char* at) { return append_line(at, "3 ", mesh.triangles[i]); });
  else
    write_blocks(sink, mesh.triangles.size(), 16, [&](std::size_t i, char* at) {
      at = store(at, std::uint32_t{3}, std::endian::big);
      for (const std::uint32_t v : mesh.triangles[i]) at = store(at, v, std::endian::big);
      return at;
    });
  if (!ascii) sink.write("\n");
  write_arrays(target, Element::face, mesh.triangles.size(), "CELL_DATA", ascii);
  write_arrays(target, Element::vertex, mesh.vertices.size(), "POINT_DATA", ascii);
  Notes notes;
  note_losses(notes, target.attributes, target.unit, "VTK", {},
              [](const Channel& c) { return c.element != Element::corner; });
  return notes;
}

}  // namespace strata::io
