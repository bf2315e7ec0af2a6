#pragma once
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace loosefit::solver {

/// Arrays that are taken and given back many times by several threads. The system's allocator
/// returns large ones to the kernel each time, which then clears their pages anew: a tenth of a
/// factorisation.
template <class Real>
class BufferPool {
 public:
  /// An array on loan; back in the pool when it goes.
  class Buffer {
   public:
    Buffer() = default;
    Buffer(Buffer&& other) noexcept { swap(other); }
    Buffer& operator=(Buffer&& other) noexcept {
      reset();
      swap(other);
      return *this;
    }
    ~Buffer() { reset(); }
    Real* get() const { return array_.get(); }
    void reset() {
      if (array_) pool_->give_back(capacity_, std::move(array_));
    }

   private:
    friend class BufferPool;
    Buffer(BufferPool& pool, std::size_t capacity, std::unique_ptr<Real[]> array)
        : pool_(&pool), capacity_(capacity), array_(std::move(array)) {}
    void swap(Buffer& other) {
      std::swap(pool_, other.pool_);
      std::swap(capacity_, other.capacity_);
      std::swap(array_, other.array_);
    }
    BufferPool* pool_ = nullptr;
    std::size_t capacity_ = 0;
    std::unique_ptr<Real[]> array_;
  };

  /// An array of at least `size` numbers with whatever they held before.
  Buffer take(std::size_t size) {
    {
      const std::lock_guard lock(mutex_);
      const auto fitting = idle_.lower_bound(size);
      if (fitting != idle_.end() && fitting->first <= size + size / 2 + kSmall) {
        Buffer buffer(*this, fitting->first, std::move(fitting->second));
        idle_.erase(fitting);
        return buffer;
      }
    }
    const std::size_t capacity = size + size / 4;
    return Buffer(*this, capacity, std::make_unique_for_overwrite<Real[]>(capacity));
  }
  /// Gives the memory of all arrays that are not on loan back.
  void release() {
    const std::lock_guard lock(mutex_);
    idle_.clear();
  }

 private:
  static constexpr std::size_t kSmall = 4096;  ///< numbers too many that never matter

  void give_back(std::size_t capacity, std::unique_ptr<Real[]> array) noexcept {
    const std::lock_guard lock(mutex_);
    try {
      idle_.emplace(capacity, std::move(array));
    } catch (...) {  // no memory to remember it by: let it go
    }
  }

  std::mutex mutex_;
  std::multimap<std::size_t, std::unique_ptr<Real[]>> idle_;  ///< by capacity
};

}  // namespace loosefit::solver
