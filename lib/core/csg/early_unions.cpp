#include "core/csg/early_unions.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/csg/coincident_facets.h"
#include "core/csg/overlapping_operands.h"

namespace strata {

EarlyUnions::EarlyUnions(const Rule& rule, std::span<const Operand> given, const Options& options,
                         const Evaluate& evaluate)
    : given_(given), operands_(given.begin(), given.end()), group_of_(given.size(), none) {
  constexpr std::size_t few = 4;
  if (given.size() < few || options.input != InputClass::solid) return;
  for (const auto& united : rule.unions()) {
    const std::vector<OperandBox> boxes = boxes_of(given, united);
    auto groups = groups_with_coincident_facets(given, boxes, Monitor(options.cancel));
    if (groups.empty()) groups = groups_of_overlapping_operands(boxes);
    std::move(groups.begin(), groups.end(), std::back_inserter(groups_));
  }
  if (std::any_of(given.begin(), given.end(), [](const Operand& o) { return o.attributes != nullptr; }))
    std::erase_if(groups_, [](const auto& g) { return g.back() - g.front() + 1 != g.size(); });
  if (!groups_.empty()) unite(options, evaluate);
}

void EarlyUnions::restore(BooleanResult& result) const {
  if (groups_.empty()) return;
  for (Source& s : result.sources)
    if (const std::size_t g = group_of_[s.operand]; g != none) {
      const Source of_member = unions_[g].sources[s.face];
      s = {groups_[g][of_member.operand], of_member.face};
    }
  for (const BooleanResult& u : unions_) result.notes.insert(result.notes.end(), u.notes.begin(), u.notes.end());
}

/// The union replaces its first member. The others become empty, which adds nothing to it. If an operand does not
/// satisfy its input class, all operands are unchanged, and the evaluation of all of them finds which one it is.
void EarlyUnions::unite(const Options& options, const Evaluate& evaluate) {
  Options inner;
  inner.input = InputClass::solid;
  inner.cancel = options.cancel;
  inner.exact_vertices = true;
  unions_.resize(groups_.size());
  try {
    tbb::parallel_for(std::size_t{0}, groups_.size(),
                      [&](std::size_t g) { unions_[g] = united(groups_[g], inner, evaluate); });
  } catch (const InputError&) {
    groups_.clear();
    unions_.clear();
    return;
  }
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    for (const std::uint32_t o : groups_[g]) operands_[o] = {{}, {}, true};
    operands_[groups_[g].front()] = {MeshView(unions_[g].mesh), unions_[g].exact, true};
    group_of_[groups_[g].front()] = g;
  }
}

BooleanResult EarlyUnions::united(const std::vector<std::uint32_t>& group, const Options& options,
                                  const Evaluate& evaluate) const {
  std::vector<Operand> members;
  for (const std::uint32_t o : group) members.push_back(given_[o]);
  return evaluate(Rule(Operation::union_, static_cast<std::uint32_t>(group.size())), members, options);
}

}  // namespace strata
