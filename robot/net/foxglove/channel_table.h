// The channels that the server offers, with their numbers.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/memory/channel.h"
#include "robot/net/foxglove/web_socket_out_provider.h"

namespace robot::net {

struct Client;

/// A channel for clients: a memory object, or messages that are derived from one.
struct OfferedChannel {
  std::uint32_t id = 0;
  memory::ChannelInfo info;
  std::shared_ptr<memory::Channel> source;
  std::optional<Derived> derived;
  std::string advertisement;  // one element of `advertise`

  std::vector<Client*> subscribers;
  std::uint64_t stream = 0;         // that carries it now; 0: no client watches
  std::uint64_t last_sequence = 0;  // of that stream
  memory::VersionPtr newest;        // of that stream, if derived: the first message of a late subscriber

  /// Returns the first message of a new subscriber to a running stream, or null.
  memory::VersionPtr last_value() const { return derived ? newest : source->newest(); }
};

/// The list of channels, numbered from 1 on in the order of their arrival. Used by the I/O thread.
class ChannelTable {
 public:
  /// Adds `channel` and the channels derived from it. Returns the new ones, without those whose topic is taken.
  std::vector<OfferedChannel*> add(const std::shared_ptr<memory::Channel>& channel, const Derive& derive);

  OfferedChannel* find(std::uint32_t id);
  const std::vector<std::unique_ptr<OfferedChannel>>& all() const { return channels_; }

 private:
  OfferedChannel* add_one(const memory::ChannelInfo& info, const std::shared_ptr<memory::Channel>& source,
                          std::optional<Derived> derived);

  std::vector<std::unique_ptr<OfferedChannel>> channels_;  // [id - 1]
};

}  // namespace robot::net
