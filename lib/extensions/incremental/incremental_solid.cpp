#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/containers/for_each_index.h"
#include "core/csg/arena.h"
#include "core/kernel/rational_point.h"
#include "extensions/incremental/face_tree.h"
#include "extensions/incremental/rounds.h"
#include "extensions/incremental/step.h"
#include "extensions/incremental/tool_groups.h"
#include "strata/carry_attributes.h"
#include "strata/incremental.h"

namespace strata {

struct IncrementalSolid::Data {
  FaceTree faces;
  std::uint64_t given = 0;  ///< solids so far
};

namespace {

/// Of a vertex that is not three doubles.
RationalPoint position(const IncrementalVertex& corner) {
  return corner.rational ? *corner.rational : rational(corner.meet.exact());
}

/// The faces that the triangles of a solid are parts of.
class Origins {
 public:
  /// Of the next triangle.
  void add(const FaceOrigin& origin) {
    origins_.push_back(&origin);
    if (origin.solid != nullptr)
      solids_.emplace(origin.solid->number, origin.solid.get());
    else
      (origin.is_turned ? has_turned_ : has_plain_) = true;
  }

  /// The attributes of a solid with these triangles. Those of solids without attributes are parts of themselves.
  [[nodiscard]] Attributes carried_to(const Solid& solid, const Options& options) const {
    if (solids_.empty() && options.cut_material == nullptr) return {};
    std::vector<AttributedMesh> operands;
    std::unordered_map<const PaintedSolid*, std::uint32_t> numbers;
    for (const auto& [number, painted] : solids_) {
      numbers.emplace(painted, static_cast<std::uint32_t>(operands.size()));
      operands.push_back({painted->solid.exact_mesh(), &painted->solid.attributes()});
    }
    const auto plain = static_cast<std::uint32_t>(operands.size());
    if (has_plain_) operands.push_back({solid.exact_mesh(), nullptr});
    const auto turned = static_cast<std::uint32_t>(operands.size());
    std::vector<Triangle> triangles_turned;
    if (has_turned_) {
      triangles_turned = solid.mesh().triangles;
      for (Triangle& t : triangles_turned) std::swap(t[0], t[1]);
      operands.push_back({{{solid.mesh().vertices, triangles_turned}, solid.exact_mesh().exact}, nullptr});
    }
    std::vector<Source> sources;
    for (std::uint32_t t = 0; t < origins_.size(); ++t) {
      const FaceOrigin& origin = *origins_[t];
      if (origin.solid != nullptr)
        sources.push_back({numbers.at(origin.solid.get()), origin.face});
      else
        sources.push_back({origin.is_turned ? turned : plain, t});
    }
    return carry_attributes(operands, solid.exact_mesh(), sources, options);
  }

 private:
  std::vector<const FaceOrigin*> origins_;
  std::map<std::uint64_t, const PaintedSolid*> solids_;  ///< by number
  bool has_plain_ = false, has_turned_ = false;          ///< triangles of solids without attributes
};

}  // namespace

IncrementalSolid::IncrementalSolid() : data_(Shared<Data>::make()) {}

IncrementalSolid::IncrementalSolid(const Solid& solid)
    : data_(Shared<Data>::make(Data{FaceTree(faces_of({solid, painted(solid, 0)})), 1})) {}

IncrementalSolid IncrementalSolid::with(Operation operation, const Solid& tool, const Options& options) const {
  return with(operation, std::span(&tool, 1), options);
}

IncrementalSolid IncrementalSolid::with(Operation operation, std::span<const Solid> tools,
                                        const Options& options) const {
  const auto is_empty_tool = [](const Solid& tool) { return tool.is_empty(); };
  if (operation == Operation::intersection && std::any_of(tools.begin(), tools.end(), is_empty_tool)) return {};
  IncrementalSolid result;
  result.data_ = Shared<Data>::make(Data{take_steps(data_->faces, operation, group_tools(tools, data_->given), options),
                                         data_->given + tools.size()});
  return result;
}

Solid IncrementalSolid::solid(const Options& options) const {
  ExactMesh mesh;
  Origins origins;
  std::unordered_map<const IncrementalVertex*, std::uint32_t> numbers;
  std::vector<const IncrementalVertex*> rational;  ///< vertices that are not three doubles
  mesh.mesh.triangles.reserve(triangle_count());
  numbers.reserve(triangle_count() / 2 + 2);
  data_->faces.for_each([&](const WorkFace& face) {
    Triangle t{};
    for (std::size_t i = 0; i < 3; ++i) {
      const IncrementalVertex& corner = *face.corners()[i];
      const auto [at, is_new] = numbers.try_emplace(&corner, static_cast<std::uint32_t>(mesh.mesh.vertices.size()));
      t[i] = at->second;
      if (!is_new) continue;
      mesh.mesh.vertices.push_back(corner.at);
      if (corner.has_doubles()) continue;
      mesh.exact.push_back({at->second, {}});
      rational.push_back(&corner);
    }
    mesh.mesh.triangles.push_back(t);
    origins.add(face.origin());
  });
  arena_for(options, rational.size()).execute([&] {
    for_each_index(rational.size(), 64, [&](std::size_t i) { mesh.exact[i].position = position(*rational[i]); });
  });
  const Solid solid = Solid::trusted(std::move(mesh));
  Attributes attributes = origins.carried_to(solid, options);
  return attributes.empty() ? solid : solid.with_attributes(std::move(attributes));
}

bool IncrementalSolid::is_empty() const { return data_->faces.size() == 0; }
std::size_t IncrementalSolid::triangle_count() const { return data_->faces.size(); }
double IncrementalSolid::volume() const { return data_->faces.determinant().value / 6; }

}  // namespace strata
