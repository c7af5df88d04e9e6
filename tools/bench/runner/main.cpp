// strata-benchmark-runner: executes the requests of a public benchmark of Booleans, by its protocol; see runner.yaml.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "case_run.h"
#include "strata/options.h"
#include "strata/version.h"

namespace bench {
namespace {

using nlohmann::json;

constexpr std::chrono::seconds between_writes{10};

std::string version() {
  return std::to_string(STRATA_VERSION_MAJOR) + '.' + std::to_string(STRATA_VERSION_MINOR) + '.' +
         std::to_string(STRATA_VERSION_PATCH);
}

json read_request(const std::string& path) {
  std::ifstream stream(path);
  if (!stream) throw std::runtime_error(path + " cannot be read");
  json request = json::parse(stream);
  const json kind = request.value("kind", json()), version = request.value("version", json());
  if (kind != "boolean-benchmark" || version != 1)
    throw std::runtime_error(path + " is a request of kind " + kind.dump() + ", version " + version.dump() +
                             "; boolean-benchmark of version 1 is known");
  return request;
}

/// As a whole or not at all: whoever stops this program finds what was done before.
void write_result(const json& result, const std::string& path) {
  const std::string unfinished = path + ".tmp";
  {
    std::ofstream stream(unfinished);
    stream << result.dump(1) << '\n';
    if (!stream.flush()) throw std::runtime_error(unfinished + " cannot be written");
  }
  std::filesystem::rename(unfinished, path);
}

/// Did all runs succeed?
bool answer(const std::string& request_file, const std::string& result_file, const strata::Options& options) {
  const json request = read_request(request_file);
  json result = {
      {"kind", request.at("kind")}, {"version", request.at("version")}, {"id", request.value("id", json())},
      {"strata", version()},        {"threads", options.threads},       {"input", strata::name(options.input)},
      {"runs", json::array()}};
  bool all_succeeded = true;
  auto written = std::chrono::steady_clock::now();
  for (const json& run : request.at("runs")) {
    result["runs"].push_back(execute(run, options));
    const json& done = result["runs"].back();
    all_succeeded = all_succeeded && done.at("status") == "success";
    std::cerr << done.at("case_id").get<std::string>() << ": " << done.at("status").get<std::string>() << '\n';
    if (std::chrono::steady_clock::now() - written < between_writes) continue;
    write_result(result, result_file);
    written = std::chrono::steady_clock::now();
  }
  write_result(result, result_file);
  return all_succeeded;
}

int work(int argc, char** argv) {
  CLI::App app("Executes the requests of a benchmark of Booleans", "strata-benchmark-runner");
  std::string request_file;
  std::string result_file;
  strata::Options options;
  std::map<std::string, strata::InputClass> classes;
  for (const strata::InputClass input : strata::all_input_classes) classes.emplace(name(input), input);
  app.add_option("--request", request_file, "What is to be done")->required()->check(CLI::ExistingFile);
  app.add_option("--result", result_file, "Where the answer goes")->required();
  app.add_option("--threads", options.threads, "0: as many as there are processors")->capture_default_str();
  app.add_option("--input", options.input, "What is expected of meshes: automatic, solid, overlapping, repair or soup")
      ->transform(CLI::Transformer(classes))
      ->default_str("automatic");
  CLI11_PARSE(app, argc, argv);
  return answer(request_file, result_file, options) ? 0 : 1;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  try {
    return bench::work(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "strata-benchmark-runner: " << error.what() << '\n';
    return 1;
  }
}
