// strata-bench: makes cases, measures the library on them, judges anyone's results. tools/bench/run drives it.
#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "case_file.h"
#include "cases.h"
#include "copy_floor.h"
#include "judge.h"
#include "measure.h"
#include "request.h"
#include "steps.h"
#include "strata/check.h"
#include "strata/combine.h"
#include "strata/incremental.h"
#include "strata/io.h"
#include "strata/resolve.h"
#include "strata/section.h"
#include "strata/solid.h"

namespace bench {
namespace {

using nlohmann::json;
using strata::Mesh;
using strata::MeshView;

void list_cases() {
  json list = json::array();
  for (const Case& c : all_cases()) {
    list.push_back({{"name", c.name},
                    {"about", c.about},
                    {"group", name(c.group)},
                    {"operation", name(c.operation)},
                    {"one_by_one", c.group == Group::one_by_one || c.group == Group::slow},
                    {"from_corpus", c.from_corpus},
                    {"volume", c.volume ? json(*c.volume) : json()}});
  }
  std::cout << list.dump(1) << '\n';
}

void make_case(const std::string& name, const std::string& file) {
  const std::vector<Mesh> meshes = case_named(name).make(Corpus());
  write_case(file, meshes);
  json operands = json::array();
  std::size_t triangles = 0;
  for (const Mesh& mesh : meshes) triangles += mesh.triangles.size();
  std::cout << json{{"operands", meshes.size()}, {"triangles", triangles}}.dump() << '\n';
}

/// The smallest box of what is loaded, for engines that want one.
json bounding_box(std::span<const Mesh> meshes) {
  strata::Vertex lower{}, upper{};
  bool is_first = true;
  for (const Mesh& mesh : meshes)
    for (const strata::Vertex& v : mesh.vertices) {
      for (std::size_t k = 0; k < 3; ++k) {
        lower[k] = is_first ? v[k] : std::min(lower[k], v[k]);
        upper[k] = is_first ? v[k] : std::max(upper[k], v[k]);
      }
      is_first = false;
    }
  return {{"min", lower}, {"max", upper}};
}

/// A case as a request of the benchmark whose protocol strata-benchmark-runner has: OBJ files, and request.json, which
/// loads them and takes one step after the other.
void write_request(const std::string& name, const std::string& folder) {
  const Case& c = case_named(name);
  const std::filesystem::path place = std::filesystem::absolute(folder);
  std::filesystem::create_directories(place / "out");
  const std::vector<Mesh> meshes = c.make(Corpus());
  json operations = json::array();
  for (const Mesh& mesh : meshes) {
    const std::string file = "mesh_" + std::to_string(operations.size()) + ".obj";
    strata::write_mesh(place / file, MeshView(mesh));
    operations.push_back({{"op", "load-mesh"}, {"path", (place / file).string()}, {"name", file}});
  }
  std::size_t whole = 0;
  for (std::size_t k = 1; k < meshes.size(); ++k) {
    operations.push_back({{"op", std::string("boolean-") + strata::name(c.operation)}, {"args", {whole, k}}});
    whole = operations.size() - 1;
  }
  const json run = {{"case_id", name},
                    {"out_dir", (place / "out").string()},
                    {"bounding_box", bounding_box(meshes)},
                    {"operations", operations}};
  std::ofstream(place / "request.json")
      << json{{"kind", "boolean-benchmark"}, {"version", 1}, {"id", name}, {"runs", json::array({run})}}.dump(1)
      << '\n';
}

/// The mesh of a file as a case: other engines get the triangles that Strata reads.
void read_mesh_file(const std::string& from, const std::string& file) {
  const Mesh mesh = strata::read_mesh(from).mesh;
  write_case(file, {&mesh, 1});
  std::cout << json{{"operands", 1}, {"triangles", mesh.triangles.size()}}.dump() << '\n';
}

/// The result of the last run, and what is known about it.
struct Outcome {
  strata::BooleanResult result;
  strata::Solid solid;  ///< one by one
};

Subject all_at_once(const Request& request, std::span<const MeshView> operands, Outcome& outcome) {
  const strata::Options options{.input = request.input, .threads = request.threads};
  return {[&outcome] { outcome = {}; },
          [&outcome, &request, operands, options] {
            outcome.result = strata::combine(request.operation, operands, options);
          }};
}

strata::Solid steps_of_solids(const Request& request, std::span<const Mesh> operands, const strata::Options& options) {
  strata::Solid whole(operands.front(), request.input);
  for (const Mesh& mesh : operands.subspan(1))
    whole = strata::combine_solids(request.operation, std::array{whole, strata::Solid(mesh, request.input)}, options);
  return whole;
}

strata::Solid incremental_steps(const Request& request, std::span<const Mesh> operands,
                                const strata::Options& options) {
  strata::IncrementalSolid whole{strata::Solid(operands.front(), request.input)};
  for (const Mesh& mesh : operands.subspan(1))
    whole = whole.with(request.operation, strata::Solid(mesh, request.input), options);
  return whole.solid(options);
}

/// Arrays are copied into solids, the result stays exact from step to step.
Subject one_by_one(const Request& request, std::span<const Mesh> operands, Outcome& outcome) {
  const strata::Options options{.input = request.input, .threads = request.threads};
  const bool are_few = operands.size() <= few_steps + 1;
  return {[&outcome] { outcome = {}; },
          [&outcome, &request, operands, options, are_few] {
            outcome.solid =
                are_few ? steps_of_solids(request, operands, options) : incremental_steps(request, operands, options);
          }};
}

/// Does the first mesh intersect itself? Arrays in, answer out.
void test_embedding(const Request& request) {
  const Mesh mesh = read_case(request.case_file).front();
  const strata::Options options{.threads = request.threads};
  bool embedded = false;
  const Measurement measurement = measure({[] {}, [&] { embedded = strata::is_embedded(mesh, options); }}, request);
  json answer = to_json(measurement);
  answer["threads"] = request.threads;
  answer["triangles"] = mesh.triangles.size();
  answer["embedded"] = embedded;
  std::cout << answer.dump() << '\n';
}

/// The first mesh, resolved: from arrays to a solid, of which the exact vertices are known as well.
void resolve_case(const Request& request, strata::Inside inside) {
  const Mesh mesh = read_case(request.case_file).front();
  const strata::Options options{.input = request.input, .threads = request.threads};
  strata::Solid solid;
  const Measurement measurement = measure({[&] { solid = {}; },
                                           [&] {
                                             solid = strata::resolve(strata::ExactMesh{mesh, {}}, inside, options);
                                           }},
                                          request);
  json answer = to_json(measurement);
  answer["threads"] = request.threads;
  answer["triangles"] = solid.mesh().triangles.size();
  answer["vertices"] = solid.mesh().vertices.size();
  if (!request.result_file.empty()) write_case(request.result_file, {&solid.mesh(), 1});
  std::cout << answer.dump() << '\n';
}

/// The first mesh in planes a step apart from its lowest point on: from a solid that is made before to all regions.
void slice_case(const Request& request, std::size_t planes) {
  const strata::Solid solid(read_case(request.case_file).front(), request.input);
  const strata::BoundingBox box = solid.bounding_box();
  const double step = (box.upper[2] - box.lower[2]) / static_cast<double>(planes);
  std::vector<double> heights;
  for (std::size_t k = 0; k < planes; ++k) heights.push_back(box.lower[2] + step * static_cast<double>(k));
  const strata::Options options{.threads = request.threads};
  std::vector<strata::planar::Region> regions;
  const Measurement measurement =
      measure({[&] { regions = {}; }, [&] { regions = strata::slice(solid, 2, heights, options); }}, request);
  std::size_t vertices = 0;
  for (const strata::planar::Region& region : regions) vertices += region.loops.vertices.size();
  json answer = to_json(measurement);
  answer["threads"] = request.threads;
  answer["planes"] = planes;
  answer["vertices"] = vertices;
  std::cout << answer.dump() << '\n';
}

json stages_of(const strata::Profile& profile) {
  json stages = json::object();
  for (const auto& [stage, seconds] : profile.seconds) stages[stage] = stages.value(stage, 0.0) + seconds;
  return stages;
}

json counts_of(const strata::Profile& profile) {
  json counts = json::object();
  for (const auto& [what, count] : profile.counts) counts[what] = count;
  return counts;
}

void run_case(const Request& request) {
  const std::vector<Mesh> meshes = read_case(request.case_file);
  std::vector<MeshView> arrays(meshes.begin(), meshes.end());
  Outcome outcome;
  const Measurement measurement = measure(
      request.one_by_one ? one_by_one(request, meshes, outcome) : all_at_once(request, arrays, outcome), request);
  const Mesh& result = request.one_by_one ? outcome.solid.mesh() : outcome.result.mesh;
  const std::size_t sources = request.one_by_one ? outcome.solid.sources().size() : outcome.result.sources.size();
  arrays.push_back(result);

  json answer = to_json(measurement);
  answer["threads"] = request.threads;
  answer["triangles"] = result.triangles.size();
  answer["vertices"] = result.vertices.size();
  answer["output_bytes"] = array_bytes(result) + sources * sizeof(strata::Source);
  answer["copy_floor"] = copy_floor(arrays);
  answer["stages"] = stages_of(outcome.result.profile);  // of the last repetition
  answer["counts"] = counts_of(outcome.result.profile);
  if (!request.result_file.empty()) write_case(request.result_file, {&result, 1});
  std::cout << answer.dump() << '\n';
}

void judge_file(const std::string& file) {
  const std::vector<Mesh> meshes = read_case(file);
  if (meshes.size() != 1) throw std::runtime_error(file + " is no result: not one mesh");
  const Verdict verdict = judge(meshes.front());
  std::cout << json{{"well_formed", verdict.well_formed},
                    {"closed", verdict.closed},
                    {"volume", verdict.volume},
                    {"vertices", verdict.vertices},
                    {"triangles", verdict.triangles}}
                   .dump()
            << '\n';
}

}  // namespace
}  // namespace bench

// The one function whose instructions are counted; by this name the counting tool finds it.
extern "C" [[gnu::noinline]] void strata_bench_counted(strata::Operation operation,
                                                       const std::vector<strata::MeshView>& operands,
                                                       strata::BooleanResult& result) {
  result = strata::combine(operation, operands, {.input = strata::InputClass::solid, .threads = 1});
}

namespace bench {
namespace {

/// Once to warm up, uncounted; then once to be counted, from arrays in memory that are the same in every run.
void count_case(const std::string& name) {
  const Case& c = case_named(name);
  const std::vector<Mesh> meshes = c.make(Corpus());
  const std::vector<MeshView> operands(meshes.begin(), meshes.end());
  strata::BooleanResult result =
      strata::combine(c.operation, operands, {.input = strata::InputClass::solid, .threads = 1});
  strata_bench_counted(c.operation, operands, result);
  std::cout << json{{"triangles", result.mesh.triangles.size()}, {"closed", judge(result.mesh).closed}}.dump() << '\n';
}

int work(int argc, char** argv) {
  CLI::App app("Measures Strata; tools/bench/run makes the whole table", "strata-bench");
  app.require_subcommand(1);
  app.add_subcommand("list", "All cases, as JSON")->callback(list_cases);

  std::string name;
  std::string file;
  CLI::App* make = app.add_subcommand("make", "Writes a case file; those of real meshes need STRATA_CORPUS");
  make->add_option("NAME", name)->required();
  make->add_option("FILE", file)->required();
  make->callback([&] { make_case(name, file); });

  CLI::App* asking = app.add_subcommand("request", "Writes a case as a request to strata-benchmark-runner");
  asking->add_option("NAME", name)->required();
  asking->add_option("FOLDER", file)->required();
  asking->callback([&] { write_request(name, file); });

  std::string from;
  CLI::App* reading = app.add_subcommand("read", "Writes a case file of one mesh file");
  reading->add_option("MESH", from)->required()->check(CLI::ExistingFile);
  reading->add_option("FILE", file)->required();
  reading->callback([&] { read_mesh_file(from, file); });

  Request request;
  CLI::App* run = app.add_subcommand("run", "Measures one operation on a case file; prints JSON");
  add_options(*run, request);
  run->callback([&] { run_case(request); });

  CLI::App* embedding = app.add_subcommand("embedded", "Measures the test of one mesh for self-intersections");
  add_options(*embedding, request);
  embedding->callback([&] { test_embedding(request); });

  strata::Inside inside = strata::Inside::winding;
  std::map<std::string, strata::Inside> insides;
  for (const strata::Inside each : strata::all_insides) insides.emplace(strata::name(each), each);
  CLI::App* resolving = app.add_subcommand("resolve", "Measures the resolution of one mesh that crosses itself");
  add_options(*resolving, request);
  resolving->add_option("--keep", inside, "winding, even-odd or outer")
      ->transform(CLI::Transformer(insides))
      ->default_str("winding");
  resolving->callback([&] { resolve_case(request, inside); });

  std::size_t planes = 1000;
  CLI::App* slicing = app.add_subcommand("slice", "Measures sections of one mesh by planes a step apart");
  add_options(*slicing, request);
  slicing->add_option("--planes", planes, "how many")->capture_default_str()->check(CLI::PositiveNumber);
  slicing->callback([&] { slice_case(request, planes); });

  CLI::App* judging = app.add_subcommand("judge", "Volume and closedness of a result; prints JSON");
  judging->add_option("FILE", file)->required();
  judging->callback([&] { judge_file(file); });

  CLI::App* count = app.add_subcommand("count", "Runs a case once, in strata_bench_counted(), for callgrind");
  count->add_option("NAME", name)->required();
  count->callback([&] { count_case(name); });
  CLI11_PARSE(app, argc, argv);
  return 0;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  try {
    return bench::work(argc, argv);
  } catch (const bench::MissingMesh& missing) {
    std::cerr << missing.what() << '\n';
    return 3;
  } catch (const std::exception& error) {
    std::cerr << "strata-bench: " << error.what() << '\n';
    return 1;
  }
}
