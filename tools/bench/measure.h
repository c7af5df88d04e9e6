#pragma once
#include <functional>
#include <nlohmann/json.hpp>
#include <vector>

#include "memory.h"
#include "request.h"

namespace bench {

/// Something that can be run again and again.
struct Subject {
  std::function<void()> forget;  ///< frees what the last run made; not timed
  std::function<void()> run;     ///< from arrays to arrays, with every structure built and freed inside; timed
};

/// How long one operation takes, and what it takes in memory.
struct Measurement {
  std::vector<double> seconds;  ///< of one operation, one entry per repetition
  double warm_up = 0;           ///< the first operation of the process
  unsigned batch = 1;           ///< operations timed together in one repetition
  bool warm_up_only = false;    ///< the budget allowed no more: seconds holds the warm-up
  Memory memory;                ///< during the first operation of the process
};

/// Warms up, then repeats. Operations of less than a millisecond are timed in batches of a few milliseconds, so that
/// neither the clock nor one interruption counts; so small a result is freed inside the timing.
[[nodiscard]] Measurement measure(const Subject& subject, const Request& request);

[[nodiscard]] nlohmann::json to_json(const Measurement& measurement);

/// Of a list that is not empty; of two in the middle, their mean.
[[nodiscard]] double median(std::vector<double> values);

}  // namespace bench
