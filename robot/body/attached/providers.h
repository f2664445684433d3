// Streams at the door: the source of a parser and the target of a logger.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "robot/body/attached/connection.h"
#include "robot/body/attached/turns.h"
#include "robot/logging/streams/provider.h"

namespace robot::body {

/// The messages that a process writes, with their times converted to the epoch. The stream ends with the connection.
class DoorInProvider final : public logging::InProvider {
 public:
  /// `info` is the process's announcement. `turns` outlives this.
  DoorInProvider(std::shared_ptr<Connection> connection, memory::ChannelInfo info, std::uint64_t epoch_offset_ns,
                 Turns& turns);
  ~DoorInProvider() override;

  /// Waits until no other process writes the same object.
  Result<memory::ChannelInfo> open() override;

  Result<std::optional<logging::Record>> read() override;
  std::uint64_t lost_before() const override { return lost_; }
  void cancel() override;

 private:
  Result<std::optional<logging::Record>> take(logging::Frame frame);
  Result<std::optional<logging::Record>> checked(logging::Record record);
  Error refuse(std::string sentence);
  void give_back_turn();

  const std::shared_ptr<Connection> connection_;
  const memory::ChannelInfo info_;
  const std::uint64_t epoch_offset_ns_;
  Turns& turns_;
  bool has_turn_ = false, ended_ = false;
  std::uint64_t last_sequence_ = 0;  // 0: no message yet
  std::atomic<std::uint64_t> lost_ = 0;
  std::atomic<bool> cancelled_ = false;
};

/// The messages that a process reads. After its disconnect, messages are dropped without an error.
class DoorOutProvider final : public logging::OutProvider {
 public:
  DoorOutProvider(std::shared_ptr<Connection> connection, std::uint64_t epoch_offset_ns)
      : connection_(std::move(connection)), epoch_offset_ns_(epoch_offset_ns) {}

  Result<void> open(const memory::ChannelInfo& info) override;
  Result<void> write(const memory::VersionPtr& version) override;
  Result<void> close() override;
  void cancel() override { connection_->end(); }

 private:
  void send(std::string_view bytes);

  const std::shared_ptr<Connection> connection_;
  const std::uint64_t epoch_offset_ns_;
  bool gone_ = false;
};

}  // namespace robot::body
