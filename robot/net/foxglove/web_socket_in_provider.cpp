#include "robot/net/foxglove/web_socket_in_provider.h"

#include <algorithm>
#include <utility>

#include "robot/net/foxglove/from_client.h"

namespace robot::net {
namespace {

constexpr std::uint32_t kSubscription = 1;

}  // namespace

Result<memory::ChannelInfo> WebSocketInProvider::open() {
  if (auto connected = client_.connect(url_, timeout_ns_); !connected) return connected.failure();
  auto channel = find_channel();
  if (!channel) return channel.failure();
  const std::string request = foxglove::to_text(foxglove::Subscribe{{{kSubscription, channel->id}}});
  if (auto sent = client_.send(Opcode::text, request); !sent) return sent.failure();
  return std::move(channel->info);
}

/// Finds the channel in the server's list, which comes first. The first binary message, such as a Time, ends the list.
Result<foxglove::Advertised> WebSocketInProvider::find_channel() {
  const std::uint64_t deadline_ns = monotonic_ns() + timeout_ns_;
  std::string offered;
  while (true) {
    auto message = client_.receive(deadline_ns);
    if (!message) return message.failure();
    if (!*message) return Error{topic_ + ": the connection was closed before it was offered"};
    if ((*message)->opcode == Opcode::binary) break;

    auto channels = foxglove::parse_advertise((*message)->payload);
    if (!channels) return channels.failure();
    for (foxglove::Advertised& channel : *channels) {
      if (channel.info.topic == topic_) return std::move(channel);
      offered += (offered.empty() ? "" : ", ") + channel.info.topic;
    }
  }
  return Error{topic_ + ": there is no such channel; the server offers " + (offered.empty() ? "none" : offered)};
}

Result<std::optional<logging::Record>> WebSocketInProvider::read() {
  while (true) {
    auto message = client_.receive();
    if (!message) return message.failure();
    if (!*message) {
      const auto& closed = client_.closed();
      if (closed && closed->code != kNormalClosure && closed->code != kGoingAway)
        return Error{topic_ + ": the server closed the connection: " + closed->reason};
      return std::optional<logging::Record>();
    }
    if ((*message)->opcode != Opcode::binary) continue;
    const auto data = foxglove::parse_message_data((*message)->payload);
    if (!data) return data.failure();
    if (!*data || (*data)->subscription != kSubscription) continue;
    return std::optional(logging::Record{.sequence = ++last_sequence_,
                                         .capture_ns = (*data)->log_time_ns,
                                         .publish_ns = (*data)->log_time_ns,
                                         .bytes = std::string((*data)->payload)});
  }
}

}  // namespace robot::net
