#include "extensions/openscad/plan.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "extensions/openscad/import.h"
#include "extensions/openscad/polyhedron.h"
#include "extensions/openscad/primitives.h"
#include "extensions/openscad/shapes.h"
#include "extensions/openscad/surface.h"
#include "extensions/openscad/text.h"

namespace strata::openscad {
namespace {

/// Visits the nodes in order and ends each when its children are known.
class Planner {
 public:
  Planner(const std::vector<SyntaxNode>& nodes, const CsgOptions& options, Report& report)
      : nodes_(nodes), options_(options), report_(report), primitives_(report), fonts_(options.fonts) {}

  std::vector<Step> plan() {
    const auto [first, last] = what_counts();
    static const SyntaxNode top{};
    steps_.emplace_back().operation = operation_of(NodeKind::union_, top, {}, options_.placement, report_);
    open_.push_back({0, last});
    for (std::size_t n = first; n < last;) {
      while (open_.back().end == n) close();
      n = n != root_ && is_dropped(nodes_[n]) ? nodes_[n].end : enter(n);
    }
    while (!open_.empty()) close();
    for (const Step& step : steps_)
      if (takes_values(step))
        for (const std::uint32_t child : step.children) evaluate_if_shared(child);
    return std::move(steps_);
  }

 private:
  /// A step whose node has not ended yet.
  struct Open {
    std::uint32_t step = 0;
    std::size_t end = 0;
    bool is_colored = false;  ///< it gives a colour, or is in a node that does
    bool is_lost = false;     ///< a colour that does not count
  };
  static constexpr std::size_t none = ~std::size_t{0};

  /// The range of nodes to evaluate: all, or the first node that is marked ! and not inside one marked *, with its
  /// children.
  std::pair<std::size_t, std::size_t> what_counts() {
    for (std::size_t n = 0; n < nodes_.size();) {
      if (nodes_[n].disabled) {
        n = nodes_[n].end;
        continue;
      }
      if (nodes_[n].root && root_ == none) {
        root_ = n;
        report_.note(nodes_[n].place, "only the part marked ! counts");
      } else if (nodes_[n].root) {
        report_.note(nodes_[n].place, "another part is marked !, but the first one counts");
      }
      ++n;
    }
    return root_ == none ? std::pair{std::size_t{0}, nodes_.size()} : std::pair{root_, nodes_[root_].end};
  }

  bool is_dropped(const SyntaxNode& node) {
    if (node.disabled) {
      report_.note(node.place, "a part marked * is left out");
    } else if (node.background) {
      report_.note(node.place, "a part marked % is left out");
    }
    return node.disabled || node.background;
  }

  /// Returns the number of the next node.
  std::size_t enter(std::size_t n) {
    const SyntaxNode& node = nodes_[n];
    const NodeKind kind = kind_of(node.name);
    if (const char* const reason = refusal(kind)) report_.fail(node.place, std::string(node.name) + " " + reason);
    Step step;
    step.node = &node;
    step.kind = kind;
    const bool is_leaf = kind < NodeKind::multmatrix;
    std::optional<std::array<double, 4>> color;
    if (kind == NodeKind::color) {  // of nested ones the outermost counts
      if (!open_.back().is_colored) color = color_of(node, report_);
      step.operation = color ? color_operation(node, *color) : union_operation(node);
    } else if (is_leaf) {
      step.part = leaf(kind, node);
      if (node.end != n + 1) report_.fail(nodes_[n + 1].place, "nothing can be in a " + std::string(node.name));
    } else {
      step.operation = operation_of(kind, node, name_of(node), options_.placement, report_);
    }
    open_.push_back({static_cast<std::uint32_t>(steps_.size()), node.end, color || open_.back().is_colored,
                     kind == NodeKind::color && !color});
    steps_.push_back(std::move(step));
    return n + 1;
  }

  Part leaf(NodeKind kind, const SyntaxNode& node) {
    if (kind == NodeKind::square) return square(node, report_);
    if (kind == NodeKind::circle) return circle(node, report_);
    if (kind == NodeKind::polygon) return polygon(node, report_);
    if (kind == NodeKind::text) return text(node, fonts_, report_);
    if (kind == NodeKind::import) return import(node, name_of(node), options_, report_);
    if (kind == NodeKind::surface) return surface(node, name_of(node), options_, report_);
    const std::optional<Solid> solid = kind == NodeKind::cube       ? primitives_.cube(node)
                                       : kind == NodeKind::sphere   ? primitives_.sphere(node)
                                       : kind == NodeKind::cylinder ? primitives_.cylinder(node)
                                                                    : polyhedron(node, report_);
    return solid ? Part::of(Expression(*solid, name_of(node)), true) : Part();
  }

  /// "cube_12", or with the column if the line has several nodes.
  std::string name_of(const SyntaxNode& node) {
    std::string name = std::string(node.name).append("_").append(std::to_string(node.place.line));
    if (!names_.insert(name).second) name.append("_").append(std::to_string(node.place.column));
    return name;
  }

  /// Ends a node. An operation that there is already takes its place; leaves keep their names.
  void close() {
    const auto [number, end, is_colored, is_lost] = open_.back();
    open_.pop_back();
    if (open_.empty()) return;
    Step& step = steps_[number];
    std::string key(is_lost ? "union()" : step.node->text);
    for (const std::uint32_t child : step.children) key.append(",").append(std::to_string(equal_[child]));
    std::uint32_t known = number_of_.try_emplace(std::move(key), number).first->second;
    equal_.resize(steps_.size());
    equal_[number] = known;
    if (!step.operation) known = number;
    if (known != number) {
      for (const std::uint32_t child : step.children) --steps_[child].uses;
      step = Step();
    }
    Step& parent = steps_[open_.back().step];
    parent.children.push_back(known);
    parent.level = std::max(parent.level, steps_[known].level + 1);
    ++steps_[known].uses;
  }

  /// True for operations that always evaluate the solids in them.
  static bool takes_values(const Step& step) {
    return step.kind == NodeKind::projection || step.kind == NodeKind::resize ||
           (step.kind == NodeKind::minkowski && step.children.size() > 1);
  }

  /// For a step whose value is taken: goes down, through maps and unions of one child, to the first step that several
  /// others use, and has that one evaluated.
  void evaluate_if_shared(std::uint32_t number) {
    while (true) {
      Step& step = steps_[number];
      if (!step.operation || step.kind >= NodeKind::hull) return;
      if (step.uses > 1) step.is_evaluated = true;
      if (step.uses > 1 || step.children.size() != 1 || step.kind >= NodeKind::difference) return;
      number = step.children.front();
    }
  }

  const std::vector<SyntaxNode>& nodes_;
  const CsgOptions& options_;
  Report& report_;
  Primitives primitives_;
  Fonts fonts_;
  std::vector<Step> steps_;
  std::vector<Open> open_;
  std::map<std::string, std::uint32_t> number_of_;
  std::vector<std::uint32_t> equal_;  ///< of every step that has ended, the first that is equal
  std::set<std::string> names_;
  std::size_t root_ = none;
};

}  // namespace

std::vector<Step> plan_of(const std::vector<SyntaxNode>& nodes, const CsgOptions& options, Report& report) {
  return Planner(nodes, options, report).plan();
}

}  // namespace strata::openscad
