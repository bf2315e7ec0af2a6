#include "loosefit/solver/linear/multifrontal/kernel_seat.h"

#include <sys/mman.h>

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <new>

extern "C" {
// Of OpenBLAS: work memory of one call. It stays mapped when it is given back. Weak: of another
// BLAS nothing is known.
void* blas_memory_alloc(int kind) __attribute__((weak));
void blas_memory_free(void* buffer) __attribute__((weak));
}

namespace loosefit::solver::dense {
namespace {

/// Largest work memory of one call (OpenBLAS 0.3.21, common_x86_64.h: BUFFER_SIZE = 32 << 22).
constexpr std::size_t kWorkMemory = std::size_t(32) << 22;
/// What other threads may take between our look and the mapping of OpenBLAS.
constexpr std::size_t kSpare = std::size_t(32) << 20;
/// OpenBLAS ends the process beyond its own table of buffers (0.3.21, memory.c: NUM_BUFFERS).
constexpr int kMostSeats = 128;

bool has_room() {
  const std::size_t size = kWorkMemory + kSpare;
  void* const place =
      mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (place == MAP_FAILED) return false;
  munmap(place, size);
  return true;
}

class Seats {
 public:
  void take() {
    std::unique_lock lock(mutex_);
    while (growing_ || free_ == 0) {
      if (!growing_ && made_ < most_)
        grow(lock);
      else
        changed_.wait(lock);
    }
    --free_;
  }

  void give() noexcept {
    {
      const std::lock_guard lock(mutex_);
      ++free_;
    }
    changed_.notify_all();
  }

 private:
  /// One more, while no call is under way: OpenBLAS hands out what is mapped before it maps anew.
  void grow(std::unique_lock<std::mutex>& lock) {
    growing_ = true;
    changed_.wait(lock, [this] { return free_ == made_; });
    const bool grown = map_one_more();
    growing_ = false;
    if (grown)
      ++made_, ++free_;
    else
      most_ = made_;
    changed_.notify_all();
    if (!grown && made_ == 0) {
      most_ = kMostSeats;  // another time there may be memory
      throw std::bad_alloc();
    }
  }

  bool map_one_more() const {
    if (!blas_memory_alloc || !blas_memory_free) return true;
    if (!has_room()) return false;
    void* buffers[kMostSeats];
    for (int i = 0; i <= made_; ++i) buffers[i] = blas_memory_alloc(0);
    for (int i = 0; i <= made_; ++i) blas_memory_free(buffers[i]);
    return true;
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  int made_ = 0, free_ = 0, most_ = kMostSeats;
  bool growing_ = false;
};

Seats& seats() {
  static Seats all;
  return all;
}

}  // namespace

KernelSeat::KernelSeat() { seats().take(); }
KernelSeat::~KernelSeat() { seats().give(); }

}  // namespace loosefit::solver::dense
