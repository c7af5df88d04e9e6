#include "request.h"

#include <map>

namespace bench {
namespace {

std::map<std::string, strata::Operation> operations() {
  std::map<std::string, strata::Operation> all;
  for (const strata::Operation operation : strata::all_operations) all.emplace(name(operation), operation);
  all.emplace("xor", strata::Operation::symmetric_difference);
  return all;
}

std::map<std::string, strata::InputClass> input_classes() {
  std::map<std::string, strata::InputClass> all;
  for (const strata::InputClass input : strata::all_input_classes) all.emplace(name(input), input);
  return all;
}

}  // namespace

void add_options(CLI::App& app, Request& request) {
  app.add_option("CASE", request.case_file, "A case file")->required()->check(CLI::ExistingFile);
  app.add_option("--operation", request.operation, "union, intersection, difference or symmetric-difference")
      ->transform(CLI::Transformer(operations()));
  app.add_option("--input", request.input, "automatic, solid, overlapping, repair or soup")
      ->transform(CLI::Transformer(input_classes()))
      ->default_str("solid");
  app.add_flag("--one-by-one", request.one_by_one, "Join operand after operand to the result so far");
  app.add_option("--threads", request.threads)->check(CLI::Range(1, 1024))->capture_default_str();
  app.add_option("--repetitions", request.repetitions, "After one to warm up")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--budget", request.budget, "Seconds after which no repetition begins")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--result", request.result_file, "Write the result here, as a case file of one mesh");
}

}  // namespace bench
