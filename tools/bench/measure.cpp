#include "measure.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double worth_a_batch = 1e-3;
constexpr double batch_seconds = 5e-3;
constexpr double small_warm_up_seconds = 50e-3;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Seconds per operation of `batch` operations.
double timed(const Subject& subject, unsigned batch) {
  subject.forget();
  const auto start = Clock::now();
  for (unsigned i = 0; i < batch; ++i) subject.run();
  return since(start) / batch;
}

/// How many operations to time together. The first small ones are slower: caches and allocators warm up.
unsigned choose_batch(const Subject& subject, double first) {
  if (first > small_warm_up_seconds) return 1;
  const auto start = Clock::now();
  double fastest = first;
  while (since(start) < small_warm_up_seconds) fastest = std::min(fastest, timed(subject, 1));
  if (fastest >= worth_a_batch) return 1;
  return static_cast<unsigned>(std::ceil(batch_seconds / std::max(fastest, 1e-6)));
}

}  // namespace

Measurement measure(const Subject& subject, const Request& request) {
  Measurement result;
  const auto start = Clock::now();
  const MemoryWatch memory;
  result.warm_up = timed(subject, 1);
  result.memory = memory.seen();
  result.batch = choose_batch(subject, result.warm_up);
  while (result.seconds.size() < request.repetitions && since(start) < request.budget) {
    result.seconds.push_back(timed(subject, result.batch));
  }
  result.warm_up_only = result.seconds.empty();
  if (result.warm_up_only) result.seconds.push_back(result.warm_up);
  return result;
}

nlohmann::json to_json(const Measurement& m) {
  return {{"seconds", m.seconds},
          {"median", median(m.seconds)},
          {"warm_up", m.warm_up},
          {"warm_up_only", m.warm_up_only},
          {"batch", m.batch},
          {"memory_before", m.memory.before},
          {"memory_peak", m.memory.peak},
          {"memory_above_input", m.memory.peak - m.memory.before}};
}

double median(std::vector<double> values) {
  const std::size_t half = values.size() / 2;
  std::sort(values.begin(), values.end());
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

}  // namespace bench
