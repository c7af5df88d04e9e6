#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <map>
#include <stdexcept>

#include "core/csg/expression_node.h"
#include "strata/expression.h"

namespace strata {
namespace {

using Node = Expression::Node;
using Kind = Node::Kind;
using Pointer = Node::Pointer;

/// A subexpression and its complement, both with complements at solids only.
struct Both {
  Pointer part, complement;
};

void require_size(std::size_t size, std::size_t most) {
  if (size > most) throw std::length_error("the form has more than " + std::to_string(most) + " solids");
}

Pointer placed(const Occurrence& o) {
  auto solid = Pointer::make(o.leaf->solid, o.leaf->name);
  if (o.map.is_identity()) return solid;
  return Pointer::make(std::move(solid), o.map, o.placement);
}

Both both_of(Kind kind, const std::vector<Both>& terms) {
  std::vector<Pointer> parts, complements;
  for (const Both& t : terms) {
    parts.push_back(t.part);
    complements.push_back(t.complement);
  }
  return {Node::join(kind, std::move(parts)),
          Node::join(kind == Kind::any ? Kind::all : Kind::any, std::move(complements))};
}

Both exactly_one_of(const Both& a, const Both& b) {
  const auto either = [](Pointer p, Pointer q, Pointer r, Pointer s) {
    return Node::join(Kind::any, {Node::join(Kind::all, {std::move(p), std::move(q)}),
                                  Node::join(Kind::all, {std::move(r), std::move(s)})});
  };
  return {either(a.part, b.complement, a.complement, b.part), either(a.part, b.part, a.complement, b.complement)};
}

/// An intersection of solids: numbers + 1, negative for complemented solids; sorted.
using Clause = std::vector<std::int64_t>;
using Clauses = std::vector<Clause>;

/// The intersection of two clauses. False if it contains a solid and its complement, which makes it empty.
bool intersect(const Clause& a, const Clause& b, Clause& both) {
  const auto by_solid = [](std::int64_t x, std::int64_t y) { return std::abs(x) < std::abs(y); };
  both.clear();
  std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both), by_solid);
  both.erase(std::unique(both.begin(), both.end()), both.end());
  return std::adjacent_find(both.begin(), both.end(), [](std::int64_t x, std::int64_t y) { return x == -y; }) ==
         both.end();
}

/// Removes clauses that contain another clause: the union does not need them. O(n^2).
void drop_held(Clauses& clauses) {
  const auto by_solid = [](std::int64_t x, std::int64_t y) {
    return std::pair(std::abs(x), x) < std::pair(std::abs(y), y);
  };
  std::sort(clauses.begin(), clauses.end(),
            [](const Clause& a, const Clause& b) { return a.size() != b.size() ? a.size() < b.size() : a < b; });
  Clauses kept;
  for (Clause& c : clauses)
    if (std::none_of(kept.begin(), kept.end(),
                     [&](const Clause& k) { return std::includes(c.begin(), c.end(), k.begin(), k.end(), by_solid); }))
      kept.push_back(std::move(c));
  clauses = std::move(kept);
}

std::size_t size_of(const Clauses& clauses) {
  std::size_t size = 0;
  for (const Clause& c : clauses) size += c.size();
  return size;
}

}  // namespace

Expression Expression::positive_form(std::size_t most) const {
  const auto checked = [&](Both b) {
    require_size(b.part->size, most);
    return b;
  };
  const Both both = fold<Both>(
      *node_,
      [](const Occurrence& o) {
        const Pointer solid = placed(o);
        return Both{solid, Node::complement_of(solid)};
      },
      [](Both b) {
        return Both{std::move(b.complement), std::move(b.part)};
      },
      [&](Kind kind, std::vector<Both> terms) {
        if (kind != Kind::odd) return checked(both_of(kind, terms));
        Both odd{Node::join(Kind::any, {}), Node::join(Kind::all, {})};
        for (std::size_t i = 0; i < terms.size(); ++i) odd = checked(i == 0 ? terms[0] : exactly_one_of(odd, terms[i]));
        return odd;
      });
  return Expression(both.part);
}

namespace {

/// The clauses of an expression in positive form.
Clauses clauses_of(const Node& positive, const NumberedSolids& numbered, std::size_t most) {
  return fold<Clauses>(
      positive, [&](const Occurrence& o) { return Clauses{{std::int64_t{numbered.number_of(o)} + 1}}; },
      [](Clauses c) {  // of a solid
        c.front().front() *= -1;
        return c;
      },
      [&](Kind kind, std::vector<Clauses> terms) {
        Clauses result;
        if (kind == Kind::all) result.emplace_back();
        for (Clauses& t : terms) {
          if (kind == Kind::any) {
            result.insert(result.end(), std::make_move_iterator(t.begin()), std::make_move_iterator(t.end()));
          } else {
            Clauses product;
            std::size_t size = 0;
            Clause both;
            for (const Clause& a : result)
              for (const Clause& b : t)
                if (intersect(a, b, both)) {
                  product.push_back(both);
                  require_size(size += both.size(), most);
                }
            result = std::move(product);
          }
          drop_held(result);
        }
        require_size(size_of(result), most);
        return result;
      });
}

std::uint32_t solid_of(std::int64_t factor) { return static_cast<std::uint32_t>(std::abs(factor) - 1); }

}  // namespace

Expression Expression::disjunctive_form(std::size_t most) const {
  const Expression positive = positive_form(most);
  std::vector<Pointer> solids;
  const NumberedSolids numbered(*positive.node_);
  for (const Occurrence& o : numbered.occurrences()) solids.push_back(placed(o));
  std::vector<Pointer> terms;
  for (const Clause& c : clauses_of(*positive.node_, numbered, most)) {
    std::vector<Pointer> factors;
    for (const std::int64_t x : c)
      factors.push_back(x > 0 ? solids[solid_of(x)] : Node::complement_of(solids[solid_of(x)]));
    terms.push_back(Node::join(Kind::all, std::move(factors)));
  }
  return Expression(Node::join(Kind::any, std::move(terms)));
}

Expression::Products Expression::products(std::size_t most) const {
  const Expression positive = positive_form(most);
  const NumberedSolids own(*node_), numbered(*positive.node_);
  std::vector<std::uint32_t> primitive;
  for (const Occurrence& o : numbered.occurrences()) primitive.push_back(own.number_of(o));
  Products products;
  for (const Clause& c : clauses_of(*positive.node_, numbered, most)) {
    auto& factors = products.emplace_back();
    for (const std::int64_t x : c) factors.push_back({primitive[solid_of(x)], x < 0});
  }
  return products;
}

bool is_in_products(const Expression::Products& products, FunctionRef<bool(std::uint32_t)> is_in) {
  std::map<std::uint32_t, bool> known;
  const auto holds = [&](const Expression::Factor& f) {
    auto at = known.find(f.primitive);
    if (at == known.end()) at = known.emplace(f.primitive, is_in(f.primitive)).first;
    return at->second != f.negative;
  };
  return std::any_of(products.begin(), products.end(),
                     [&](const auto& factors) { return std::all_of(factors.begin(), factors.end(), holds); });
}

}  // namespace strata
