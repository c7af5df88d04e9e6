#pragma once
#include <cstdint>

/// The memory of a process that does one job after another: a limit for each, and how much it took. Only Linux tells
/// and limits what a single job takes; elsewhere the limit is one for the whole process, and so is the peak.
class WorkerMemory {
 public:
  WorkerMemory();
  ~WorkerMemory();
  WorkerMemory(const WorkerMemory&) = delete;
  WorkerMemory& operator=(const WorkerMemory&) = delete;

  /// A job begins, which may have `limit` bytes of address space beside those that the process has; 0: no limit.
  void begin(std::uint64_t limit);
  /// It has ended: there is no limit, and large blocks that were freed go back to the system.
  void end();
  /// The largest amount of resident memory from begin() to end(), what the process had before included. Bytes.
  [[nodiscard]] std::uint64_t peak() const { return peak_; }

 private:
  [[nodiscard]] std::uint64_t address_space() const;
  void forget_peak() const;

  int size_ = -1;  ///< files of /proc
  int reset_ = -1;
  std::uint64_t least_ = 0;  ///< peak of the process before its first job
  std::uint64_t peak_ = 0;
};
