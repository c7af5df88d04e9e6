#include "case_run.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "slot.h"
#include "steps.h"
#include "strata/errors.h"
#include "strata/io.h"
#include "strata/rounding.h"

namespace bench {
namespace {

using nlohmann::json;
using strata::Operation;

class Stopwatch {
 public:
  [[nodiscard]] double milliseconds() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The request asks for something that this runner does not know.
class Unsupported : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

bool is_boolean(const json& operation) { return operation.at("op").get<std::string>().starts_with("boolean-"); }

Operation boolean_of(const std::string& name) {
  if (name == "boolean-union") return Operation::union_;
  if (name == "boolean-intersection") return Operation::intersection;
  if (name == "boolean-difference") return Operation::difference;
  throw Unsupported("There is no operation " + name + ".");
}

/// The slots that an operation names; each is of an operation before it.
std::vector<std::size_t> operands_of(const json& operation, std::size_t before) {
  auto operands = operation.at("args").get<std::vector<std::size_t>>();
  if (operands.empty()) throw std::invalid_argument("A Boolean without operands.");
  for (const std::size_t operand : operands)
    if (operand >= before) throw std::invalid_argument("Operand " + std::to_string(operand) + " does not exist yet.");
  return operands;
}

class Run {
 public:
  Run(const json& run, const strata::Options& options)
      : operations_(run.at("operations")), folder_(run.at("out_dir").get<std::string>()), options_(options) {
    std::filesystem::create_directories(folder_);
    chains_ = chain_lengths(operations_);
  }

  /// Appends to `answers` what each operation gave. Returns the status of all.
  std::string execute(json& answers) {
    for (const json& operation : operations_) {
      json answer = {{"status", "success"}};
      const Stopwatch all;
      try {
        apply(operation, answer);
      } catch (const Unsupported& error) {
        fail(answer, "unsupported", error.what());
      } catch (const strata::LogicError& error) {
        fail(answer, "crash", error.what());
      } catch (const std::bad_alloc&) {
        fail(answer, "crash", "Out of memory.");
      } catch (const std::exception& error) {
        fail(answer, "invalid_input", error.what());
      }
      answer["total_ms"] = all.milliseconds();
      answers.push_back(answer);
      if (answer["status"] != "success") return answer["status"];
    }
    return "success";
  }

 private:
  static void fail(json& answer, const char* status, const std::string& why) {
    answer["status"] = status;
    answer["error"] = why;
  }

  void apply(const json& operation, json& answer) {
    if (operation.at("op") == "load-mesh")
      load(operation.at("path").get<std::string>(), answer);
    else
      combine(boolean_of(operation.at("op")), operands_of(operation, slots_.size()), answer);
  }

  void load(const std::string& path, json& answer) {
    const Stopwatch reading;
    const strata::MeshFile file = strata::read_mesh(path);
    answer["io_ms"] = reading.milliseconds();
    const Stopwatch importing;
    slots_.emplace_back(strata::Solid(file.mesh, options_));
    answer["import_ms"] = importing.milliseconds();
    write(file.mesh, answer);
  }

  void combine(Operation operation, std::span<const std::size_t> operands, json& answer) {
    const Stopwatch combining;
    Slot result = combined(operation, operands);
    answer["operation_ms"] = combining.milliseconds();
    const Stopwatch exporting;
    const strata::RoundedMesh rounded = strata::round_to_solid(result.solid(options_).exact_mesh(), {}, options_);
    answer["export_ms"] = exporting.milliseconds();
    slots_.push_back(std::move(result));
    write(rounded.mesh, answer);
  }

  /// Of one operand: itself, since what crossed itself was resolved when it was loaded.
  Slot combined(Operation operation, std::span<const std::size_t> operands) {
    if (operands.size() == 1) return slots_[operands.front()];
    std::vector<strata::Solid> tools;
    for (const std::size_t tool : operands.subspan(1)) tools.push_back(slots_[tool].solid(options_));
    if (chains_[slots_.size()] > few_steps)
      return Slot(slots_[operands.front()].incremental().with(operation, tools, options_));
    tools.insert(tools.begin(), slots_[operands.front()].solid(options_));
    return Slot(strata::combine_solids(operation, tools, options_));
  }

  void write(const strata::Mesh& mesh, json& answer) const {
    const std::filesystem::path file = folder_ / ("op_" + std::to_string(slots_.size() - 1) + ".obj");
    strata::write_mesh(file, strata::MeshView(mesh));
    answer["file"] = file.string();
  }

  const json& operations_;
  std::filesystem::path folder_;
  strata::Options options_;
  std::vector<std::size_t> chains_;
  std::vector<Slot> slots_;
};

}  // namespace

std::vector<std::size_t> chain_lengths(const json& operations) {
  const std::size_t none = operations.size();
  std::vector<std::size_t> first(none, none), lengths(none, 0);
  for (std::size_t i = 0; i < none; ++i) {
    if (!is_boolean(operations[i])) continue;
    first[i] = operands_of(operations[i], i).front();
    lengths[i] = lengths[first[i]] + 1;
  }
  for (std::size_t i = none; i-- > 0;)
    if (first[i] != none && lengths[first[i]] > 0) lengths[first[i]] = std::max(lengths[first[i]], lengths[i]);
  return lengths;
}

json execute(const json& run, const strata::Options& options) {
  const Stopwatch all;
  json answer = {{"case_id", run.value("case_id", "")}};
  json operations = json::array();
  try {
    answer["status"] = Run(run, options).execute(operations);
  } catch (const std::exception& error) {  // the run itself means nothing
    answer["status"] = "invalid_input";
    answer["error"] = error.what();
  }
  answer["ops"] = std::move(operations);
  answer["duration_ms"] = all.milliseconds();
  return answer;
}

}  // namespace bench
