// What only carries data needs no types: a channel is a memory object as bytes, whatever its message.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/clock.h"
#include "robot/core/lock.h"
#include "robot/core/result.h"

namespace robot::memory {

/// What matters to somebody who watches a channel over a network that is too slow for all of it.
enum class Delivery {
  latest,    // only the newest counts: images, state
  fifo,      // a short history counts: sensors
  reliable,  // each one counts: events, log text
};

/// "latest", "fifo" or "reliable".
std::string_view name(Delivery delivery);

/// How the bytes of a channel are to be read.
struct Schema {
  std::string name;      // "foresight.Ball"
  std::string encoding;  // "protobuf": `bytes` is a serialised FileDescriptorSet with all imports
  std::string bytes;

  bool operator==(const Schema&) const = default;
};

/// What a channel says of itself.
struct ChannelInfo {
  std::string topic;  // "/14/2/ball"
  std::string message_encoding = "protobuf";
  Schema schema;
  Delivery delivery = Delivery::latest;

  bool operator==(const ChannelInfo&) const = default;
};

/// Which number a version had, and when it entered memory, in the process that it comes from.
struct Published {
  std::uint64_t sequence = 0, publish_ns = 0;
};

class Version;
using VersionPtr = std::shared_ptr<const Version>;

/// One version of one memory object: immutable, shared by whoever holds it. Any thread.
class Version {
 public:
  virtual ~Version() = default;

  std::uint64_t sequence() const { return sequence_; }  // 1, 2, 3 …; a gap tells of versions lost on their way here
  std::uint64_t capture_ns() const { return capture_ns_; }  // [ns since the epoch] when the data were sensed
  std::uint64_t publish_ns() const { return publish_ns_; }  // [ns since the epoch] when it entered memory
  std::size_t size_bytes() const { return size_bytes_; }    // of bytes()

  /// The serialised message. Made by the first who asks, once per version, for all; lives as long as the version.
  virtual std::string_view bytes() const = 0;

 protected:
  Version() = default;

 private:
  friend class Channel;
  friend VersionPtr with_bytes(const Version&, std::uint64_t, std::string);
  std::uint64_t sequence_ = 0, capture_ns_ = 0, publish_ns_ = 0;
  std::size_t size_bytes_ = 0;
};

/// Other bytes in place of those of `original`, of the same capture and publish time: a smaller image, another format.
/// `sequence` is its number in the stream it goes to.
VersionPtr with_bytes(const Version& original, std::uint64_t sequence, std::string bytes);

/// Hears of every version of the channels it is attached to.
class Listener {
 public:
  virtual ~Listener() = default;

  /// Called by the writer's thread, in the order of the sequence numbers: keep the pointer, wake somebody, return.
  virtual void on_version(const VersionPtr& version) = 0;
};

/// One memory object, seen as a stream of bytes. All functions from any thread.
class Channel {
 public:
  virtual ~Channel() = default;
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;

  /// Fixed before the first write.
  const ChannelInfo& info() const { return info_; }

  /// The newest version, or null before the first write. Never waits for a listener.
  VersionPtr newest() const;

  /// From now on `listener` hears of every version, beginning with the newest there is.
  /// The same listener may hear several channels.
  void attach(Listener& listener);

  /// After return `listener` is not being called and will not be called again for this channel.
  void detach(Listener& listener);

  /// Enters a message that came as bytes, from a recording, a socket or another process.
  /// An Error (nothing is written) if the bytes are not a message of this channel's schema.
  virtual Result<void> write_bytes(std::string_view bytes, std::uint64_t capture_ns) = 0;

 protected:
  Channel() = default;

  /// Names the channel and gives it its time base, once, before it is shared.
  void announce(ChannelInfo info, const Clock& clock);

  /// Gives `version` its number and times, makes it the newest and tells the listeners.
  /// Writers wait for each other; they never wait for a reader. Returns the version that was newest before.
  /// What was published `elsewhere` keeps its number and time.
  VersionPtr publish(std::shared_ptr<Version> version, std::uint64_t capture_ns, std::size_t size_bytes,
                     const Published* elsewhere = nullptr);

 private:
  ChannelInfo info_;
  const Clock* clock_ = nullptr;

  Mutex writers_;  // puts writers in order, guards the next two
  std::vector<Listener*> listeners_;
  std::uint64_t last_sequence_ = 0;

  mutable Mutex newest_lock_;  // held for a pointer copy only
  VersionPtr newest_;
};

/// A channel whose message type need not be known when this program is built.
class RawChannel final : public Channel {
 public:
  /// `clock` outlives the channel.
  RawChannel(ChannelInfo info, const Clock& clock);

  /// Accepts any bytes.
  Result<void> write_bytes(std::string_view bytes, std::uint64_t capture_ns) override;

  /// As write_bytes(), for what another process published: number and publish time stay as they were there. Numbers only
  /// grow: one that does not is replaced by the next.
  void relay(std::string bytes, std::uint64_t capture_ns, Published published);
};

}  // namespace robot::memory
