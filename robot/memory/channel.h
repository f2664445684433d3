// Channels: memory objects as bytes. Code that only carries data needs no message types.
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

/// The versions of a channel that a client needs when the network is too slow for all of them.
enum class Delivery {
  latest,    // only the newest one: images, state
  fifo,      // a short history: sensors
  reliable,  // every one: events, log text
};

/// Returns "latest", "fifo" or "reliable".
std::string_view name(Delivery delivery);

/// The description of a message type, enough to read the bytes of a channel.
struct Schema {
  std::string name;      // "foresight.Ball"
  std::string encoding;  // "protobuf": `bytes` is a serialised FileDescriptorSet with all imports
  std::string bytes;

  bool operator==(const Schema&) const = default;
};

/// The description of a channel.
struct ChannelInfo {
  std::string topic;  // "/14/2/ball"
  std::string message_encoding = "protobuf";
  Schema schema;
  Delivery delivery = Delivery::latest;

  bool operator==(const ChannelInfo&) const = default;
};

/// The name of a memory object in a topic: "/14/2/ball" is the object "ball" of the robot "14/2".
struct ObjectName {
  std::string_view robot;   // team and player; empty: the object is no robot's
  std::string_view object;  // the topic without its robot and the slash before: "ball", "truth/world"
};

/// Returns the name of the object of `topic`. The parts point into `topic`.
ObjectName object_name(std::string_view topic);

/// The topics of ground truth and of a simulation's state, which belong to no robot.
inline constexpr const char* kTruthTopic = "/truth/world";
inline constexpr const char* kSimulationTopic = "/sim/state";

/// The number of a version, and the time when it entered memory, in the process that it comes from.
struct Published {
  std::uint64_t sequence = 0, publish_ns = 0;
};

class Version;
using VersionPtr = std::shared_ptr<const Version>;

/// One version of one memory object: immutable, shared by all its readers. Any thread.
class Version {
 public:
  virtual ~Version() = default;

  std::uint64_t sequence() const { return sequence_; }      // 1, 2, 3 …; a gap: versions were lost on the way here
  std::uint64_t capture_ns() const { return capture_ns_; }  // [ns since the epoch] when the data were sensed
  std::uint64_t publish_ns() const { return publish_ns_; }  // [ns since the epoch] when it entered memory
  std::size_t size_bytes() const { return size_bytes_; }    // of bytes()

  /// Returns the serialised message. The first call makes it, for all later calls; it lives as long as the version.
  virtual std::string_view bytes() const = 0;

 protected:
  Version() = default;

 private:
  friend class Channel;
  friend VersionPtr with_bytes(const Version&, std::uint64_t, std::string);
  std::uint64_t sequence_ = 0, capture_ns_ = 0, publish_ns_ = 0;
  std::size_t size_bytes_ = 0;
};

/// Returns a version with other bytes and the times of `original`: a smaller image, another format.
/// `sequence` is its number in the stream that it goes to.
VersionPtr with_bytes(const Version& original, std::uint64_t sequence, std::string bytes);

/// A receiver of every version of the channels that it is attached to.
class Listener {
 public:
  virtual ~Listener() = default;

  /// Called by the writer's thread, in the order of the sequence numbers. It should only keep the
  /// pointer, wake a thread and return.
  virtual void on_version(const VersionPtr& version) = 0;
};

/// One memory object, seen as a stream of bytes. All functions from any thread.
class Channel {
 public:
  virtual ~Channel() = default;
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;

  /// Returns the description of this channel, which is fixed before the first write.
  const ChannelInfo& info() const { return info_; }

  /// Returns the newest version, or null before the first write. Never waits for a listener.
  VersionPtr newest() const;

  /// Passes every version from now on to `listener`, beginning with the newest one.
  /// One listener may be attached to several channels.
  void attach(Listener& listener);

  /// Ends that. When it returns, `listener` is not running and will not be called again for this channel.
  void detach(Listener& listener);

  /// Writes a message that came as bytes, from a recording, a socket or another process.
  /// Returns an Error, and writes nothing, if the bytes are not a message of this channel's schema.
  virtual Result<void> write_bytes(std::string_view bytes, std::uint64_t capture_ns) = 0;

 protected:
  Channel() = default;

  /// Sets the description and the time base of the channel. Called once, before the channel is shared.
  void announce(ChannelInfo info, const Clock& clock);

  /// Gives `version` its number and times, passes it to the listeners and makes it the newest. Returns the version that
  /// was newest before. Writers wait for each other; they never wait for a reader.
  /// A version that was published `elsewhere` keeps its number and publish time.
  VersionPtr publish(std::shared_ptr<Version> version, std::uint64_t capture_ns, std::size_t size_bytes,
                     const Published* elsewhere = nullptr);

 private:
  ChannelInfo info_;
  const Clock* clock_ = nullptr;

  Mutex writers_;  // held during a write; guards the next two
  std::vector<Listener*> listeners_;
  std::uint64_t last_sequence_ = 0;

  mutable Mutex newest_lock_;  // held for a pointer copy only
  VersionPtr newest_;
};

/// A channel whose message type this program need not know.
class RawChannel final : public Channel {
 public:
  /// `clock` outlives the channel.
  RawChannel(ChannelInfo info, const Clock& clock);

  /// Accepts any bytes.
  Result<void> write_bytes(std::string_view bytes, std::uint64_t capture_ns) override;

  /// Writes a version that another process published, and keeps its number and publish time from there. Numbers only
  /// grow: a number that does not is replaced by the next one.
  void relay(std::string bytes, std::uint64_t capture_ns, Published published);
};

}  // namespace robot::memory
