#include "robot/net/foxglove/channel_table.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "robot/core/report.h"
#include "robot/net/foxglove/to_client.h"

namespace robot::net {
namespace {

std::string advertisement(const OfferedChannel& channel) {
  foxglove::Advertised advertised{.id = channel.id, .info = channel.info};
  advertised.metadata["delivery"] = memory::name(channel.info.delivery);
  if (channel.derived) advertised.metadata["derived"] = "true";
  const memory::ObjectName name = memory::object_name(channel.info.topic);
  if (!name.robot.empty()) advertised.metadata["robot"] = name.robot;
  advertised.metadata["object"] = name.object;
  return foxglove::advertised_channel(advertised);
}

}  // namespace

std::vector<OfferedChannel*> ChannelTable::add(const std::shared_ptr<memory::Channel>& channel, const Derive& derive) {
  std::vector<OfferedChannel*> added = {add_one(channel->info(), channel, std::nullopt)};
  if (derive)
    for (Derived& derived : derive(channel->info())) {
      const memory::ChannelInfo info = derived.info;
      added.push_back(add_one(info, channel, std::move(derived)));
    }
  std::erase(added, nullptr);
  return added;
}

OfferedChannel* ChannelTable::add_one(const memory::ChannelInfo& info, const std::shared_ptr<memory::Channel>& source,
                                      std::optional<Derived> derived) {
  const bool taken =
      std::ranges::any_of(channels_, [&](const auto& channel) { return channel->info.topic == info.topic; });
  // ids have 16 bits as in MCAP, so that a client can record the messages
  if (taken || channels_.size() >= std::numeric_limits<std::uint16_t>::max()) {
    report(Level::warning, "net",
           "channel " + info.topic + " is not offered: its topic is taken, or there are 65535 channels already");
    return nullptr;
  }
  auto channel = std::make_unique<OfferedChannel>();
  channel->id = static_cast<std::uint32_t>(channels_.size() + 1);
  channel->info = info;
  channel->source = source;
  channel->derived = std::move(derived);
  channel->advertisement = advertisement(*channel);
  channels_.push_back(std::move(channel));
  return channels_.back().get();
}

OfferedChannel* ChannelTable::find(std::uint32_t id) {
  return id >= 1 && id <= channels_.size() ? channels_[id - 1].get() : nullptr;
}

}  // namespace robot::net
