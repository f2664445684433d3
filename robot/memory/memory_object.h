// A memory object: one aspect of the robot's cognition, safe to read and write from any thread.
#pragma once

#include <atomic>
#include <cassert>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "robot/memory/channel.h"
#include "robot/memory/pool.h"
#include "robot/memory/schema.h"

namespace robot::memory {

/// One immutable version of a message of type T, with its number, times and bytes.
template <class T>
class TypedVersion final : public Version {
 public:
  const T& value() const { return value_; }
  const T* operator->() const { return &value_; }

  std::string_view bytes() const override {
    if (!serialised_.load(std::memory_order_acquire)) {
      const std::lock_guard guard(serialising_);
      if (!serialised_.load(std::memory_order_relaxed)) {
        value_.SerializeToString(&bytes_);
        serialised_.store(true, std::memory_order_release);
      }
    }
    return bytes_;
  }

 private:
  template <class>
  friend class MemoryObject;
  template <class>
  friend class Draft;

  T value_;
  mutable Mutex serialising_;
  mutable std::atomic<bool> serialised_ = false;
  mutable std::string bytes_;  // keeps its memory when the version is reused
};

/// A message that its writer fills before others can see it. Made by MemoryObject::draft().
template <class T>
class Draft {
 public:
  T& operator*() { return version_->value_; }
  T* operator->() { return &version_->value_; }

 private:
  template <class>
  friend class MemoryObject;
  explicit Draft(std::shared_ptr<TypedVersion<T>> version) : version_(std::move(version)) {}

  std::shared_ptr<TypedVersion<T>> version_;
};

/// The newest value of a message of type T, with its capture time and sequence number.
///
/// A written value never changes: a reader may keep it for any time, and no reader sees half an update.
/// `write` never waits for a reader, a logger or a client, and the writer's thread never frees an old value.
template <class T>
class MemoryObject final : public Channel {
 public:
  /// Sets the topic and the time base; `clock` outlives the object. Called once, before the first write.
  void announce(std::string topic, Delivery delivery, const Clock& clock) {
    Channel::announce({.topic = std::move(topic), .schema = schema_of(*T::descriptor()), .delivery = delivery}, clock);
  }

  /// Returns an empty message to fill. Its memory is reused, so in steady state filling it allocates nothing.
  Draft<T> draft() {
    std::shared_ptr<TypedVersion<T>> version = pool_.take();
    version->value_.Clear();
    version->serialised_.store(false, std::memory_order_relaxed);
    return Draft<T>(std::move(version));
  }

  /// Publishes `draft` as the newest version, with the capture time `capture_ns` [ns since the epoch]. Once per draft.
  void write(Draft<T>&& draft, std::uint64_t capture_ns) {
    assert(draft.version_ && "a draft is written once");
    const std::size_t size = draft.version_->value_.ByteSizeLong();
    const typename Pool<TypedVersion<T>>::KeepAll writer_frees_nothing;
    publish(std::move(draft.version_), capture_ns, size);
  }

  /// Publishes a copy of `value`.
  void write(const T& value, std::uint64_t capture_ns) {
    Draft<T> copy = draft();
    *copy = value;
    write(std::move(copy), capture_ns);
  }

  Result<void> write_bytes(std::string_view bytes, std::uint64_t capture_ns) override {
    Draft<T> message = draft();
    if (!message->ParseFromArray(bytes.data(), static_cast<int>(bytes.size())))
      return Error{info().topic + ": expected a message of type " + T::descriptor()->full_name() + ", got " +
                   std::to_string(bytes.size()) + " bytes of something else"};
    write(std::move(message), capture_ns);
    return {};
  }

  /// Returns the newest version, or null before the first write.
  std::shared_ptr<const TypedVersion<T>> read() const {
    return std::static_pointer_cast<const TypedVersion<T>>(newest());
  }

 private:
  Pool<TypedVersion<T>> pool_;
};

}  // namespace robot::memory
