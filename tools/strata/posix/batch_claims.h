#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>

/// What a worker tells its parent without a message.
struct WorkerState {
  static constexpr std::uint64_t none = ~std::uint64_t{0};
  std::atomic<std::uint64_t> job = none;    ///< that it executes
  std::atomic<std::int64_t> started = 0;    ///< when, in nanoseconds of the steady clock; set before `job`
  std::atomic<bool> out_of_memory = false;  ///< an allocation failed since then
};

/// Which worker executes which job, in memory that the processes share. Workers help themselves, so that a job costs no
/// message from the parent. Every job is claimed once, unless it is given back.
class BatchClaims {
 public:
  /// Throws std::system_error.
  BatchClaims(std::size_t jobs, std::size_t workers);
  ~BatchClaims();
  BatchClaims(const BatchClaims&) = delete;
  BatchClaims& operator=(const BatchClaims&) = delete;

  /// The next job that nobody has; none when all are taken. O(1) on average.
  [[nodiscard]] std::optional<std::size_t> claim(std::size_t worker);
  /// Takes a job from all workers: it is not to be executed. Before any worker begins.
  void withhold(std::size_t job) { owners_[job] = withheld; }
  /// Makes a job free again.
  void give_back(std::size_t job);
  [[nodiscard]] bool any_left() const { return *next_ < jobs_; }  ///< false only when all are taken
  [[nodiscard]] bool belongs_to(std::size_t job, std::size_t worker) const { return owners_[job] == worker + 1; }

  [[nodiscard]] WorkerState& state(std::size_t worker) { return states_[worker]; }

 private:
  using Owner = std::atomic<std::uint32_t>;  ///< 0: nobody; k + 1: worker k
  static constexpr std::uint32_t withheld = ~std::uint32_t{0};

  std::size_t jobs_;
  std::size_t bytes_;
  std::atomic<std::uint64_t>* next_;  ///< no job before this one is free
  WorkerState* states_;
  Owner* owners_;
};
