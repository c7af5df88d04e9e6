#include "extensions/openscad/model.h"

#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "extensions/openscad/arguments.h"
#include "extensions/openscad/node_kind.h"
#include "extensions/openscad/polyhedron.h"
#include "extensions/openscad/primitives.h"

namespace strata::openscad {
namespace {

/// An expression, or the empty part.
using Part = std::optional<Expression>;

Part union_of(std::vector<Part> parts) {
  std::vector<Expression> terms;
  for (Part& p : parts)
    if (p) terms.push_back(std::move(*p));
  if (terms.empty()) return std::nullopt;
  return terms.size() == 1 ? std::move(terms.front()) : Expression::any(terms);
}

Part intersection_of(const std::vector<Part>& parts) {
  std::vector<Expression> terms;
  for (const Part& p : parts) {
    if (!p) return std::nullopt;
    terms.push_back(*p);
  }
  if (terms.empty()) return std::nullopt;
  return terms.size() == 1 ? terms.front() : Expression::all(terms);
}

Part difference_of(const std::vector<Part>& parts) {
  if (parts.empty() || !parts.front()) return std::nullopt;
  std::vector<Expression> terms{*parts.front()};
  for (std::size_t i = 1; i < parts.size(); ++i)
    if (parts[i]) terms.push_back(~*parts[i]);
  return terms.size() == 1 ? terms.front() : Expression::all(terms);
}

/// Missing rows and columns are those of the identity.
std::array<double, 16> matrix_of(const Arguments& arguments) {
  std::array<double, 16> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const Value* const rows = arguments.find("m");
  if (rows == nullptr) return m;
  const auto is_short = [](const Value& v) { return v.kind == Value::Kind::vector && v.items.size() <= 4; };
  if (!is_short(*rows)) arguments.fail("m", "is no vector of up to four rows");
  for (std::size_t i = 0; i < rows->items.size(); ++i) {
    const Value& row = rows->items[i];
    if (!is_short(row)) arguments.fail("m", "has a row that is no vector of up to four numbers");
    for (std::size_t j = 0; j < row.items.size(); ++j) {
      if (row.items[j].kind != Value::Kind::number) arguments.fail("m", "has a coefficient that is no number");
      m[4 * i + j] = row.items[j].number;
    }
  }
  return m;
}

/// Visits the nodes in order and joins the children of each node when it ends.
class ModelBuilder {
 public:
  ModelBuilder(const std::vector<SyntaxNode>& nodes, Placement placement, Report& report)
      : nodes_(nodes), placement_(placement), report_(report), primitives_(report) {}

  Expression build() {
    const auto [first, last] = what_counts();
    frames_.push_back({NodeKind::union_, last, {}, {}});
    for (std::size_t n = first; n < last;) {
      while (frames_.back().end == n) close();
      n = n != root_ && is_dropped(nodes_[n]) ? nodes_[n].end : enter(n);
    }
    while (frames_.size() > 1) close();
    Part whole = union_of(std::move(frames_.back().parts));
    return whole ? std::move(*whole) : Expression::any({});
  }

 private:
  /// A node that has not ended yet, and its children so far.
  struct Frame {
    NodeKind kind = NodeKind::union_;
    std::size_t end = 0;
    std::optional<Transform> map;  ///< of a multmatrix with an inverse
    std::vector<Part> parts;
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
    Frame frame{kind, node.end, {}, {}};
    switch (kind) {
      case NodeKind::cube:
        return add(n, primitives_.cube(node));
      case NodeKind::sphere:
        return add(n, primitives_.sphere(node));
      case NodeKind::cylinder:
        return add(n, primitives_.cylinder(node));
      case NodeKind::polyhedron:
        return add(n, polyhedron(node, report_));
      case NodeKind::multmatrix:
        frame.map = map_of(node);
        break;
      case NodeKind::decorate:
        report_.note(node.place, std::string(node.name) + " is passed over");
        break;
      case NodeKind::union_:
      case NodeKind::difference:
      case NodeKind::intersection:
        (void)Arguments(node, {}, report_);  // there are none
        break;
      case NodeKind::flat:
      case NodeKind::file:
      case NodeKind::other:
      case NodeKind::unknown:
        break;  // refused
    }
    frames_.push_back(std::move(frame));
    return n + 1;
  }

  std::size_t add(std::size_t n, const std::optional<Solid>& solid) {
    const SyntaxNode& node = nodes_[n];
    if (node.end != n + 1) report_.fail(nodes_[n + 1].place, "nothing can be in a " + std::string(node.name));
    frames_.back().parts.push_back(solid ? Part(Expression(*solid, name_of(node))) : Part());
    return n + 1;
  }

  /// "cube_12", or with the column if the line has several nodes.
  std::string name_of(const SyntaxNode& node) {
    std::string name = std::string(node.name).append("_").append(std::to_string(node.place.line));
    if (!names_.insert(name).second) name.append("_").append(std::to_string(node.place.column));
    return name;
  }

  /// Nullopt where it has no inverse.
  std::optional<Transform> map_of(const SyntaxNode& node) {
    const Arguments arguments(node, {"m"}, report_);
    const std::array<double, 16> m = matrix_of(arguments);
    for (const double x : m) {
      if (std::isfinite(x)) continue;
      report_.note(node.place, "a multmatrix that is not finite makes nothing");
      return std::nullopt;
    }
    if (m[12] != 0 || m[13] != 0 || m[14] != 0) arguments.fail("m", "has a last row that is not 0 0 0 1");
    try {
      if (m[15] != 0) return Transform::from_matrix(m);
    } catch (const std::invalid_argument&) {  // its other reasons cannot occur here
    }
    report_.note(node.place, "a multmatrix without inverse makes nothing");
    return std::nullopt;
  }

  void close() {
    Frame frame = std::move(frames_.back());
    frames_.pop_back();
    frames_.back().parts.push_back(join(std::move(frame)));
  }

  Part join(Frame frame) const {
    if (frame.kind == NodeKind::difference) return difference_of(frame.parts);
    if (frame.kind == NodeKind::intersection) return intersection_of(frame.parts);
    Part all = union_of(std::move(frame.parts));
    if (frame.kind != NodeKind::multmatrix || !all) return all;
    if (!frame.map) return std::nullopt;
    return frame.map->is_identity() ? std::move(all) : all->transformed(*frame.map, placement_);
  }

  const std::vector<SyntaxNode>& nodes_;
  Placement placement_;
  Report& report_;
  Primitives primitives_;
  std::vector<Frame> frames_;
  std::set<std::string> names_;
  std::size_t root_ = none;
};

}  // namespace

Expression model_of(const std::vector<SyntaxNode>& nodes, Placement placement, Report& report) {
  return ModelBuilder(nodes, placement, report).build();
}

}  // namespace strata::openscad
