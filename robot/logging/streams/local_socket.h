// Streams between processes of one machine, over unix sockets: one connection carries one stream.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>

#include "robot/core/files.h"
#include "robot/logging/streams/provider.h"
#include "robot/logging/streams/stream_format.h"

namespace robot::logging {

/// Connects to the socket at `path`, says what the stream is, then sends its messages.
/// When the other side goes, messages fail until it is there again; the next one connects anew.
class LocalSocketOutProvider final : public OutProvider {
 public:
  explicit LocalSocketOutProvider(std::filesystem::path path) : path_(std::move(path)) {}

  Result<void> open(const memory::ChannelInfo& info) override;
  Result<void> write(const memory::VersionPtr& version) override;
  Result<void> close() override;
  void cancel() override;

 private:
  Result<void> connect();
  Result<void> send(std::string_view bytes);

  const std::filesystem::path path_;
  memory::ChannelInfo info_;
  FileDescriptor socket_;
  std::atomic<bool> cancelled_ = false;
};

/// Listens at `path` (usable by this user only), takes one connection and reads its stream; when that ends, the next
/// connection is read on as long as it announces the same channel.
class LocalSocketInProvider final : public InProvider {
 public:
  explicit LocalSocketInProvider(std::filesystem::path path) : path_(std::move(path)) {}
  ~LocalSocketInProvider() override;

  Result<memory::ChannelInfo> open() override;
  Result<std::optional<Record>> read() override;
  void cancel() override;

 private:
  Result<void> listen();
  Result<std::optional<Frame>> next_frame();
  bool wait_for(int file);
  bool accept();

  const std::filesystem::path path_;
  memory::ChannelInfo info_;
  FileDescriptor listening_, connection_;
  FrameParser parser_;
  bool broken_ = false;  // what came makes no sense, so neither does what follows
  std::atomic<bool> cancelled_ = false;
};

}  // namespace robot::logging
