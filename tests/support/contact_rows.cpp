#include "support/contact_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/shapes.h"
#include "support/transform.h"

namespace strata::test {
namespace {

using Rows = std::vector<ContactRow>;
using Corners = std::vector<std::array<double, 2>>;
const ContactFacts nothing{};

/// The distance of 1 from the next double.
Rational ulp() { return to_rational(std::nextafter(1., 2.)) - 1; }

/// A row of operands without a common point inside them.
ContactRow outside(std::string name, std::vector<Mesh> operands, const ContactFacts& all, const ContactFacts& first,
                   const ContactFacts& last) {
  return {std::move(name), std::move(operands), {{all, nothing, first, last, all}}};
}

/// A row of a first operand that contains the second.
ContactRow inside(std::string name, std::vector<Mesh> operands, const ContactFacts& first, const ContactFacts& second,
                  const ContactFacts& rest) {
  return {std::move(name), std::move(operands), {{first, second, rest, nothing, rest}}};
}

Mesh cube(double size) { return box({0, 0, 0}, {size, size, size}); }

/// A roof of volume 18 with its ridge through (2, 2, top), along (1, -1, 0), and its eaves 3 below.
Mesh roof(double top) {
  const std::vector<Vertex> points{{0, 4, top},           {4, 0, top},          {-.75, 3.25, top - 3},
                                   {3.25, -.75, top - 3}, {.75, 4.75, top - 3}, {4.75, .75, top - 3}};
  return convex_hull(points);
}

Corners unit_square(double left) { return {{left, 0}, {left + 1, 0}, {left + 1, 1}, {left, 1}}; }

/// A triangle and its other side: closed, without volume.
Mesh flat() { return {{{1, .5, 2}, {1.75, 1, 2}, {1, 1.5, 2}}, {{0, 1, 2}, {0, 2, 1}}}; }

/// A prism in the quadrant x > 1, y < 1 with one edge on the line x = y = 1.
Mesh wedge() { return prism(Corners{{1, 1}, {1.25, .25}, {1.75, .75}}, 0, 1); }

void add_no_contact(Rows& rows) {
  rows.push_back(outside("no contact, apart", {cube(2), box({3, 0, 0}, {4, 1, 1})}, {9, 12, 0, 0, "a=24 b=6"},
                         {8, 6, 0, 0, "a=24"}, {1, 6, 0, 0, "b=6"}));
  rows.push_back(outside("no contact, one ulp apart", {cube(1), box({std::nextafter(1., 2.), 0, 0}, {2, 1, 1})},
                         {2 - ulp(), 12, 0, 0, "a=6 b"}, {1, 6, 0, 0, "a=6"}, {1 - ulp(), 6, 0, 0, "b"}));
  rows.push_back(inside("no contact, nested", {cube(4), box({1, 1, 1}, {2, 2, 2})}, {64, 6, 0, 0, "a=96"},
                        {1, 6, 0, 0, "b=6"}, {63, 12, 0, 0, "a=96 -b=6"}));
}

void add_vertices(Rows& rows) {
  rows.push_back(outside("vertex on vertex, outside", {cube(1), box({1, 1, 1}, {2, 2, 2})}, {2, 12, 0, 1, "a=6 b=6"},
                         {1, 6, 0, 0, "a=6"}, {1, 6, 0, 0, "b=6"}));
  rows.push_back(inside("vertex on vertex, inside", {cube(4), tetrahedron({0, 0, 0}, {1, 2, 1}, {2, 1, 1}, {1, 1, 2})},
                        {64, 6, 0, 0, "a=96"}, {Rational(2, 3), 4, 0, 0, "b=9"},
                        {Rational(190, 3), 10, 0, 1, "a=96 -b=9"}));
  rows.push_back(outside("vertex on edge, outside", {cube(2), tetrahedron({2, 2, 1}, {3, 3, 0}, {3, 3, 2}, {4, 3, 1})},
                         {Rational(25, 3), 10, 0, 1, "a=24 b=7"}, {8, 6, 0, 0, "a=24"},
                         {Rational(1, 3), 4, 0, 0, "b=7"}));
  rows.push_back(inside("vertex on edge, inside", {cube(4), tetrahedron({0, 0, 2}, {1, 1, 1}, {1, 1, 3}, {2, 1, 2})},
                        {64, 6, 0, 0, "a=96"}, {Rational(1, 3), 4, 0, 0, "b=7"},
                        {Rational(191, 3), 10, 0, 1, "a=96 -b=7"}));
  rows.push_back(outside("vertex on face, outside", {cube(4), tetrahedron({1, 2, 4}, {2, 1, 5}, {2, 3, 5}, {1, 3, 5})},
                         {Rational(193, 3), 10, 0, 1, "a=96 b=6"}, {64, 6, 0, 0, "a=96"},
                         {Rational(1, 3), 4, 0, 0, "b=6"}));
  rows.push_back(inside("vertex on face, inside", {cube(4), tetrahedron({1, 2, 4}, {2, 1, 3}, {2, 3, 3}, {1, 3, 3})},
                        {64, 6, 0, 0, "a=96"}, {Rational(1, 3), 4, 0, 0, "b=6"},
                        {Rational(191, 3), 10, 0, 1, "a=96 -b=6"}));
  rows.push_back({"vertex on face, crossing",
                  {cube(4), tetrahedron({1, 2, 4}, {2, 1, 5}, {2, 3, 5}, {2, 2, 3})},
                  {{{Rational(129, 2), 10, 0, 0, "a=191/2 b=11/2"},
                    {Rational(1, 6), 4, 0, 0, "a=1/2 b=5/2"},
                    {Rational(383, 6), 9, 0, 0, "a=191/2 -b=5/2"},
                    {Rational(1, 2), 5, 0, 0, "-a=1/2 b=11/2"},
                    {Rational(193, 3), 14, 5, 5, "a=191/2 -a=1/2 b=11/2 -b=5/2"}}}});
}

void add_edges(Rows& rows) {
  rows.push_back(
      outside("edge through vertex, outside", {cube(2), tetrahedron({0, 4, 2}, {4, 0, 2}, {4, 4, 2}, {3, 3, 4})},
              {Rational(40, 3), 10, 0, 1, "a=24 b=32"}, {8, 6, 0, 0, "a=24"}, {Rational(16, 3), 4, 0, 0, "b=32"}));
  rows.push_back({"edge through vertex, crossing",
                  {cube(2), roof(2)},
                  {{{Rational(77, 3), 11, 0, 0, "a=43/2 b=157/2"},
                    {Rational(1, 3), 4, 0, 0, "a=5/2 b=5/2"},
                    {Rational(23, 3), 7, 0, 0, "a=43/2 -b=5/2"},
                    {Rational(53, 3), 8, 0, 0, "-a=5/2 b=157/2"},
                    {Rational(76, 3), 15, 6, 6, "a=43/2 -a=5/2 b=157/2 -b=5/2"}}}});
  rows.push_back(outside("edge across edge, outside",
                         {tetrahedron({0, 2, 0}, {4, 2, 0}, {2, 0, -2}, {2, 4, -2}),
                          tetrahedron({2, 0, 0}, {2, 4, 0}, {4, 2, 2}, {0, 2, 2})},
                         {Rational(32, 3), 8, 0, 1, "a=32 b=32"}, {Rational(16, 3), 4, 0, 0, "a=32"},
                         {Rational(16, 3), 4, 0, 0, "b=32"}));
  rows.push_back({"edge across edge, crossing",
                  {cube(2), roof(1)},
                  {{{Rational(623, 24), 11, 0, 0, "a=187/8 b=643/8"},
                    {Rational(1, 24), 4, 0, 0, "a=5/8 b=5/8"},
                    {Rational(191, 24), 7, 0, 0, "a=187/8 -b=5/8"},
                    {Rational(431, 24), 8, 0, 0, "-a=5/8 b=643/8"},
                    {Rational(311, 12), 15, 4, 4, "a=187/8 -a=5/8 b=643/8 -b=5/8"}}}});
  rows.push_back(outside("edge on edge, equal", {cube(1), box({1, 1, 0}, {2, 2, 1})}, {2, 12, 1, 2, "a=6 b=6"},
                         {1, 6, 0, 0, "a=6"}, {1, 6, 0, 0, "b=6"}));
  rows.push_back(outside("edge on edge, overlapping", {cube(1), box({1, 1, .5}, {2, 2, 1.5})}, {2, 12, 1, 2, "a=6 b=6"},
                         {1, 6, 0, 0, "a=6"}, {1, 6, 0, 0, "b=6"}));
  rows.push_back(inside("edge on edge, inside", {cube(4), tetrahedron({0, 0, 1}, {0, 0, 3}, {1, 2, 2}, {2, 1, 2})},
                        {64, 6, 0, 0, "a=96"}, {1, 4, 0, 0, "b=11"}, {63, 10, 1, 2, "a=96 -b=11"}));
  rows.push_back(
      outside("edge in face, outside", {cube(4), tetrahedron({1, .5, 4}, {3, .5, 4}, {2, 1, 5}, {2, .25, 5})},
              {Rational(257, 4), 10, 1, 2, "a=96 b=17/4"}, {64, 6, 0, 0, "a=96"}, {Rational(1, 4), 4, 0, 0, "b=17/4"}));
  rows.push_back(inside("edge in face, inside", {cube(4), tetrahedron({1, .5, 4}, {3, .5, 4}, {2, 1, 3}, {2, .25, 3})},
                        {64, 6, 0, 0, "a=96"}, {Rational(1, 4), 4, 0, 0, "b=17/4"},
                        {Rational(255, 4), 10, 1, 2, "a=96 -b=17/4"}));
  rows.push_back({"edge in face, crossing",
                  {cube(4), octahedron({2, 2, 4}, 1)},
                  {{{Rational(194, 3), 10, 0, 0, "a=94 b=6"},
                    {Rational(2, 3), 5, 0, 0, "a=2 b=6"},
                    {Rational(190, 3), 10, 0, 0, "a=94 -b=6"},
                    {Rational(2, 3), 5, 0, 0, "-a=2 b=6"},
                    {64, 15, 6, 6, "a=94 -a=2 b=6 -b=6"}}}});
}

void add_coplanar(Rows& rows) {
  const Corners square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  rows.push_back(inside("coplanar faces, same side, equal", {cube(2), pyramid(square, 0, {1, 1, 1})},
                        {8, 6, 0, 0, "a=24"}, {Rational(4, 3), 5, 0, 0, "a=4 b=8"},
                        {Rational(20, 3), 9, 0, 0, "a=20 -b=8"}));
  rows.push_back(inside("coplanar faces, same side, contained", {cube(4), box({2, .25, 0}, {3, .75, 2})},
                        {64, 6, 0, 0, "a=96"}, {1, 6, 0, 0, "a=1/2 b=13/2"}, {63, 11, 0, 0, "a=191/2 -b=13/2"}));
  rows.push_back({"coplanar faces, same side, overlapping",
                  {cube(2), box({1, 1, 0}, {3, 3, 1})},
                  {{{11, 11, 0, 0, "a=22 b=12"},
                    {1, 6, 0, 0, "a=3 b=3"},
                    {7, 9, 0, 0, "a=21 -b=3"},
                    {3, 8, 0, 0, "-a=2 b=12"},
                    {10, 17, 6, 7, "a=21 -a=2 b=12 -b=3"}}}});
  rows.push_back(outside("coplanar faces, opposite sides, equal", {cube(2), pyramid(square, 2, {1, 1, 3})},
                         {Rational(28, 3), 9, 0, 0, "a=20 b=8"}, {8, 6, 0, 0, "a=24"},
                         {Rational(4, 3), 5, 0, 0, "b=12"}));
  rows.push_back(outside("coplanar faces, opposite sides, contained", {cube(4), box({2, .25, 4}, {3, .75, 6})},
                         {65, 11, 0, 0, "a=191/2 b=13/2"}, {64, 6, 0, 0, "a=96"}, {1, 6, 0, 0, "b=7"}));
  rows.push_back(outside("coplanar faces, opposite sides, overlapping", {cube(2), box({1, 1, 2}, {3, 3, 3})},
                         {12, 12, 0, 0, "a=23 b=15"}, {8, 6, 0, 0, "a=24"}, {4, 6, 0, 0, "b=16"}));
  rows.push_back(outside("coplanar faces, same side, edge in common",
                         {pyramid(unit_square(0), 0, {.5, .5, 1}), pyramid(unit_square(1), 0, {1.5, .5, 1})},
                         {Rational(2, 3), 9, 1, 2, "a=4 b=4"}, {Rational(1, 3), 5, 0, 0, "a=4"},
                         {Rational(1, 3), 5, 0, 0, "b=4"}));
  rows.push_back(outside("coplanar faces, opposite sides, edge in common", {cube(1), box({1, 0, -1}, {2, 1, 0})},
                         {2, 12, 1, 2, "a=6 b=6"}, {1, 6, 0, 0, "a=6"}, {1, 6, 0, 0, "b=6"}));
  rows.push_back(outside("coplanar faces, vertex in common", {cube(1), box({1, 1, -1}, {2, 2, 0})},
                         {2, 12, 0, 1, "a=6 b=6"}, {1, 6, 0, 0, "a=6"}, {1, 6, 0, 0, "b=6"}));
  rows.push_back({"identical operands",
                  {cube(2), cube(2)},
                  {{{8, 6, 0, 0, "a=24"}, {8, 6, 0, 0, "a=24"}, nothing, nothing, nothing}}});
  rows.push_back({"equal operands in other triangles",
                  {cube(2), cube_grid(2)},
                  {{{8, 6, 0, 0, "a=24"}, {8, 6, 0, 0, "a=24"}, nothing, nothing, nothing}}});
}

void add_self_touching(Rows& rows) {
  const Mesh far = box({3, 3, 3}, {4, 4, 4});
  const Mesh listed_apart = merged(std::vector{cube(1), box({1, 1, 0}, {2, 2, 1})});
  rows.push_back(outside("operand touches itself in an edge", {edge_sharing_cells(), far}, {3, 18, 1, 2, "a=12 b=6"},
                         {2, 12, 1, 2, "a=12"}, {1, 6, 0, 0, "b=6"}));
  rows.push_back(outside("operand touches itself in a vertex", {vertex_sharing_cells(), far}, {3, 18, 0, 1, "a=12 b=6"},
                         {2, 12, 0, 1, "a=12"}, {1, 6, 0, 0, "b=6"}));
  rows.push_back(
      {"operand touches itself, listed apart",
       {listed_apart, far},
       {{{3, 18, 1, 2, "a=12 b=6"}, nothing, {2, 12, 1, 2, "a=12"}, {1, 6, 0, 0, "b=6"}, {3, 18, 1, 2, "a=12 b=6"}}},
       2});
  rows.push_back(outside("operand listed apart, another touches it there", {listed_apart, wedge()},
                         {Rational(9, 4), 17, 1, 2, "a=12 b=7/2"}, {2, 12, 1, 2, "a=12"},
                         {Rational(1, 4), 5, 0, 0, "b=7/2"}));
  rows.push_back(
      {"result touches itself",
       {box({0, 0, 0}, {2, 2, 1}), box({0, 1, 0}, {1, 2, 1}), box({1, 0, 0}, {2, 1, 1})},
       {{{4, 6, 0, 0, "a=16"}, nothing, {2, 12, 1, 2, "a=8 -b=2 -c=2"}, nothing, {2, 12, 1, 2, "a=8 -b=2 -c=2"}}}});
}

void add_several(Rows& rows) {
  rows.push_back(
      outside("several through one vertex",
              {cube(1), box({1, 1, 1}, {2, 2, 2}), tetrahedron({1, 1, 1}, {2, .5, 1.5}, {1.5, 0, 1.5}, {1.5, .5, 2})},
              {Rational(25, 12), 16, 0, 1, "a=6 b=6 c=9/4"}, {1, 6, 0, 0, "a=6"}, {Rational(1, 12), 4, 0, 0, "c=9/4"}));
  rows.push_back(outside("several about one edge", {cube(1), box({1, 1, 0}, {2, 2, 1}), wedge()},
                         {Rational(9, 4), 17, 1, 2, "a=6 b=6 c=7/2"}, {1, 6, 0, 0, "a=6"},
                         {Rational(1, 4), 5, 0, 0, "c=7/2"}));
  rows.push_back({"several in one plane, same side",
                  {box({1, 1, 0}, {2, 2, 1}), box({0, 0, 0}, {3, 3, 2}), box({-1, -1, 0}, {4, 4, 3})},
                  {{{75, 6, 0, 0, "a=1 b=8 c=101"},
                    {1, 6, 0, 0, "a=6"},
                    nothing,
                    {57, 11, 0, 0, "-b=33 c=101"},
                    {58, 17, 0, 0, "a=6 -b=33 c=101"}}}});
  rows.push_back({"several in one plane, both sides",
                  {box({0, 0, 0}, {2, 2, 1}), box({0, 0, -1}, {2, 2, 0}), box({0, 0, 0}, {2, 2, 2})},
                  {{{12, 6, 0, 0, "a=8 b=12 c=12"},
                    nothing,
                    nothing,
                    {4, 6, 0, 0, "-a=4 c=12"},
                    {8, 12, 0, 0, "-a=8 b=12 c=12"}}}});
  rows.push_back(
      {"several, two of them united first",
       {box({-3, 0, 0}, {-2, 1, 1}), cube(1), box({1.25, .25, 0}, {1.75, .75, .5}), box({1, 0, 0}, {2, 1, 1})},
       {{{3, 12, 0, 0, "a=6 b=5 d=5"},
         nothing,
         {1, 6, 0, 0, "a=6"},
         {Rational(7, 8), 11, 0, 0, "-c=5/4 d=23/4"},
         {Rational(23, 8), 17, 0, 0, "a=6 b=5 -c=5/4 d=19/4"}}}});
  rows.push_back({"several fill an operand",
                  {box({1, 0, 0}, {3, 2, 2}), cube(2), box({2, 0, 0}, {4, 2, 2})},
                  {{{16, 6, 0, 0, "a=16 b=12 c=12"},
                    nothing,
                    nothing,
                    {4, 6, 0, 0, "-a=4 c=12"},
                    {8, 12, 0, 0, "-a=8 b=12 c=12"}}}});
}

void add_empty(Rows& rows) {
  rows.push_back({"empty operand",
                  {cube(2), Mesh{}},
                  {{{8, 6, 0, 0, "a=24"}, nothing, {8, 6, 0, 0, "a=24"}, nothing, {8, 6, 0, 0, "a=24"}}}});
  rows.push_back({"flat operand",
                  {cube(2), flat()},
                  {{{8, 6, 0, 0, "a=24"}, nothing, {8, 6, 0, 0, "a=24"}, nothing, {8, 6, 0, 0, "a=24"}}},
                  0,
                  InputClass::overlapping});
  rows.push_back({"all operands empty", {Mesh{}, Mesh{}}, {}});
  rows.push_back({"only a wall in common",
                  {cube(1), box({1, 0, 0}, {2, 1, 1}), box({1, .25, .25}, {3, .75, .75})},
                  {{{Rational(9, 4), 11, 0, 0, "a=5 b=19/4 c=9/4"},
                    nothing,
                    {1, 6, 0, 0, "a=6"},
                    {Rational(1, 4), 6, 0, 0, "-b=1/4 c=9/4"},
                    {2, 17, 8, 8, "a=21/4 b=19/4 -b=1/4 c=9/4 -c=2"}}}});
}

Rows all_rows() {
  Rows rows;
  add_no_contact(rows);
  add_vertices(rows);
  add_edges(rows);
  add_coplanar(rows);
  add_self_touching(rows);
  add_several(rows);
  add_empty(rows);
  return rows;
}

}  // namespace

const std::vector<ContactRow>& contact_rows() {
  static const Rows rows = all_rows();
  return rows;
}

Operation operation_of(ContactQuestion question) {
  switch (question) {
    case ContactQuestion::union_:
      return Operation::union_;
    case ContactQuestion::intersection:
      return Operation::intersection;
    case ContactQuestion::difference:
    case ContactQuestion::reversed_difference:
      return Operation::difference;
    case ContactQuestion::symmetric_difference:
      return Operation::symmetric_difference;
  }
  return Operation::union_;
}

std::vector<Mesh> operands_of(const ContactRow& row, ContactQuestion question) {
  std::vector<Mesh> operands = row.operands;
  if (question == ContactQuestion::reversed_difference) std::reverse(operands.begin(), operands.end());
  return operands;
}

const char* name(ContactQuestion question) {
  return question == ContactQuestion::reversed_difference ? "reversed difference"
                                                          : strata::name(operation_of(question));
}

}  // namespace strata::test
