// Things that are used again instead of being freed: a real-time writer neither allocates nor frees in steady state.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "robot/core/lock.h"

namespace robot::memory {

/// Lends out objects of type T and takes them back when the last shared pointer to one is gone.
/// A few wait for their next use: as many as a logger that writes every now and then holds at once, of large ones fewer.
/// What comes back beyond that is freed by the thread that let go of it, except within a `KeepAll`.
/// What is lent may outlive the pool. Any thread.
template <class T>
class Pool {
 public:
  static constexpr std::size_t kSpare = 4;
  static constexpr std::size_t kSpareOfSmall = 32;
  static constexpr std::size_t kSmallBytes = 16 << 10;

  /// While one lives, its thread gives everything back to the pools and frees nothing.
  class KeepAll {
   public:
    KeepAll() { keep_all() = true; }
    ~KeepAll() { keep_all() = false; }
    KeepAll(const KeepAll&) = delete;
    KeepAll& operator=(const KeepAll&) = delete;
  };

  /// One object, as its last user left it, or a new one.
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

    /// An object that is not kept is freed when the caller's pointer goes, outside the lock.
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
