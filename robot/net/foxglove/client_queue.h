// The queue of one client. It decides which message is sent next and which is dropped.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/memory/channel.h"

namespace robot::net {

struct QueueLimits {
  std::size_t fifo_messages = 32;         // per fifo channel; a third of a second of sensors
  std::size_t reliable_bytes = 1 << 20;   // per reliable channel
  std::size_t lossless_bytes = 32 << 20;  // of all channels together, of a lossless client
  std::size_t control_bytes = 16 << 20;   // of answers and announcements
};

/// The next write to the socket: first `bytes`, then `large`, which is not copied. `keeper` keeps it alive.
struct Batch {
  std::string bytes;
  std::string_view large;
  std::shared_ptr<const void> keeper;
};

/// The messages that wait for one client, one slot per channel. A slot keeps the newest message (`latest`), the last
/// few (`fifo`) or all (`reliable`). The queue chooses the next message when the socket has room, not when a message is
/// produced, because old data are worse than none. Order: answers, events, small messages, large messages; channels of
/// a class take turns. Dropped messages are counted. Used by one thread.
class ClientQueue {
 public:
  static constexpr std::size_t kBatchBytes = 64 << 10;  // small frames copied together
  static constexpr std::size_t kLargeBytes = 16 << 10;  // from this size on a message is referenced, not copied

  enum class Pushed {
    queued,
    known,     // this version or a later one was taken before, or the channel is not subscribed
    overflow,  // there is no room, and nothing may be dropped: the client must be disconnected
  };

  /// A `lossless` client gets every message of every channel. A `numbered` one gets the numbers of the messages too.
  ClientQueue(const QueueLimits& limits, bool lossless, bool numbered = false)
      : limits_(limits), lossless_(lossless), numbered_(numbered) {}
  ClientQueue(const ClientQueue&) = delete;
  ClientQueue& operator=(const ClientQueue&) = delete;

  /// Begins to take messages of `channel`, which are sent under the number `subscription`.
  void subscribe(std::uint32_t channel, std::uint32_t subscription, memory::Delivery delivery);

  /// Drops the waiting messages of `channel`, and takes no more. Its counts remain.
  void unsubscribe(std::uint32_t channel);

  /// Takes a version of `channel`. It is sent with its capture time, or with `time_ns` instead.
  Pushed push(std::uint32_t channel, const memory::VersionPtr& version, std::optional<std::uint64_t> time_ns = {});

  /// Counts `messages` of `channel` that were lost before they reached the queue.
  void count_lost(std::uint32_t channel, std::uint64_t messages);

  /// Takes a whole frame that is sent before all messages. Returns false if there is no room: the client must be
  /// disconnected.
  bool push_control(std::string frame);

  /// Takes a time [ns]. Only the newest is sent.
  void push_time(std::uint64_t time_ns) { time_ns_ = time_ns; }

  /// Drops all waiting messages that may be dropped, because their time line has ended.
  void forget();

  /// Drops the messages, sends the waiting control frames, then `close_frame`, then nothing more.
  void finish(std::string close_frame);
  bool finished() const { return finished_; }

  /// Takes out the next batch to write. Returns false if nothing waits.
  bool fill(Batch& batch);

  bool empty() const { return control_.empty() && !time_ns_ && messages_ == 0; }

  struct Counts {
    std::uint32_t channel = 0;
    std::uint64_t sent = 0;     // [messages] handed to the socket
    std::uint64_t dropped = 0;  // [messages] replaced by newer ones, or lost before they reached the queue
    std::size_t queued_messages = 0, queued_bytes = 0;
    bool subscribed = false;
  };
  /// Returns one entry per channel that was ever subscribed.
  std::vector<Counts> counts() const;
  std::uint64_t dropped() const;  // of all channels

 private:
  enum Lane { events, small, large, kLanes };

  struct Waiting {
    memory::VersionPtr version;
    std::uint64_t time_ns = 0;
  };

  struct Slot {
    std::uint32_t channel = 0, subscription = 0;
    memory::Delivery delivery = memory::Delivery::latest;
    bool subscribed = false;
    bool in_lane = false;
    std::deque<Waiting> waiting;
    std::size_t bytes = 0;
    std::uint64_t last_sequence = 0, sent = 0, dropped = 0;
  };

  Slot* find(std::uint32_t channel);
  bool make_room(Slot& slot, std::size_t bytes);
  void drop_oldest(Slot& slot);
  void clear(Slot& slot);
  Waiting pop(Slot& slot);
  void line_up(Slot& slot);
  bool take_control(Batch& batch);
  bool take_message(Batch& batch, std::deque<Slot*>& lane);
  void take_front(Batch& batch, Slot& slot);

  const QueueLimits limits_;
  const bool lossless_, numbered_;
  std::vector<std::unique_ptr<Slot>> slots_;  // by channel id
  std::array<std::deque<Slot*>, kLanes> lanes_;
  std::size_t messages_ = 0, message_bytes_ = 0;  // waiting, in all slots

  std::deque<std::string> control_;
  std::size_t control_bytes_ = 0;
  std::optional<std::uint64_t> time_ns_;
  bool finished_ = false;
};

}  // namespace robot::net
