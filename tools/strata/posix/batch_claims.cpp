#include "batch_claims.h"

#include <sys/mman.h>

#include <cerrno>
#include <memory>
#include <system_error>

static_assert(std::atomic<std::uint64_t>::is_always_lock_free && std::atomic<std::uint32_t>::is_always_lock_free,
              "atomics are shared by processes");

BatchClaims::BatchClaims(std::size_t jobs, std::size_t workers)
    : jobs_(jobs), bytes_(sizeof(*next_) + workers * sizeof(WorkerState) + jobs * sizeof(Owner)) {
  void* const memory = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "shared memory");
  next_ = new (memory) std::atomic<std::uint64_t>(0);
  states_ = reinterpret_cast<WorkerState*>(next_ + 1);
  std::uninitialized_default_construct_n(states_, workers);
  owners_ = reinterpret_cast<Owner*>(states_ + workers);
  std::uninitialized_default_construct_n(owners_, jobs);
}

BatchClaims::~BatchClaims() { munmap(next_, bytes_); }

std::optional<std::size_t> BatchClaims::claim(std::size_t worker) {
  while (true) {
    const std::uint64_t job = next_->fetch_add(1);
    if (job >= jobs_) return {};
    std::uint32_t nobody = 0;
    if (owners_[job].compare_exchange_strong(nobody, static_cast<std::uint32_t>(worker + 1))) return job;
  }
}

void BatchClaims::give_back(std::size_t job) {
  owners_[job] = 0;
  std::uint64_t next = *next_;
  while (next > job && !next_->compare_exchange_weak(next, job)) continue;
}
