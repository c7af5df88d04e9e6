#include "strata/solid.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "core/csg/arena.h"
#include "core/csg/found_class.h"
#include "core/csg/solid_data.h"
#include "core/mesh/prepare.h"
#include "strata/carry_attributes.h"
#include "strata/measure.h"

namespace strata {

namespace {

std::vector<Source> own_faces(std::size_t count) {
  std::vector<Source> r(count);
  for (std::size_t i = 0; i < count; ++i) r[i] = {0, static_cast<std::uint32_t>(i)};
  return r;
}

Solid::Data data_of(BooleanResult result) {
  Shared<Attributes> attributes;
  if (!result.attributes.empty()) attributes = Shared<Attributes>::make(std::move(result.attributes));
  return {{std::move(result.mesh), std::move(result.exact)},
          std::move(result.sources),
          std::move(result.notes),
          std::move(attributes)};
}

/// The same with exact vertices in the result.
Options exact(Options options) {
  options.exact_vertices = true;
  options.measure = false;
  return options;
}

/// `known`: what preparation makes of the mesh.
Solid::Data accept(Mesh mesh, const Options& options, std::optional<Prepared> known = {});
Solid::Data accept(ExactMesh mesh, const Options& options, std::optional<Prepared> known = {});

/// A mesh of class `automatic`; `operand` refers to it.
template <class AnyMesh>
Solid::Data accept_inspected(AnyMesh& mesh, const Operand& operand, Options options) {
  FoundClass found;
  arena_for(options, operand.mesh.triangles.size()).execute([&] {
    found = find_class({&operand, 1}, Monitor(options.cancel));
  });
  options.input = found.input;
  Solid::Data data = accept(std::move(mesh), options, std::move(found.known.prepared.front()));
  data.notes.insert(data.notes.begin(), found.notes.begin(), found.notes.end());
  return data;
}

Solid::Data accept(Mesh mesh, const Options& options, std::optional<Prepared> known) {
  switch (options.input) {
    case InputClass::automatic: {
      const Operand operand{mesh, {}};
      return accept_inspected(mesh, operand, options);
    }
    case InputClass::solid: {
      Prepared p = known ? *std::move(known) : prepare({MeshView(mesh), {}}, options);
      if (!p.mesh) {
        const std::size_t faces = mesh.triangles.size();
        return {{std::move(mesh), {}}, own_faces(faces), std::move(p.notes)};
      }
      std::vector<Source> sources;
      for (const std::uint32_t f : p.source_face) sources.push_back({0, f});
      return {{std::move(*p.mesh), {}}, std::move(sources), std::move(p.notes)};
    }
    case InputClass::overlapping:
    case InputClass::repair:
    case InputClass::soup: {
      const MeshView view = mesh;
      return data_of(combine(Operation::union_, std::span<const MeshView>(&view, 1), exact(options)));
    }
  }
  return {};
}

Solid::Data accept(ExactMesh mesh, const Options& options, std::optional<Prepared> known) {
  if (mesh.exact.empty()) return accept(std::move(mesh.mesh), options);
  switch (options.input) {
    case InputClass::automatic: {
      const Operand operand{mesh.mesh, mesh.exact};
      return accept_inspected(mesh, operand, options);
    }
    case InputClass::solid: {
      Prepared p = known ? *std::move(known) : prepare(mesh, options);
      if (p.mesh) mesh.mesh = std::move(*p.mesh);
      const std::size_t faces = mesh.mesh.triangles.size();
      return {std::move(mesh), own_faces(faces), std::move(p.notes)};
    }
    case InputClass::overlapping:
    case InputClass::repair:
    case InputClass::soup: {
      const Operand operand{mesh.mesh, mesh.exact};
      return data_of(combine(Operation::union_, std::span<const Operand>(&operand, 1), exact(options)));
    }
  }
  return {};
}

}  // namespace

Solid::Solid() : data_(Shared<Data>::make()) {}

Solid::Solid(Mesh mesh, InputClass input) : Solid(std::move(mesh), Options{.input = input}) {}
Solid::Solid(Mesh mesh, const Options& options) : data_(Shared<Data>::make(accept(std::move(mesh), options))) {}

Solid::Solid(ExactMesh mesh, InputClass input) : Solid(std::move(mesh), Options{.input = input}) {}
Solid::Solid(ExactMesh mesh, const Options& options) : data_(Shared<Data>::make(accept(std::move(mesh), options))) {}

Solid::Solid(Shared<Data> data) : data_(std::move(data)) {}

Solid Solid::trusted(ExactMesh mesh) {
  const std::size_t faces = mesh.mesh.triangles.size();
  return trusted(std::move(mesh), own_faces(faces));
}
Solid Solid::trusted(ExactMesh mesh, std::vector<Source> sources) {
  return Solid(Shared<Data>::make(Data{std::move(mesh), std::move(sources), {}}));
}

const Mesh& Solid::mesh() const { return data_->boundary.mesh; }
const ExactMesh& Solid::exact_mesh() const { return data_->boundary; }
const std::vector<Source>& Solid::sources() const { return data_->sources; }
const std::vector<Defect>& Solid::notes() const { return data_->notes; }
const Attributes& Solid::attributes() const {
  static const Attributes none;
  return data_->attributes ? *data_->attributes : none;
}
Solid Solid::with_attributes(Attributes attributes) const {
  check_attributes(attributes, mesh().vertices.size(), mesh().triangles.size());
  Data data = *data_;
  data.attributes = attributes.empty() ? Shared<Attributes>() : Shared<Attributes>::make(std::move(attributes));
  return Solid(Shared<Data>::make(std::move(data)));
}
Rational Solid::volume() const { return strata::volume(data_->boundary); }
double Solid::area() const { return strata::area(data_->boundary); }
bool Solid::is_empty() const { return data_->boundary.mesh.triangles.empty(); }
CanonicalForm Solid::canonical(const Monitor& monitor) const { return canonical_form(data_->boundary, monitor); }

BoundingBox Solid::bounding_box() const {
  BoundingBox box;
  box.lower.fill(std::numeric_limits<double>::infinity());
  box.upper.fill(-std::numeric_limits<double>::infinity());
  for (const Triangle& t : mesh().triangles)
    for (const std::uint32_t v : t)
      for (std::size_t i = 0; i < 3; ++i) {
        box.lower[i] = std::min(box.lower[i], mesh().vertices[v][i]);
        box.upper[i] = std::max(box.upper[i], mesh().vertices[v][i]);
      }
  return box;
}

bool operator==(const Solid& a, const Solid& b) { return a.data_ == b.data_ || a.canonical() == b.canonical(); }

namespace {

Options of_solids(Options options) {
  options.input = InputClass::solid;
  return exact(std::move(options));
}

}  // namespace

Solid combine_solids(Operation operation, std::span<const Solid> operands, const Options& options) {
  std::vector<Operand> views;
  for (const Solid& s : operands)
    views.push_back({MeshView(s.mesh()), s.exact_mesh().exact, true, s.data_->attributes.get()});
  return Solid(
      Shared<Solid::Data>::make(data_of(combine(operation, std::span<const Operand>(views), of_solids(options)))));
}

Solid combine_solids(const Formula& formula, std::span<const Operand> operands, const Options& options) {
  return Solid(Shared<Solid::Data>::make(data_of(combine(formula, operands, of_solids(options)))));
}

namespace {

using Listed = std::initializer_list<Solid>;

std::span<const Solid> span_of(Listed operands) { return {operands.begin(), operands.size()}; }

}  // namespace

Solid combine_solids(Operation operation, Listed operands, const Options& options) {
  return combine_solids(operation, span_of(operands), options);
}

Solid union_(std::span<const Solid> operands) { return combine_solids(Operation::union_, operands); }
Solid intersection(std::span<const Solid> operands) { return combine_solids(Operation::intersection, operands); }
Solid difference(std::span<const Solid> operands) { return combine_solids(Operation::difference, operands); }
Solid symmetric_difference(std::span<const Solid> operands) {
  return combine_solids(Operation::symmetric_difference, operands);
}
Solid union_(Listed operands) { return union_(span_of(operands)); }
Solid intersection(Listed operands) { return intersection(span_of(operands)); }
Solid difference(Listed operands) { return difference(span_of(operands)); }
Solid symmetric_difference(Listed operands) { return symmetric_difference(span_of(operands)); }

Solid operator|(const Solid& a, const Solid& b) { return union_({a, b}); }
Solid operator&(const Solid& a, const Solid& b) { return intersection({a, b}); }
Solid operator-(const Solid& a, const Solid& b) { return difference({a, b}); }
Solid operator^(const Solid& a, const Solid& b) { return symmetric_difference({a, b}); }

}  // namespace strata
