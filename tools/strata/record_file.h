#pragma once
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "batch_jobs.h"
#include "batch_record.h"

/// The records of a batch, in the order of its jobs: a record is written once those of all earlier jobs are. What was
/// written consists of whole lines at any time, but for the last one when the process is killed.
class RecordFile {
 public:
  /// Writes to a file, or to standard output for "-". With `resume`, records of these jobs that the file has already
  /// are kept; with `retry`, only those that are ok. Throws strata::IoError, also for a line of the file that is no
  /// record.
  RecordFile(const std::string& path, const std::vector<BatchJob>& jobs, bool resume, bool retry);
  ~RecordFile();
  RecordFile(const RecordFile&) = delete;
  RecordFile& operator=(const RecordFile&) = delete;

  [[nodiscard]] bool has(std::size_t job) const { return known_[job] != 0; }
  [[nodiscard]] std::size_t done() const { return done_; }  ///< records, kept ones included
  [[nodiscard]] std::size_t count(JobStatus status) const { return counts_[static_cast<std::size_t>(status)]; }

  /// The record of a job that has none. write() writes it when its turn has come.
  void add(std::size_t job, JobStatus status, std::string record);
  /// Writes the records whose turn has come.
  void write();
  /// Writes the others as well, and puts the file in order where records were kept behind missing ones.
  void finish();

 private:
  void keep_old(bool retry);
  void count_in(std::size_t job, JobStatus status);
  void write_bytes(std::string_view bytes);
  void put_in_order();

  std::string path_;
  const std::vector<BatchJob>& jobs_;
  std::vector<char> known_;                  ///< of job k: is there a record?
  std::map<std::size_t, std::string> wait_;  ///< records whose turn has not come
  std::size_t next_ = 0;                     ///< the first job without a record
  std::size_t done_ = 0;
  std::array<std::size_t, 5> counts_ = {};
  bool gaps_ = false;  ///< the file has records behind missing ones
  int descriptor_ = -1;
};
