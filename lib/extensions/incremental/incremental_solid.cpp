#include <algorithm>
#include <unordered_map>
#include <utility>

#include "extensions/incremental/face_tree.h"
#include "extensions/incremental/rounds.h"
#include "extensions/incremental/step.h"
#include "extensions/incremental/tool_groups.h"
#include "strata/incremental.h"

namespace strata {

struct IncrementalSolid::Data {
  FaceTree faces;
};

namespace {

RationalPoint position(const IncrementalVertex& corner) {
  if (corner.rational) return *corner.rational;
  const HPoint<Integer> p = corner.meet.exact();
  return {Rational(p.x, p.w), Rational(p.y, p.w), Rational(p.z, p.w)};
}

}  // namespace

IncrementalSolid::IncrementalSolid() : data_(Shared<Data>::make()) {}

IncrementalSolid::IncrementalSolid(const Solid& solid) : data_(Shared<Data>::make(Data{FaceTree(faces_of(solid))})) {}

IncrementalSolid IncrementalSolid::with(Operation operation, const Solid& tool, const Options& options) const {
  return with(operation, std::span(&tool, 1), options);
}

IncrementalSolid IncrementalSolid::with(Operation operation, std::span<const Solid> tools,
                                        const Options& options) const {
  const auto is_empty_tool = [](const Solid& tool) { return tool.is_empty(); };
  if (operation == Operation::intersection && std::any_of(tools.begin(), tools.end(), is_empty_tool)) return {};
  IncrementalSolid result;
  result.data_ = Shared<Data>::make(Data{take_steps(data_->faces, operation, group_tools(tools), options)});
  return result;
}

Solid IncrementalSolid::solid() const {
  ExactMesh mesh;
  std::unordered_map<const IncrementalVertex*, std::uint32_t> numbers;
  data_->faces.for_each([&](const WorkFace& face) {
    Triangle t{};
    for (std::size_t i = 0; i < 3; ++i) {
      const IncrementalVertex& corner = *face.corners()[i];
      const auto [at, is_new] = numbers.try_emplace(&corner, static_cast<std::uint32_t>(mesh.mesh.vertices.size()));
      t[i] = at->second;
      if (!is_new) continue;
      mesh.mesh.vertices.push_back(corner.at);
      if (!corner.has_doubles()) mesh.exact.push_back({at->second, position(corner)});
    }
    mesh.mesh.triangles.push_back(t);
  });
  return Solid::trusted(std::move(mesh));
}

bool IncrementalSolid::is_empty() const { return data_->faces.size() == 0; }
std::size_t IncrementalSolid::triangle_count() const { return data_->faces.size(); }
double IncrementalSolid::volume() const { return data_->faces.determinant().value / 6; }

}  // namespace strata
