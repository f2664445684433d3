// One connection at the door: frames, and the files that come along with them.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

#include "robot/core/files.h"
#include "robot/core/result.h"
#include "robot/logging/streams/stream_format.h"

namespace robot::body {

/// Who is at the other end of a local socket.
struct Peer {
  pid_t process = 0;
  uid_t user = 0;
};

/// Used by one thread at a time, except where said otherwise.
class Connection {
 public:
  /// `socket` never blocks.
  explicit Connection(FileDescriptor socket);

  const Peer& peer() const { return peer_; }
  int file() const { return socket_.get(); }

  /// Whether the other side has gone, or will at least send nothing more.
  bool gone() const;

  /// Takes in what has come, without waiting; false when nothing will come any more.
  bool receive();

  /// The next whole frame of what was received; nothing when more is needed. After an Error nothing can be read on.
  /// A file that shared messages lie in is kept here.
  Result<std::optional<logging::Frame>> next();

  /// The bytes of a shared message, copied. They come by reading the file, not by mapping it: whoever shares it may
  /// truncate it or write to it at any time, and that must not harm us.
  Result<std::string> copy(const logging::SharedMessage& message) const;

  /// Sends all of `bytes` without waiting; false when that cannot be.
  bool send(std::string_view bytes);

  /// Sends `bytes`, and waits while the other side does not read; false when it has gone, or after end().
  bool send_waiting(std::string_view bytes);

  /// Waits until something has come, the other side has gone, or end() was called.
  void wait();

  /// Ends all waiting and the connection itself; it stays an object. Any thread.
  void end();

 private:
  const FileDescriptor socket_;
  Peer peer_;
  logging::FrameParser parser_;
  std::deque<FileDescriptor> received_;  // files whose frames have not been read yet
  FileDescriptor shared_;
};

}  // namespace robot::body
