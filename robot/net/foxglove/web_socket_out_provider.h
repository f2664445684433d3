// OutProviders whose device is the server: it sends each version to every client that watches the channel.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/logging/streams/provider.h"
#include "robot/net/foxglove/inbox.h"

namespace robot::net {

/// The device of one watched channel: the server's inbox.
class WebSocketOutProvider final : public logging::OutProvider {
 public:
  /// `channel` and `stream` are the server's numbers of the channel and of this stream.
  WebSocketOutProvider(std::shared_ptr<Inbox> inbox, std::uint32_t channel, std::uint64_t stream)
      : inbox_(std::move(inbox)), channel_(channel), stream_(stream) {}

  Result<void> open(const memory::ChannelInfo&) override { return {}; }

  /// Waits while the inbox is full, so that the logger's own queue drops and counts.
  Result<void> write(const memory::VersionPtr& version) override;

  Result<void> close() override { return {}; }
  void cancel() override { inbox_->cancel(cancelled_); }

 private:
  const std::shared_ptr<Inbox> inbox_;
  const std::uint32_t channel_;
  const std::uint64_t stream_;
  bool cancelled_ = false;  // guarded by the inbox
};

/// Makes the bytes of a derived channel from a version of its source, or returns nothing to skip this version.
using Convert = std::function<Result<std::optional<std::string>>(const memory::Version& source)>;

/// A channel that is made from another one while a client watches it.
struct Derived {
  memory::ChannelInfo info;
  std::function<Convert()> make_convert;  // called for each stream; its result is used by one thread at a time
  bool needs_others = false;              // it reads the newest values of other channels too
};

/// Returns the channels that are derived from a channel, possibly none.
using Derive = std::function<std::vector<Derived>(const memory::ChannelInfo& source)>;

/// A converter of versions before another provider, in the logger's thread.
class ConvertingOutProvider final : public logging::OutProvider {
 public:
  ConvertingOutProvider(std::unique_ptr<logging::OutProvider> target, memory::ChannelInfo info, Convert convert)
      : target_(std::move(target)), info_(std::move(info)), convert_(std::move(convert)) {}

  Result<void> open(const memory::ChannelInfo&) override { return target_->open(info_); }
  Result<void> write(const memory::VersionPtr& version) override;
  Result<void> close() override { return target_->close(); }
  void cancel() override { target_->cancel(); }

 private:
  const std::unique_ptr<logging::OutProvider> target_;
  const memory::ChannelInfo info_;
  const Convert convert_;
  std::uint64_t last_sequence_ = 0;
};

}  // namespace robot::net
