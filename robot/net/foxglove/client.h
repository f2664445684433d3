// One client of the live protocol in the hub, without its socket.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "robot/net/foxglove/client_queue.h"
#include "robot/net/foxglove/playback.h"
#include "robot/net/foxglove/services.h"

namespace robot::net {

/// The facts about a client at its arrival.
struct ClientIdentity {
  ClientContext context;  // the id is given by the hub
  std::string user_agent, subprotocol;
  bool lossless = false;  // it gets every message or is disconnected
  bool numbered = false;  // it receives the numbers of the messages, an extension of the protocol
  bool playback = false;  // it receives the state of the playback, which older clients take for an error
  /// It wants a playhead of its own in a recording, from this capture time [ns] or, with 0, from the start. Absent: it
  /// shares the playback.
  std::optional<std::uint64_t> playhead = {};
};

struct Client : std::enable_shared_from_this<Client> {
  Client(ClientIdentity who, const QueueLimits& limits)
      : identity(std::move(who)), queue(limits, identity.lossless, identity.numbered) {}

  ClientIdentity identity;
  ClientQueue queue;
  std::map<std::uint32_t, std::uint32_t> channel_of;  // by subscription id

  std::unique_ptr<OwnPlayhead> own;                       // null: it shares the playback, if there is one
  std::map<std::uint32_t, std::uint64_t> own_streams;     // streams from its own playhead, by channel
  foxglove::Playback told = foxglove::Playback::playing;  // the status of its own playhead that was sent last

  int waiting_requests = 0;  // that run in the background and are not answered yet

  bool watches_all_parameters = false;
  std::set<std::string> watched_parameters;

  // round trip, by WebSocket ping: one at a time
  std::optional<std::uint64_t> ping_sent_ns;  // [monotonic]
  std::optional<std::uint64_t> round_trip_ns;

  // the last count of sent and dropped messages and its time [monotonic], and whether the client has a status about drops
  std::map<std::uint32_t, ClientQueue::Counts> counted;  // by channel
  std::uint64_t drops_counted_ns = 0;
  bool drops_stand = false;
};

}  // namespace robot::net
