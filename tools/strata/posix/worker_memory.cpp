#include "worker_memory.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "common/json_report.h"

namespace {

/// The soft limit, so that it can be taken back. 0: none.
void limit_address_space(std::uint64_t bytes) {
  rlimit both = {};
  getrlimit(RLIMIT_AS, &both);
  both.rlim_cur = bytes == 0 ? both.rlim_max : std::min<rlim_t>(bytes, both.rlim_max);
  setrlimit(RLIMIT_AS, &both);
}

}  // namespace

WorkerMemory::WorkerMemory()
    : size_(open("/proc/self/statm", O_RDONLY | O_CLOEXEC)),
      reset_(open("/proc/self/clear_refs", O_WRONLY | O_CLOEXEC)),
      least_(peak_bytes()) {}

WorkerMemory::~WorkerMemory() {
  if (size_ >= 0) close(size_);
  if (reset_ >= 0) close(reset_);
}

void WorkerMemory::begin(std::uint64_t limit) {
  forget_peak();
  if (limit != 0) limit_address_space(address_space() + limit);
}

void WorkerMemory::end() {
  limit_address_space(0);
  peak_ = peak_bytes();
#ifdef __GLIBC__
  constexpr std::uint64_t much = 64 << 20;
  if (peak_ > least_ + much) malloc_trim(0);
#endif
}

/// 0 where nobody tells.
std::uint64_t WorkerMemory::address_space() const {
  std::array<char, 64> text = {};
  if (size_ < 0 || pread(size_, text.data(), text.size() - 1, 0) <= 0) return 0;
  return std::strtoull(text.data(), nullptr, 10) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

/// "5" makes the peak of resident memory what is resident now: proc(5).
void WorkerMemory::forget_peak() const {
  if (reset_ >= 0) [[maybe_unused]]
    const auto done = write(reset_, "5", 1);
}
