// One connection to LoLA: receives frames, sends answers.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "robot/core/files.h"
#include "robot/core/result.h"
#include "robot/nao/lola/sensors.h"

namespace robot::nao {

/// Path of LoLA's socket on a Nao V6.
inline constexpr const char* kLolaPath = "/tmp/robocup";

/// A connection to LoLA's socket that never blocks.
class LolaConnection {
 public:
  /// Connects to `path`. Returns an Error if no program listens there or the connection is refused.
  static Result<LolaConnection> open(const std::filesystem::path& path);

  int file() const { return socket_.get(); }

  /// Receives the available bytes without waiting. Returns an Error if LoLA is gone; then this connection is of no more
  /// use.
  Result<void> take_in();

  /// Returns the oldest complete frame without an answer, or an empty view if bytes are missing. Returns an Error if
  /// the bytes are no frame; then this connection is of no more use.
  Result<std::string_view> frame() const;

  /// Reads that frame into `sensors`. Returns an Error if it cannot be read. Such a frame needs an answer, too.
  Result<void> read(std::string_view frame, Sensors& sensors) { return frames_.read(frame, sensors); }

  /// Answers that frame and removes it. Returns an Error if LoLA is gone or does not take the answer.
  Result<void> answer(std::string_view bytes);

  const RobotIdentity& identity() const { return frames_.identity(); }

 private:
  explicit LolaConnection(FileDescriptor socket) : socket_(std::move(socket)) {}

  FileDescriptor socket_;
  SensorFrames frames_;
  std::string received_;
};

}  // namespace robot::nao
