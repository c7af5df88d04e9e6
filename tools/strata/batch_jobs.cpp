#include "batch_jobs.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "common/json_location.h"
#include "common/sha256.h"
#include "core/system/decimal.h"
#include "strata/errors.h"

namespace {

double read_seconds(const JsonLocation& place) {
  const double seconds = place.value().is_number() ? place.value().get<double>() : 0;
  if (!(seconds > 0)) place.fail_expected("a positive number of seconds");
  return seconds;
}

std::uint64_t read_bytes(const JsonLocation& place) {
  const Json& value = place.value();
  const auto bytes = byte_count(value.is_string() ? value.get<std::string>() : value.is_number() ? value.dump() : "");
  if (!bytes) place.fail_expected("a number of bytes, as 1500000 or \"1.5G\"");
  return *bytes;
}

std::vector<std::string> read_arguments(const JsonLocation& place) {
  std::vector<std::string> arguments;
  for (const JsonLocation& item : place.items()) arguments.push_back(item.text());
  if (arguments.empty()) place.fail("a job needs a verb");
  if (arguments[0] == "batch") place.fail("a job cannot be a batch");
  return arguments;
}

BatchJob read_job(std::string_view text, std::size_t number, const std::string& name, const JobLimits& limits) {
  const std::string where = fmt::format("{}:{}", name, number);
  const Json json = parse_json_line(text, where);
  const JsonLocation root(json, where);
  root.expect_keys({"id", "args", "timeout", "memory"});
  BatchJob job;
  job.line = number;
  job.digest = sha256(text);
  job.limits = limits;
  job.arguments = read_arguments(root.at("args"));
  if (const auto id = root.find("id")) {
    if (!id->value().is_string() && !id->value().is_number_integer() && !id->value().is_null())
      id->fail_expected("a string or an integer");
    job.id = id->value();
  }
  if (const auto seconds = root.find("timeout")) job.limits.seconds = read_seconds(*seconds);
  if (const auto bytes = root.find("memory")) job.limits.bytes = read_bytes(*bytes);
  return job;
}

}  // namespace

std::string BatchJob::output() const {
  for (std::size_t k = 1; k < arguments.size(); ++k) {
    const std::string& word = arguments[k];
    if (word == "-o" || word == "--output") return k + 1 < arguments.size() ? arguments[k + 1] : "";
    if (word.starts_with("--output=")) return word.substr(9);
    if (word.starts_with("-o")) return word.substr(word.starts_with("-o=") ? 3 : 2);
  }
  return {};
}

std::vector<BatchJob> parse_batch_jobs(std::string_view text, const std::string& name, const JobLimits& limits) {
  std::vector<BatchJob> jobs;
  std::size_t number = 0;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    const std::string_view line = text.substr(start, end - start);
    start = end + 1;
    ++number;
    if (line.find_first_not_of(" \t\r") != line.npos) jobs.push_back(read_job(line, number, name, limits));
  }
  return jobs;
}

std::optional<std::uint64_t> byte_count(std::string_view text) {
  constexpr std::string_view units = "KMGT";
  double factor = 1;
  if (const std::size_t unit = text.empty() ? units.npos : units.find(text.back()); unit != units.npos) {
    factor = std::ldexp(1.0, 10 * static_cast<int>(unit + 1));
    text.remove_suffix(1);
  }
  double number = 0;
  const auto [end, error] = strata::system::from_chars(text.data(), text.data() + text.size(), number);
  const double bytes = std::floor(number * factor);
  if (error != std::errc{} || end != text.data() + text.size() || !(bytes >= 1) || bytes > 1e18) return {};
  return static_cast<std::uint64_t>(bytes);
}
