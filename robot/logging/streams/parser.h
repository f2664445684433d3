// A parser: the thread that carries a stream into a memory object.
#pragma once

#include <functional>
#include <memory>
#include <thread>

#include "robot/core/lock.h"
#include "robot/logging/streams/provider.h"
#include "robot/logging/streams/stream_status.h"
#include "robot/memory/channel.h"

namespace robot::logging {

/// The timing of a recording's messages. The parsers of one recording share one pace. Any thread.
class Pace {
 public:
  virtual ~Pace() = default;

  enum class Due {
    now,
    elsewhere,  // the playhead was moved: the parser seeks the time of last_move()
    never,      // the parser must end
  };

  /// A move of the playhead: how many there were up to this one, and its target time [ns].
  struct Move {
    std::uint64_t count = 0, to_ns = 0;
  };

  /// Waits until a message captured at `capture_ns` is due. `moves` is the count of the last move that the parser
  /// knows.
  virtual Due wait_until_due(std::uint64_t capture_ns, std::uint64_t moves) = 0;

  /// Waits for the next move. A parser calls it at the end of its stream.
  virtual Due wait_for_move(std::uint64_t moves) = 0;

  virtual Move last_move() const = 0;
};

struct ParserOptions {
  /// Returns the channel for the messages of the stream with this description. An Error ends the parser.
  std::function<Result<std::shared_ptr<memory::Channel>>(const memory::ChannelInfo&)> destination;

  /// The timing of the messages; null: each message is due at once.
  std::shared_ptr<Pace> pace;
};

/// A thread that carries the messages of an InProvider into a channel. It ends at the end of the stream or by stop();
/// with a pace, it ends when the pace returns `never`.
///
/// After a move of the playhead the first message is the newest one before the new time, so that the memory object has
/// its value of that time. Messages that the channel refuses count as dropped. The parser reports a damage of the
/// stream and continues after it. If the system allows no more threads, it ends at once, with that problem.
class Parser {
 public:
  Parser(std::unique_ptr<InProvider> provider, ParserOptions options);

  /// As stop().
  ~Parser();

  /// Ends the thread after the present message. If the thread may be waiting for a pace, the pace's owner must end the
  /// pace first.
  void stop();

  StreamStatus status() const;

 private:
  void run();
  Result<void> carry();
  Result<Pace::Due> keep_pace(const std::optional<Record>& record, std::uint64_t& moves);
  void note(const std::string& problem);
  void count(const Result<void>& entered);

  const std::unique_ptr<InProvider> provider_;
  const ParserOptions options_;

  mutable Mutex lock_;  // guards status_ and stopping_
  StreamStatus status_;
  bool stopping_ = false;
  std::thread thread_;  // declared last, because it uses all other members
};

}  // namespace robot::logging
