#include "extensions/incremental/face_tree.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>
#include <utility>

namespace strata {
namespace {

constexpr std::size_t most_in_leaf = 16;

/// Halves of fewer faces are not worth a second thread.
constexpr std::size_t worth_a_thread = 2048;

/// A tree is not rebuilt while neither half has more than this part of its faces.
constexpr double balance = 0.75;

DoubleDouble coordinate(const IncrementalVertex& c, std::size_t axis) {
  if (c.meet_planes[0] != nullptr) return c.meet.at[axis];
  if (c.rational) return Bounded{c.at[axis], std::abs(c.at[axis]) * Bounded::rounding + Bounded::underflow};
  return c.at[axis];
}

RealPoint<DoubleDouble> place(const IncrementalVertex& c) {
  return {coordinate(c, 0), coordinate(c, 1), coordinate(c, 2)};
}

double middle(const WorkFace& f, std::size_t axis) {
  const Box& b = f.box();
  return b.lower[axis] / 2 + b.upper[axis] / 2;
}

std::size_t longest_axis(const Box& b) {
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (b.upper[i] - b.lower[i] > b.upper[axis] - b.lower[axis]) axis = i;
  return axis;
}

/// Both, at the same time if they have many faces.
template <class First, class Second>
void do_both(std::size_t faces, const First& first, const Second& second) {
  if (faces < 2 * worth_a_thread) {
    first();
    second();
  } else {
    tbb::parallel_invoke(first, second);
  }
}

/// The growth of a box that takes in another one, in half perimeters.
double growth(const Box& box, const Box& added) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    sum += std::max(0.0, box.lower[i] - added.lower[i]) + std::max(0.0, added.upper[i] - box.upper[i]);
  return sum;
}

}  // namespace

WorkFace::WorkFace(std::array<IncrementalVertexPointer, 3> corners, PlanePointer plane, FaceOrigin origin)
    : corners_(std::move(corners)), plane_(std::move(plane)), origin_(std::move(origin)) {
  for (const IncrementalVertexPointer& c : corners_) box_.include(c->at);
  determinant_ = dot<DoubleDouble>(place(*corners_[0]), cross<DoubleDouble>(place(*corners_[1]), place(*corners_[2])));
}

FaceTree::FaceTree(std::vector<WorkFace> faces) : root_(faces.empty() ? nullptr : build(std::move(faces))) {}

std::size_t FaceTree::size() const { return root_ == nullptr ? 0 : root_->count; }
Box FaceTree::bounds() const { return root_ == nullptr ? Box() : root_->box; }
DoubleDouble FaceTree::determinant() const { return root_ == nullptr ? DoubleDouble() : root_->determinant; }

FaceTree FaceTree::with(std::vector<FaceChange> changes) const {
  std::vector<const WorkFace*> removed;
  std::vector<Box> regions;
  for (const FaceChange& change : changes) {
    if (change.removed.empty()) continue;
    regions.emplace_back();
    for (const WorkFace* f : change.removed) regions.back().include(f->box());
    removed.insert(removed.end(), change.removed.begin(), change.removed.end());
  }
  std::sort(removed.begin(), removed.end(), std::less<>());
  NodePointer root = removed.empty() || root_ == nullptr ? root_ : without(root_, regions, removed);
  for (FaceChange& change : changes)
    if (!change.added.empty()) root = root == nullptr ? build(std::move(change.added)) : with_faces(root, change.added);
  return FaceTree(std::move(root));
}

FaceTree::NodePointer FaceTree::leaf(std::vector<WorkFace> faces) {
  auto node = std::make_shared<Node>();
  node->count = faces.size();
  for (const WorkFace& f : faces) {
    node->box.include(f.box());
    node->determinant = node->determinant + f.determinant();
  }
  node->faces = std::move(faces);
  return node;
}

FaceTree::NodePointer FaceTree::inner(NodePointer a, NodePointer b) {
  auto node = std::make_shared<Node>();
  node->count = a->count + b->count;
  node->box = a->box;
  node->box.include(b->box);
  node->determinant = a->determinant + b->determinant;
  node->children = {std::move(a), std::move(b)};
  return node;
}

FaceTree::NodePointer FaceTree::build(std::vector<WorkFace> faces) {
  if (faces.size() <= most_in_leaf) return leaf(std::move(faces));
  std::vector<std::uint32_t> order(faces.size());
  std::iota(order.begin(), order.end(), 0u);
  return build(faces, order);
}

/// A tree of the faces that `order` lists, halved along the axis along which they extend most.
FaceTree::NodePointer FaceTree::build(std::span<WorkFace> faces, std::span<std::uint32_t> order) {
  if (order.size() <= most_in_leaf) {
    std::vector<WorkFace> taken;
    taken.reserve(order.size());
    for (const std::uint32_t i : order) taken.push_back(std::move(faces[i]));
    return leaf(std::move(taken));
  }
  Box middles;
  for (const std::uint32_t i : order)
    middles.include(std::array{middle(faces[i], 0), middle(faces[i], 1), middle(faces[i], 2)});
  const std::size_t axis = longest_axis(middles), half = order.size() / 2;
  std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(half), order.end(),
                   [&](std::uint32_t i, std::uint32_t k) {
                     return std::pair(middle(faces[i], axis), i) < std::pair(middle(faces[k], axis), k);
                   });
  NodePointer lower, upper;
  do_both(
      order.size(), [&] { lower = build(faces, order.first(half)); },
      [&] { upper = build(faces, order.subspan(half)); });
  return inner(std::move(lower), std::move(upper));
}

FaceTree::NodePointer FaceTree::without(const NodePointer& node, std::span<const Box> regions,
                                        std::span<const WorkFace* const> removed) {
  const auto is_near = [&](const Box& region) { return node->box.overlaps(region); };
  if (std::none_of(regions.begin(), regions.end(), is_near)) return node;
  if (node->children[0] == nullptr) {
    const auto stays = [&](const WorkFace& f) {
      return !std::binary_search(removed.begin(), removed.end(), &f, std::less<>());
    };
    std::vector<WorkFace> left;
    std::copy_if(node->faces.begin(), node->faces.end(), std::back_inserter(left), stays);
    if (left.size() == node->faces.size()) return node;
    return left.empty() ? nullptr : leaf(std::move(left));
  }
  NodePointer a, b;
  do_both(
      node->count, [&] { a = without(node->children[0], regions, removed); },
      [&] { b = without(node->children[1], regions, removed); });
  if (a == node->children[0] && b == node->children[1]) return node;
  if (a == nullptr || b == nullptr) return a == nullptr ? b : a;
  return inner(std::move(a), std::move(b));
}

FaceTree::NodePointer FaceTree::with_faces(const NodePointer& node, std::span<WorkFace> added) {
  if (added.empty()) return node;
  const auto rebuilt = [&] {
    std::vector<WorkFace> all;
    all.reserve(node->count + added.size());
    visit_node(
        *node, [](const Box&) { return true; }, [&](const WorkFace& f) { all.push_back(f); });
    all.insert(all.end(), std::make_move_iterator(added.begin()), std::make_move_iterator(added.end()));
    return build(std::move(all));
  };
  if (node->children[0] == nullptr || added.size() > node->count) return rebuilt();
  const auto &a = node->children[0], &b = node->children[1];
  const auto first_of_b = std::stable_partition(added.begin(), added.end(), [&](const WorkFace& f) {
    const Box& box = f.box();
    const double to_a = growth(a->box, box), to_b = growth(b->box, box);
    return to_a < to_b || (to_a == to_b && a->count <= b->count);
  });
  const auto to_a = static_cast<std::size_t>(first_of_b - added.begin());
  const std::size_t of_a = a->count + to_a, all = node->count + added.size();
  if (static_cast<double>(std::max(of_a, all - of_a)) > balance * static_cast<double>(all)) return rebuilt();
  NodePointer lower, upper;
  do_both(
      added.size(), [&] { lower = with_faces(a, added.first(to_a)); },
      [&] { upper = with_faces(b, added.subspan(to_a)); });
  return inner(std::move(lower), std::move(upper));
}

}  // namespace strata
