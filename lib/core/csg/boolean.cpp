#include "core/csg/boolean.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/csg/broken_operands.h"
#include "core/csg/measures.h"
#include "core/csg/prepared_operands.h"
#include "core/csg/round_to_solid.h"
#include "core/csg/stopwatch.h"
#include "core/kernel/counters.h"
#include "core/mesh/equal_vertices.h"
#include "core/mesh/prepare.h"
#include "core/overlap/candidates.h"
#include "core/overlap/embedded_stars.h"
#include "core/overlap/intersect.h"
#include "core/overlap/self_intersections.h"
#include "core/overlap/shells.h"
#include "core/round/rounding.h"
#include "core/select/extract.h"
#include "core/select/hidden_faces.h"
#include "core/select/label.h"
#include "core/select/sheet_windings.h"
#include "core/select/subdivide.h"
#include "core/winding/local_windings.h"
#include "core/winding/ray_windings.h"

namespace strata {
namespace {

/// Records the time of each stage at its end, reports progress, throws Cancelled on request.
class Stages {
 public:
  Stages(Profile& profile, const Monitor& monitor) : profile_(profile), watch_(profile), monitor_(monitor) {
    monitor.check();
  }
  [[nodiscard]] Profile& profile() { return profile_; }

  void end(const char* stage, double progress) {
    watch_.lap(stage);
    monitor_.report(progress);
    monitor_.check();
  }

 private:
  Profile& profile_;
  Stopwatch watch_;
  const Monitor& monitor_;
};

void count(const Candidates& candidates, Profile& profile) {
  profile.counts.emplace_back("cells", candidates.cells().cells().size());
}

void count(const Intersections& intersections, Profile& profile) {
  profile.counts.emplace_back("pairs_tested", intersections.pairs_tested);
  profile.counts.emplace_back("pairs_meeting", intersections.pairs_meeting);
}

void count(const Subdivision& subdivision, Profile& profile) {
  std::size_t pieces = 0;
  for (const SubdividedFace& face : subdivision.faces) pieces += face.triangles.size();
  profile.counts.emplace_back("points", subdivision.points.end() - subdivision.points.first());
  profile.counts.emplace_back("subdivided_faces", subdivision.faces.size());
  profile.counts.emplace_back("pieces", pieces);
}

/// Adds the number of decisions per tier since `before` to the profile.
void count_tiers(const TierCounts& before, Profile& profile) {
  const TierCounts now = tier_counts_now();
  for (std::size_t i = 0; i < now.size(); ++i)
    if (now[i] != before[i]) profile.counts.emplace_back(tier_names[i], now[i] - before[i]);
}

void put_measures(Measures measures, BooleanResult& result) {
  result.measured = {result.mesh.vertices.size(), result.mesh.triangles.size(), std::move(measures)};
}

/// The last stages.
BooleanResult finished(const InputComplex& input, const std::vector<Verdict>& verdicts, Subdivision subdivision,
                       const Options& options, const Monitor& monitor, Stages& stages) {
  BooleanResult result;
  Boundary boundary = extract(input, verdicts, std::move(subdivision), monitor);
  stages.end("extract", 0.9);
  if (!chain_is_closed(MeshView({}, boundary.triangles))) throw LogicError("the boundary of a result is not closed");
  stages.end("validate", 0.92);

  result.mesh.vertices = round_to_doubles(input, boundary, monitor);
  if (options.exact_vertices) result.exact = exact_positions(input, boundary, result.mesh.vertices, monitor);
  result.mesh.triangles = std::move(boundary.triangles);
  result.sources = std::move(boundary.sources);
  if (options.exact_vertices) {
    if (options.measure) put_measures(measures_of({result.mesh, result.exact}, Facets::count, monitor), result);
  } else if (options.rounding || options.measure) {
    const NearestMesh nearest{result.mesh, rounded_vertices(input, boundary, result.mesh.vertices, monitor),
                              [&](std::uint32_t a, std::uint32_t b) { return are_equal(input, boundary, a, b); }};
    if (options.measure) put_measures(measures_of(input, boundary, nearest, result.sources, monitor), result);
    if (options.rounding) round_result(nearest, options, monitor, result);
  }
  return result;
}

/// Without what hidden faces of solids have in common.
Intersections intersections_for(const Rule& rule, const Candidates& candidates, const Monitor& monitor) {
  if (candidates.input().may_self_intersect()) return intersect(candidates, monitor);
  std::vector<PairIntersections> met = meet_faces_in_general(candidates, monitor);
  std::vector<std::uint32_t> hidden = find_hidden_faces(candidates.input(), met, rule, monitor);
  return intersect(candidates.input(), std::move(met), std::move(hidden), monitor);
}

/// The stages after `prepare`, by cells.
BooleanResult evaluate_in_cells(const Rule& rule, InputComplex complex, const Options& options, const Monitor& monitor,
                                Stages& stages) {
  Candidates candidates = find_candidates(std::move(complex), monitor);
  const InputComplex& input = candidates.input();
  count(candidates, stages.profile());
  stages.end("find_candidates", 0.3);

  Intersections intersections = intersections_for(rule, candidates, monitor);
  count(intersections, stages.profile());
  stages.end("intersect", 0.55);

  const LocalWindings windings(input, candidates.cells());
  const Classifier classifier{rule, windings};
  Subdivision subdivision = subdivide(input, std::move(intersections), classifier, monitor);
  count(subdivision, stages.profile());
  stages.end("subdivide", 0.8);

  const std::vector<Verdict> verdicts = label(input, subdivision, classifier, monitor);
  const std::unique_ptr<const InputComplex> kept = Candidates::without_cells(std::move(candidates));
  stages.end("label", 0.85);
  return finished(*kept, verdicts, std::move(subdivision), options, monitor, stages);
}

/// Winding numbers at a point of each of some faces: by rays, or by cells where these cost less.
class WindingsAsked {
 public:
  WindingsAsked(const InputComplex& input, const std::vector<std::uint32_t>& asked, const Monitor& monitor) {
    auto rays = std::make_unique<RayWindings>(input, asked);
    // Of a face near a ray, measured in instructions: cells take 34 times as much to make for each face of the mesh,
    // and 380 times as much for a point.
    if (rays->comparisons() < 380 * asked.size() + std::size_t{34} * input.face_count()) {
      oracle_ = std::move(rays);
      return;
    }
    candidates_.emplace(find_candidates(input, monitor));
    oracle_ = std::make_unique<LocalWindings>(candidates_->input(), candidates_->cells());
  }
  [[nodiscard]] const WindingOracle& oracle() const { return *oracle_; }

 private:
  std::optional<Candidates> candidates_;
  std::unique_ptr<const WindingOracle> oracle_;
};

/// The stages after `prepare` for one mesh whose crossings are known: points are decided for whole patches.
BooleanResult evaluate_in_patches(const Rule& rule, const InputComplex& input, SelfCrossings crossings,
                                  const Options& options, const Monitor& monitor, Stages& stages) {
  Intersections intersections = intersect(input, crossings.met, monitor);
  crossings.met = {};
  count(intersections, stages.profile());
  stages.end("intersect", 0.55);

  std::vector<bool> crossing(input.face_count(), false);
  for (const SelfIntersection& p : crossings.pairs) crossing[p.face] = crossing[p.other] = true;
  const Shells patches = find_patches(input, crossings.stars, crossing);
  Sheets sheets(input, crossings.stars, patches, intersections.constraints);
  const WindingsAsked windings(input, sheets.asked(input), monitor);
  const SheetWindings above(input, std::move(sheets), windings.oracle(), monitor);
  const Classifier classifier{rule, windings.oracle(), &above};
  Subdivision subdivision = subdivide(input, std::move(intersections), classifier, monitor);
  count(subdivision, stages.profile());
  stages.end("subdivide", 0.8);

  const std::vector<Verdict> verdicts = label(input, subdivision, rule, above);
  stages.end("label", 0.85);
  return finished(input, verdicts, std::move(subdivision), options, monitor, stages);
}

/// Where faces of one mesh intersect, if few of them do.
KnownCrossings find_few_crossings(const InputComplex& mesh, const Monitor& monitor) {
  const std::size_t enough = mesh.face_count() / 8 + 1;
  SelfCrossings crossings{EmbeddedStars(mesh, monitor), {}, {}};
  crossings.pairs = find_self_intersections(mesh, &crossings.stars, monitor, enough, &crossings.met);
  if (crossings.pairs.size() >= enough) return std::nullopt;
  return crossings;
}

/// One mesh of doubles, each vertex of which is the first of those in its place.
class WeldedMesh {
 public:
  explicit WeldedMesh(const InputComplex& mesh) : welded_(ExactMeshView({mesh.points(0), mesh.faces(0)}, {})) {
    const std::optional<Box> bounds = mesh.bounds(0) != nullptr ? std::optional(*mesh.bounds(0)) : std::nullopt;
    complex_.add(mesh.points(0), welded_.triangles(), {}, bounds);
  }
  [[nodiscard]] const InputComplex& complex() const { return complex_; }

 private:
  OnFirstVertices welded_;
  InputComplex complex_{SelfIntersections::possible};
};

BooleanResult evaluate(const Rule& rule, InputComplex complex, KnownCrossings known, const Options& options,
                       const Monitor& monitor, Stages& stages) {
  if (complex.operand_count() == 1 && complex.may_self_intersect() && rule.looks_around() && !complex.has_rationals() &&
      !complex.has_planes()) {
    const WeldedMesh mesh(complex);
    if (!known) known = find_few_crossings(mesh.complex(), monitor);
    stages.end("find_candidates", 0.3);
    if (known) return evaluate_in_patches(rule, mesh.complex(), *std::move(known), options, monitor, stages);
  }
  return evaluate_in_cells(rule, std::move(complex), options, monitor, stages);
}

}  // namespace

BooleanResult boolean(const Rule& rule, std::span<const Operand> given, const Options& options, KnownOperands known) {
  Profile profile;
  const Monitor monitor(options.cancel, &options.progress);
  const TierCounts tiers = tier_counts_now();
  Stages stages(profile, monitor);

  const PreparedOperands operands(given, options, std::move(known.prepared));
  stages.end("prepare", 0.05);

  BooleanResult result = refusing_broken_operands(given, options, [&] {
    return evaluate(rule, operands.complex(), std::move(known.crossings), options, monitor, stages);
  });
  operands.restore(result.sources);
  count_tiers(tiers, profile);
  stages.end("round", 1);
  result.notes = operands.notes();
  result.profile = std::move(profile);
  return result;
}

BooleanResult resolved(InputComplex input, Inside inside, const Monitor& monitor) {
  Options options;
  options.exact_vertices = true;
  Profile profile;
  Stages stages(profile, monitor);
  return evaluate(Rule::of_one(inside), std::move(input), {}, options, monitor, stages);
}

}  // namespace strata
