#include "strata/expression.h"

#include <algorithm>
#include <deque>
#include <optional>
#include <unordered_map>

#include "core/csg/common_frame.h"
#include "core/csg/decision_diagram.h"
#include "core/csg/expression_node.h"
#include "strata/carry_attributes.h"

namespace strata {

using Kind = Expression::Node::Kind;
using Pointer = Expression::Node::Pointer;

namespace {

std::vector<Pointer> nodes_of(std::span<const Expression> terms, const auto& node_of) {
  std::vector<Pointer> nodes;
  nodes.reserve(terms.size());
  for (const Expression& t : terms) nodes.push_back(node_of(t));
  return nodes;
}

}  // namespace

Expression::Expression(Solid solid, std::string name) : node_(Pointer::make(std::move(solid), std::move(name))) {}

Expression Expression::any(std::span<const Expression> terms) {
  return Expression(Node::join(Kind::any, nodes_of(terms, [](const Expression& e) { return e.node_; })));
}

Expression Expression::all(std::span<const Expression> terms) {
  if (terms.empty()) throw std::invalid_argument("the intersection of nothing is all of space");
  return Expression(Node::join(Kind::all, nodes_of(terms, [](const Expression& e) { return e.node_; })));
}

Expression Expression::odd(std::span<const Expression> terms) {
  return Expression(Node::join(Kind::odd, nodes_of(terms, [](const Expression& e) { return e.node_; })));
}

Expression operator|(const Expression& a, const Expression& b) {
  return Expression(Expression::Node::join(Kind::any, {a.node_, b.node_}));
}
Expression operator&(const Expression& a, const Expression& b) {
  return Expression(Expression::Node::join(Kind::all, {a.node_, b.node_}));
}
Expression operator-(const Expression& a, const Expression& b) {
  return Expression(Expression::Node::join(Kind::all, {a.node_, Expression::Node::complement_of(b.node_)}));
}
Expression operator^(const Expression& a, const Expression& b) {
  return Expression(Expression::Node::join(Kind::odd, {a.node_, b.node_}));
}
Expression operator~(const Expression& a) { return Expression(Expression::Node::complement_of(a.node_)); }

Expression Expression::transformed(const Transform& map, Placement placement) const {
  return Expression(Pointer::make(node_, map, placement));
}

Expression Expression::with_solids(FunctionRef<Solid(const Solid&)> replace) const {
  std::unordered_map<const ExactMesh*, Solid> solids;
  std::unordered_map<const Node*, Pointer> made;
  const auto make = [&](const Node& node) {
    if (node.kind == Kind::solid) {
      const auto [at, is_new] = solids.try_emplace(&node.solid.exact_mesh());
      if (is_new) at->second = replace(node.solid);
      return Pointer::make(at->second, node.name);
    }
    std::vector<Pointer> terms;
    for (const Pointer& term : node.terms) terms.push_back(made.at(&*term));
    return node.kind == Kind::moved ? Pointer::make(std::move(terms.front()), node.map, node.placement)
                                    : Node::join(node.kind, std::move(terms));
  };
  std::vector<const Node*> open{&*node_};
  while (!open.empty()) {
    const Node& node = *open.back();
    const std::size_t before = open.size();
    if (!made.contains(&node))
      for (const Pointer& term : node.terms)
        if (!made.contains(&*term)) open.push_back(&*term);
    if (open.size() != before) continue;
    open.pop_back();
    if (!made.contains(&node)) made.emplace(&node, make(node));
  }
  return Expression(made.at(&*node_));
}

std::size_t Expression::size() const { return node_->size; }

namespace {

Formula::Join join_of(Kind kind) {
  return kind == Kind::any ? Formula::Join::any : kind == Kind::all ? Formula::Join::all : Formula::Join::odd;
}

/// The operands on which the formula depends; all of them, where there are too many for a decision diagram.
std::vector<bool> find_what_matters(const Expression::Node& root, const NumberedSolids& numbering) {
  constexpr std::size_t many = 256, large = 4096;
  const std::size_t count = numbering.occurrences().size();
  if (count > many || root.size > large) return std::vector<bool>(count, true);
  DecisionDiagram diagram;
  const auto whole = fold<DecisionDiagram::Function>(
      root, [&](const Occurrence& o) { return diagram.variable(numbering.number_of(o)); },
      [&](DecisionDiagram::Function f) { return diagram.negate(f); },
      [&](Kind kind, const std::vector<DecisionDiagram::Function>& terms) {
        return diagram.join(join_of(kind), terms);
      });
  if (diagram.is_too_large()) return std::vector<bool>(count, true);
  return diagram.support(whole, count);
}

/// The Boolean of some solids with their maps, in this order, by their formula.
Solid evaluate_placed(const Formula& formula, std::span<const Occurrence> solids, const Options& options) {
  std::vector<ExactMesh> images;
  images.reserve(solids.size());
  std::deque<Attributes> moved;
  std::vector<Operand> operands;
  for (const Occurrence& o : solids) {
    const ExactMesh& mesh = o.leaf->solid.exact_mesh();
    const bool is_moved = !o.map.is_identity();
    if (is_moved) images.push_back(transform(mesh, o.map, o.placement, Monitor(options.cancel)));
    const ExactMesh& placed = is_moved ? images.back() : mesh;
    const Attributes* attributes = &o.leaf->solid.attributes();
    if (is_moved && !attributes->empty()) attributes = &moved.emplace_back(transform(*attributes, o.map));
    operands.push_back({MeshView(placed.mesh), placed.exact, true, attributes->empty() ? nullptr : attributes});
  }
  return combine_solids(formula, operands, options);
}

/// Where all solids can be combined first, and the result be moved. Not if there are directions, which are rounded
/// whenever they are moved, or vertices that are rounded where they are.
std::optional<Transform> frame_of(std::span<const Occurrence> solids) {
  std::vector<PlacedVertices> placed;
  for (const Occurrence& o : solids) {
    const std::vector<Channel>& channels = o.leaf->solid.attributes().channels;
    if (o.placement != Placement::exact || std::any_of(channels.begin(), channels.end(), [](const Channel& c) {
          return c.interpolation == Interpolation::spherical;
        }))
      return std::nullopt;
    placed.push_back({&o.map, o.leaf->solid.exact_mesh().mesh.vertices.size()});
  }
  return common_frame(placed);
}

}  // namespace

Solid Expression::evaluate(const Options& options) const {
  if (node_->size >= 0xffffffffu) throw std::length_error("an expression of more than 2^32 - 2 solids");
  const NumberedSolids numbering(*node_);
  const std::vector<bool> matters = find_what_matters(*node_, numbering);
  const auto& all = numbering.occurrences();
  std::vector<std::uint32_t> operand(all.size());
  std::vector<Occurrence> solids;
  for (std::size_t n = 0; n < all.size(); ++n) {
    operand[n] = static_cast<std::uint32_t>(solids.size());
    if (matters[n]) solids.push_back(all[n]);
  }
  Formula formula(static_cast<std::uint32_t>(solids.size()));
  const auto whole = fold<Formula::Term>(
      *node_,
      [&](const Occurrence& o) {
        const std::uint32_t n = numbering.number_of(o);
        return matters[n] ? formula.operand(operand[n]) : formula.join(Formula::Join::any, {});
      },
      [](const Formula::Term& t) { return !t; },
      [&](Kind kind, const std::vector<Formula::Term>& terms) { return formula.join(join_of(kind), terms); });
  formula.close(whole);

  if (const std::optional<Transform> frame = frame_of(solids)) {
    std::vector<Occurrence> before = solids;
    const Transform back = frame->inverse();
    for (Occurrence& o : before) o.map = back * o.map;
    try {
      return evaluate_placed(formula, before, options).transformed(*frame, Placement::exact, Monitor(options.cancel));
    } catch (const std::overflow_error&) {
      // A coordinate is beyond all doubles there.
    }
  }
  return evaluate_placed(formula, solids, options);
}

Formula Expression::formula() const {
  if (node_->size >= 0xffffffffu) throw std::length_error("an expression of more than 2^32 - 2 solids");
  const NumberedSolids numbering(*node_);
  Formula formula(static_cast<std::uint32_t>(numbering.occurrences().size()));
  const auto whole = fold<Formula::Term>(
      *node_, [&](const Occurrence& o) { return formula.operand(numbering.number_of(o)); },
      [](const Formula::Term& t) { return !t; },
      [&](Kind kind, const std::vector<Formula::Term>& terms) { return formula.join(join_of(kind), terms); });
  formula.close(whole);
  return formula;
}

std::vector<Expression::Primitive> Expression::primitives() const {
  const NumberedSolids numbering(*node_);
  const std::vector<bool> matters = find_what_matters(*node_, numbering);
  std::vector<Primitive> primitives;
  for (std::size_t n = 0; n < matters.size(); ++n) {
    const Occurrence& o = numbering.occurrences()[n];
    primitives.push_back({o.leaf->name, o.leaf->solid, o.map, o.placement, o.negative, o.positive, matters[n]});
  }
  return primitives;
}

}  // namespace strata
