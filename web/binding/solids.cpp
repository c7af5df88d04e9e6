// Solids: made of meshes and of others, measured, compared.
#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "call.h"
#include "handle.h"
#include "strata/check.h"
#include "strata/expression.h"
#include "strata/measure.h"
#include "strata/transform.h"

using namespace strata;
using namespace strata::web;

namespace {

RationalPoint point(double x, double y, double z) { return {Rational(x), Rational(y), Rational(z)}; }

/// Lines of a text.
std::vector<std::string> lines_of(const char* text, std::size_t size) {
  std::vector<std::string> lines(1);
  for (const char c : std::string_view(text, size))
    if (c == '\n')
      lines.emplace_back();
    else
      lines.back() += c;
  return lines;
}

}  // namespace

STRATA_WEB(from_mesh)
unsigned strata_from_mesh(const double* coordinates, std::size_t vertices, const std::uint32_t* corners,
                          std::size_t triangles, unsigned input) {
  return guarded([&] {
    Options options = watched();
    options.input = all_input_classes.at(input);
    Solid solid(mesh_of(coordinates, vertices, corners, triangles), options);
    answer().bytes = defects_text(solid.notes());
    return keep(std::move(solid));
  });
}

STRATA_WEB(delete) unsigned strata_delete(Handle handle) {
  return guarded([&] {
    delete reinterpret_cast<const Solid*>(handle);
    return 1U;
  });
}

STRATA_WEB(is_empty) unsigned strata_is_empty(Handle handle) {
  return guarded([&] { return solid_of(handle).is_empty() ? 1U : 0U; });
}

STRATA_WEB(combine) unsigned strata_combine(unsigned operation, const Handle* handles, std::size_t count) {
  return guarded(
      [&] { return keep(combine_solids(all_operations.at(operation), solids_of(handles, count), watched())); });
}

/// Names are separated by line feeds, one per solid.
STRATA_WEB(evaluate)
unsigned strata_evaluate(const char* text, std::size_t size, const char* names, std::size_t names_size,
                         const Handle* handles, std::size_t count) {
  return guarded([&] {
    const std::vector<std::string> known = lines_of(names, names_size);
    const auto solid_named = [&](const std::string& name) {
      for (std::size_t i = 0; i < count; ++i)
        if (known.at(i) == name) return solid_of(handles[i]);
      throw std::out_of_range(name);
    };
    return keep(parse_expression({text, size}, solid_named).evaluate(watched()));
  });
}

/// The answer has coordinates, corners, and per triangle the operand and the face of its source.
STRATA_WEB(mesh) unsigned strata_mesh(Handle handle) {
  return guarded([&] {
    const Solid& solid = solid_of(handle);
    const Mesh& mesh = solid.mesh();
    auto& [bytes, reals, ints, error] = answer();
    reals.reserve(3 * mesh.vertices.size());
    for (const Vertex& v : mesh.vertices) reals.insert(reals.end(), v.begin(), v.end());
    ints.reserve(5 * mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) ints.insert(ints.end(), t.begin(), t.end());
    for (const Source& s : solid.sources()) ints.push_back(s.operand);
    for (const Source& s : solid.sources()) ints.push_back(s.face);
    return static_cast<unsigned>(mesh.triangles.size());
  });
}

/// The sides of maximal facets, each once: the answer has coordinates of their ends and two numbers of these for each.
STRATA_WEB(edges) unsigned strata_edges(Handle handle) {
  return guarded([&] {
    const CanonicalForm form = solid_of(handle).canonical();
    for (const RationalPoint& p : form.vertices)
      for (const Rational& x : p) answer().reals.push_back(to_nearest_double(x));
    std::set<std::pair<std::uint32_t, std::uint32_t>> sides;  // that of the neighbour runs the other way
    for (const CanonicalFacets& facets : form.planes)
      for (const std::vector<std::uint32_t>& loop : facets.loops)
        for (std::size_t i = 0; i < loop.size(); ++i) sides.insert(std::minmax(loop[i], loop[(i + 1) % loop.size()]));
    for (const auto& [a, b] : sides) answer().ints.insert(answer().ints.end(), {a, b});
    return static_cast<unsigned>(sides.size());
  });
}

STRATA_WEB(exact_volume) unsigned strata_exact_volume(Handle handle) {
  return guarded([&] {
    const Rational volume = solid_of(handle).volume();
    answer().bytes = numerator(volume).str() + '/' + denominator(volume).str();
    return 1U;
  });
}

/// Volume, area, and the corners of the bounding box.
STRATA_WEB(measures) unsigned strata_measures(Handle handle) {
  return guarded([&] {
    const Solid& solid = solid_of(handle);
    const BoundingBox box = solid.bounding_box();
    answer().reals = {nearest_volume(solid.exact_mesh()), solid.area()};
    for (const Vertex& corner : {box.lower, box.upper})
      answer().reals.insert(answer().reals.end(), corner.begin(), corner.end());
    return 1U;
  });
}

STRATA_WEB(equal) unsigned strata_equal(Handle a, Handle b) {
  return guarded([&] { return solid_of(a) == solid_of(b) ? 1U : 0U; });
}

/// The hash of the canonical form, in hexadecimal digits.
STRATA_WEB(canonical_hash) unsigned strata_canonical_hash(Handle handle) {
  return guarded([&] {
    constexpr const char* digits = "0123456789abcdef";
    const std::uint64_t hash = solid_of(handle).canonical().hash();
    for (int shift = 60; shift >= 0; shift -= 4) answer().bytes += digits[(hash >> shift) & 15];
    return 1U;
  });
}

STRATA_WEB(translated) unsigned strata_translated(Handle handle, double x, double y, double z) {
  return guarded([&] { return keep(solid_of(handle).translated(point(x, y, z))); });
}

STRATA_WEB(scaled) unsigned strata_scaled(Handle handle, double x, double y, double z) {
  return guarded([&] { return keep(solid_of(handle).scaled(point(x, y, z))); });
}

/// By the 16 entries of a matrix, row after row.
STRATA_WEB(transformed) unsigned strata_transformed(Handle handle, const double* rows) {
  return guarded([&] {
    return keep(solid_of(handle).transformed(Transform::from_matrix(std::span<const double, 16>(rows, 16))));
  });
}

STRATA_WEB(components) unsigned strata_components(Handle handle) {
  return guarded([&] {
    for (Solid& part : solid_of(handle).components()) answer().ints.push_back(keep(std::move(part)));
    return 1U;
  });
}

/// All defects of a mesh that is to bound a solid.
STRATA_WEB(check)
unsigned strata_check(const double* coordinates, std::size_t vertices, const std::uint32_t* corners,
                      std::size_t triangles) {
  return guarded([&] {
    answer().bytes = defects_text(check(mesh_of(coordinates, vertices, corners, triangles)));
    return 1U;
  });
}
