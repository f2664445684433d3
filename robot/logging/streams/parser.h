// A parser: the thread that carries a stream into a memory object.
#pragma once

#include <functional>
#include <memory>
#include <thread>

#include "robot/core/lock.h"
#include "robot/logging/streams/logger.h"
#include "robot/logging/streams/provider.h"
#include "robot/memory/channel.h"

namespace robot::logging {

/// Says when the messages of a recording are due. Shared by the parsers of one recording. Any thread.
class Pace {
 public:
  virtual ~Pace() = default;

  enum class Due {
    now,
    elsewhere,  // the recording was moved: the parser goes where last_move() says
    never,      // the parser is to end
  };

  /// Where the recording was moved to, and how often it was moved so far.
  struct Move {
    std::uint64_t count = 0, to_ns = 0;
  };

  /// Waits until a message captured at `capture_ns` is due. `moves` is the count of the last move the parser knows of.
  virtual Due wait_until_due(std::uint64_t capture_ns, std::uint64_t moves) = 0;

  /// For a parser at the end of its stream: waits for another move.
  virtual Due wait_for_move(std::uint64_t moves) = 0;

  virtual Move last_move() const = 0;
};

struct ParserOptions {
  /// The channel the messages go to, once the stream has said what it is. An Error ends the parser.
  std::function<Result<std::shared_ptr<memory::Channel>>(const memory::ChannelInfo&)> destination;

  /// When each message is due; at once where there is none.
  std::shared_ptr<Pace> pace;
};

/// Carries the messages of an InProvider into a channel, on a thread of its own, to the end of the stream or until
/// stopped; with a pace, until that says so. When the recording is moved, the newest message from before that time comes
/// first: a memory object has a value also where none was recorded. What the channel refuses is counted as dropped; a damage of the stream is told and what is behind it carried on.
class Parser {
 public:
  Parser(std::unique_ptr<InProvider> provider, ParserOptions options);

  /// As stop().
  ~Parser();

  /// Ends the thread as soon as the message at hand is written. A pace that keeps it waiting is ended by its owner first.
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

  mutable Mutex lock_;  // guards the next two
  StreamStatus status_;
  bool stopping_ = false;
  std::thread thread_;  // last: it uses all the others
};

}  // namespace robot::logging
