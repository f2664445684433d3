// The messages of some topics of a recording, in order of time, for a playhead of its own.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "robot/core/clock_shift.h"
#include "robot/logging/mcap/ordered_reader.h"
#include "robot/logging/mcap/topic_streams.h"
#include "robot/logging/streams/provider.h"
#include "robot/memory/time_shift.h"

namespace robot::body {

/// A reader of one or several topics, by the time of the playback. It passes over damages without a report, because the
/// shared playback has reported them. Used by one thread.
class Track {
 public:
  struct Message {
    std::size_t topic = 0;  // index in the topics of the track
    logging::Record record;
  };

  virtual ~Track() = default;

  /// Returns the next message, or nothing at the end or when it was cancelled.
  virtual std::optional<Message> next() = 0;

  /// Moves to another time. The next messages are then the newest of each topic captured at `capture_ns` or before, as
  /// far as there is one, and then those captured later.
  virtual void seek(std::uint64_t capture_ns) = 0;
};

/// The track of topics of one file.
class FileTrack final : public Track {
 public:
  /// `shift` is that of all times. `cancelled` outlives this.
  FileTrack(std::shared_ptr<const logging::McapFile> file, const std::vector<logging::TopicStream>& topics,
            const ClockShift& shift, const std::atomic<bool>& cancelled);

  std::optional<Message> next() override;
  void seek(std::uint64_t capture_ns) override;

 private:
  Message by_our_time(logging::McapMessage message);

  std::map<std::uint16_t, std::size_t> topic_of_;           // by channel
  std::vector<std::unique_ptr<memory::TimeShift>> shifts_;  // by topic; empty: the times stay
  const ClockShift shift_;
  logging::OrderedReader reader_;
  std::deque<logging::McapMessage> ahead_;  // messages that seek() has read already
};

/// The track of one stream, such as a made one.
class StreamTrack final : public Track {
 public:
  /// `stream` is open. `cancelled` outlives this.
  StreamTrack(std::unique_ptr<logging::InProvider> stream, const std::atomic<bool>& cancelled)
      : stream_(std::move(stream)), cancelled_(cancelled) {}

  std::optional<Message> next() override;
  void seek(std::uint64_t capture_ns) override;

 private:
  const std::unique_ptr<logging::InProvider> stream_;
  const std::atomic<bool>& cancelled_;
};

}  // namespace robot::body
