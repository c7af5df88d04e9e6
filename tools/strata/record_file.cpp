#include "record_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "common/text_file.h"
#include "core/system/file.h"
#include "core/system/streams.h"
#include "strata/errors.h"

namespace {

[[noreturn]] void fail(const std::string& path) {
  throw strata::IoError(path, {}, std::generic_category().message(errno));
}

/// The whole lines of a text, with their ends; what follows the last one is left out.
std::vector<std::string_view> whole_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  while (true) {
    const std::size_t end = text.find('\n');
    if (end == text.npos) return lines;
    lines.push_back(text.substr(0, end + 1));
    text.remove_prefix(end + 1);
  }
}

}  // namespace

RecordFile::RecordFile(const std::string& path, const std::vector<BatchJob>& jobs, bool resume, bool retry)
    : path_(path == "-" ? "standard output" : path), jobs_(jobs), known_(jobs.size(), 0) {
  if (path == "-") {
    descriptor_ = strata::system::duplicate(strata::system::standard_output);
  } else {
    const bool old = resume && std::filesystem::exists(path);
    if (old) keep_old(retry);
    descriptor_ = strata::system::open_to_write(path, old);
  }
  if (descriptor_ < 0) fail(path_);
}

RecordFile::~RecordFile() {
  if (descriptor_ >= 0) strata::system::close(descriptor_);
}

// Nothing here may start a thread: processes are going to be forked. read_file() would.

/// The file is replaced, as a whole, by those of its records that are kept.
void RecordFile::keep_old(bool retry) {
  const std::string text = read_text(path_);
  std::map<std::size_t, std::string_view> kept;
  std::size_t number = 0;
  for (const std::string_view line : whole_lines(text)) {
    const RecordKey key = read_record_key(line, fmt::format("{}:{}", path_, ++number));
    const auto job = std::lower_bound(jobs_.begin(), jobs_.end(), key.line,
                                      [](const BatchJob& j, std::size_t wanted) { return j.line < wanted; });
    if (job == jobs_.end() || job->line != key.line || job->digest != key.digest) continue;
    const auto k = static_cast<std::size_t>(job - jobs_.begin());
    if (has(k) || (retry && key.status != JobStatus::ok)) continue;
    kept.emplace(k, line);
    count_in(k, key.status);
  }
  std::string all;
  for (const auto& [k, line] : kept) all += line;
  if (all != text) write_text(path_, all);
  while (next_ < jobs_.size() && has(next_)) ++next_;
  gaps_ = next_ < done_;
}

void RecordFile::count_in(std::size_t job, JobStatus status) {
  known_[job] = 1;
  ++done_;
  ++counts_[static_cast<std::size_t>(status)];
}

void RecordFile::add(std::size_t job, JobStatus status, std::string record) {
  count_in(job, status);
  wait_.emplace(job, std::move(record));
}

void RecordFile::write() {
  std::string ready;
  for (; next_ < jobs_.size() && has(next_); ++next_)
    if (const auto record = wait_.extract(next_)) ready += record.mapped();
  write_bytes(ready);
}

void RecordFile::finish() {
  write();
  std::string rest;
  for (const auto& [job, record] : wait_) rest += record;
  wait_.clear();
  write_bytes(rest);
  if (gaps_) put_in_order();
}

void RecordFile::write_bytes(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::ptrdiff_t done = strata::system::write(descriptor_, bytes.data(), bytes.size());
    if (done < 0) fail(path_);
    bytes.remove_prefix(static_cast<std::size_t>(done));
  }
}

void RecordFile::put_in_order() {
  const std::string text = read_text(path_);
  std::map<std::size_t, std::string_view> lines;
  for (const std::string_view line : whole_lines(text)) lines.emplace(read_record_key(line, path_).line, line);
  std::string all;
  for (const auto& [number, line] : lines) all += line;
  write_text(path_, all);
}
