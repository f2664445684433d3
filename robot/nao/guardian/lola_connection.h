// One connection to LoLA: frames in, answers out.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "robot/core/files.h"
#include "robot/core/result.h"
#include "robot/nao/lola/sensors.h"

namespace robot::nao {

/// Where LoLA listens on a Nao V6.
inline constexpr const char* kLolaPath = "/tmp/robocup";

class LolaConnection {
 public:
  /// An Error if nobody listens at `path`, or not for us.
  static Result<LolaConnection> open(const std::filesystem::path& path);

  int file() const { return socket_.get(); }

  /// Takes in what has come, without waiting. An Error: LoLA is gone, or sends what is no frame; this connection is of no
  /// use any more.
  Result<void> take_in();

  /// The oldest whole frame that has not been answered; empty when more is needed. An Error as above.
  Result<std::string_view> frame() const;

  /// Reads that frame; an Error says why it cannot be read. It needs an answer all the same.
  Result<void> read(std::string_view frame, Sensors& sensors) { return frames_.read(frame, sensors); }

  /// Answers that frame, and lets go of it. An Error: LoLA is gone, or does not take it.
  Result<void> answer(std::string_view bytes);

  const RobotIdentity& identity() const { return frames_.identity(); }

 private:
  explicit LolaConnection(FileDescriptor socket) : socket_(std::move(socket)) {}

  FileDescriptor socket_;
  SensorFrames frames_;
  std::string received_;
};

}  // namespace robot::nao
