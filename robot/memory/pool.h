// Reuse of objects instead of freeing them: in steady state a real-time writer neither allocates nor frees memory.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "robot/core/lock.h"

namespace robot::memory {

/// A pool of objects of type T. It lends them out and takes each back when the last shared pointer to it is gone.
/// It keeps a few spare ones: as many as a logger holds between two writes, and fewer of large objects.
/// The thread that returns one more frees it, except within a `KeepAll`.
/// A lent object may outlive the pool. Any thread.
template <class T>
class Pool {
 public:
  static constexpr std::size_t kSpare = 4;
  static constexpr std::size_t kSpareOfSmall = 32;
  static constexpr std::size_t kSmallBytes = 16 << 10;

  /// While a `KeepAll` exists, its thread returns every object to the pools and frees none.
  class KeepAll {
   public:
    KeepAll() { keep_all() = true; }
    ~KeepAll() { keep_all() = false; }
    KeepAll(const KeepAll&) = delete;
    KeepAll& operator=(const KeepAll&) = delete;
  };

  /// Returns a spare object in the state in which its last user left it, or a new object.
  std::shared_ptr<T> take() {
    std::unique_ptr<T> object = spare_->pop();
    if (!object) object = std::make_unique<T>();
    return std::shared_ptr<T>(object.release(), [spare = spare_](T* used) {
      std::unique_ptr<T> returned(used);
      spare->push(returned);
    });
  }

 private:
  static bool& keep_all() {
    thread_local bool value = false;
    return value;
  }

  static std::size_t spare_of(const T& object) {
    if constexpr (requires { object.size_bytes(); })
      if (object.size_bytes() < kSmallBytes) return kSpareOfSmall;
    return kSpare;
  }

  class Spare {
   public:
    std::unique_ptr<T> pop() {
      const std::lock_guard guard(lock_);
      if (objects_.empty()) return nullptr;
      std::unique_ptr<T> object = std::move(objects_.back());
      objects_.pop_back();
      return object;
    }

    /// Takes `object`, or leaves it to the caller, who frees it outside the lock.
    void push(std::unique_ptr<T>& object) {
      const std::lock_guard guard(lock_);
      if (objects_.size() < spare_of(*object) || keep_all()) objects_.push_back(std::move(object));
    }

   private:
    Mutex lock_;
    std::vector<std::unique_ptr<T>> objects_;
  };

  std::shared_ptr<Spare> spare_ = std::make_shared<Spare>();
};

}  // namespace robot::memory
