// An InProvider whose device is another robot's server.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/clock.h"
#include "robot/logging/streams/provider.h"
#include "robot/net/foxglove/to_client.h"
#include "robot/net/websocket/web_socket_client.h"

namespace robot::net {

/// The messages of one channel of a Foxglove server.
///
/// The connection carries neither sequence numbers nor publish times. So records are numbered 1, 2, 3 … as they arrive,
/// and their publish time is their capture time. Lost messages are noticed only with `?delivery=lossless`: then the
/// server closes the connection. To connect again, the caller makes a new provider.
class WebSocketInProvider final : public logging::InProvider {
 public:
  /// `url` such as "ws://10.0.14.2:8765/?delivery=lossless&token=…", `topic` such as "/14/2/ball".
  WebSocketInProvider(std::string url, std::string topic, std::uint64_t timeout_ns = 5 * kSecond)
      : url_(std::move(url)), topic_(std::move(topic)), timeout_ns_(timeout_ns) {}

  /// Connects, finds the channel and subscribes. Returns an Error if it is not offered.
  Result<memory::ChannelInfo> open() override;

  Result<std::optional<logging::Record>> read() override;
  void cancel() override { client_.cancel(); }

 private:
  Result<foxglove::Advertised> find_channel();

  const std::string url_, topic_;
  const std::uint64_t timeout_ns_;
  WebSocketClient client_;
  std::uint64_t last_sequence_ = 0;
};

}  // namespace robot::net
