// One connection at the door: frames, and files that come with them.
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

/// The process at the other end of a local socket.
struct Peer {
  pid_t process = 0;
  uid_t user = 0;
};

/// A connection to a team's process. Used by one thread at a time, except where stated otherwise.
class Connection {
 public:
  /// Takes over `socket`, which must be non-blocking.
  explicit Connection(FileDescriptor socket);

  const Peer& peer() const { return peer_; }
  int file() const { return socket_.get(); }

  /// Returns whether the other side has disconnected or will send nothing more.
  bool gone() const;

  /// Receives the available bytes without waiting. Returns false when the other side will send nothing more.
  bool receive();

  /// Returns the next complete frame, or nothing when bytes are missing. After an Error no more frames can be read.
  /// The connection keeps a received file for shared messages.
  Result<std::optional<logging::Frame>> next();

  /// Returns a copy of a shared message. It reads the file instead of mapping it: the process may truncate or overwrite
  /// the file at any time, and a truncated mapping would crash the runtime.
  Result<std::string> copy(const logging::SharedMessage& message) const;

  /// Sends all of `bytes` without waiting. Returns false if that is not possible.
  bool send(std::string_view bytes);

  /// Sends `bytes` and waits while the other side does not read. Returns false after a disconnect or end().
  bool send_waiting(std::string_view bytes);

  /// Waits until bytes arrive, the other side disconnects, or end() is called.
  void wait();

  /// Ends the connection and all waiting; the object stays valid. Any thread.
  void end();

 private:
  const FileDescriptor socket_;
  Peer peer_;
  logging::FrameParser parser_;
  std::deque<FileDescriptor> received_;  // files whose frames have not been read yet
  FileDescriptor shared_;
};

}  // namespace robot::body
