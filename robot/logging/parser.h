// A parser: the thread that carries a stream into a memory object.
#pragma once

#include <functional>
#include <memory>
#include <thread>

#include "robot/core/lock.h"
#include "robot/logging/logger.h"
#include "robot/logging/provider.h"
#include "robot/memory/channel.h"

namespace robot::logging {

/// Says when the messages of a recording are due. Shared by the parsers of one recording.
class Pace {
 public:
  virtual ~Pace() = default;

  /// Waits until a message captured at `capture_ns` is due; false when the parser is to end instead. Any thread.
  virtual bool wait_until_due(std::uint64_t capture_ns) = 0;
};

struct ParserOptions {
  /// The channel the messages go to, once the stream has said what it is. An Error ends the parser.
  std::function<Result<std::shared_ptr<memory::Channel>>(const memory::ChannelInfo&)> destination;

  /// When each message is due; at once where there is none.
  std::shared_ptr<Pace> pace;
};

/// Carries the messages of an InProvider into a channel, on a thread of its own, to the end of the stream or until
/// stopped. What the channel refuses is counted as dropped; a damage of the stream is told and what is behind it carried on.
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
