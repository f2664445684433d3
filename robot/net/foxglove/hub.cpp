#include "robot/net/foxglove/hub.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "robot/net/foxglove/to_client.h"
#include "robot/net/websocket/frames.h"

namespace robot::net {
namespace {

constexpr std::size_t kChannelsPerAdvertise = 100;
constexpr std::uint64_t kDropsEvery = 5 * kSecond;  // between two statuses about drops
// drops are normal when a page opens or the machine is busy, because the newest message is sent first
constexpr std::uint64_t kDropsWorthTelling = 10, kPartWorthTelling = 4;  // at least 10 messages and 1/4 of a topic
constexpr std::size_t kMostNamed = 3;                                    // topics in a status
constexpr std::string_view kDropsId = "drops";

/// The messages of a topic that a client lost lately.
struct Loss {
  std::string topic;
  std::uint64_t dropped = 0, all = 0;
};

/// "30 of 31 messages of /14/2/ball, 20 of 40 of /14/2/joints and of 2 more topics"
std::string text_of(std::vector<Loss> losses) {
  std::ranges::stable_sort(losses, std::greater<>(), &Loss::dropped);
  std::string text;
  for (std::size_t i = 0; i < std::min(losses.size(), kMostNamed); ++i)
    text += (i == 0 ? "" : ", ") + std::to_string(losses[i].dropped) + " of " + std::to_string(losses[i].all) +
            (i == 0 ? " messages of " : " of ") + losses[i].topic;
  const std::size_t more = losses.size() - std::min(losses.size(), kMostNamed);
  if (more > 0) text += " and of " + std::to_string(more) + (more == 1 ? " more topic" : " more topics");
  return text;
}

}  // namespace

Hub::Hub(HubOptions options, Parameters& parameters, const Services& services, const Clock& clock,
         StreamControl& streams, InBackground in_background)
    : options_(std::move(options)),
      parameters_(parameters),
      services_(services),
      clock_(clock),
      streams_(streams),
      in_background_(std::move(in_background)),
      session_(system_ns() / kMillisecond) {}

void Hub::add_channel(const std::shared_ptr<memory::Channel>& channel, const Derive& derive) {
  std::vector<std::string> advertisements;
  for (const OfferedChannel* added : channels_.add(channel, derive)) advertisements.push_back(added->advertisement);
  if (advertisements.empty()) return;
  const std::string text = foxglove::advertise(advertisements);
  for (const auto& client : clients_) say(*client, text);
}

std::string Hub::server_info() const {
  foxglove::ServerInfo info{.name = options_.name,
                            .capabilities = {"time", "parameters", "parametersSubscribe", "services"},
                            .encodings = {"json"},
                            .metadata = options_.metadata,
                            .session_id = std::to_string(session_)};
  if (options_.playback) {
    info.capabilities.emplace_back("playbackControl");
    info.data_span_ns = {options_.playback->start_ns(), options_.playback->end_ns()};
  }
  return foxglove::server_info(info);
}

std::shared_ptr<Client> Hub::join(ClientIdentity identity) {
  identity.context.id = ++last_client_;
  identity.context.match_mode = match_mode_;
  auto client = std::make_shared<Client>(std::move(identity), options_.queues);
  clients_.push_back(client);

  say(*client, server_info());
  std::vector<std::string> advertisements;
  for (const auto& channel : channels_.all()) {
    advertisements.push_back(channel->advertisement);
    if (advertisements.size() == kChannelsPerAdvertise)
      say(*client, foxglove::advertise(std::exchange(advertisements, {})));
  }
  if (!advertisements.empty()) say(*client, foxglove::advertise(advertisements));
  if (const auto services = services_.list(); !services.empty()) say(*client, foxglove::advertise_services(services));
  if (!options_.playback) return client;
  if (const auto from_ns = client->identity.playhead) {
    client->own = own_playhead(*client, *from_ns);
    say(*client, foxglove::playhead(client->own != nullptr));
  }
  if (client->own)
    tell_own(*client, false, "");
  else if (client->identity.playback)
    say_binary(*client, playback_state(*options_.playback, false, ""));
  return client;
}

void Hub::set_metadata(const std::string& key, const std::string& value) {
  options_.metadata[key] = value;
  const std::string info = server_info();
  for (const auto& client : clients_) say(*client, info);
}

void Hub::set_match_mode(bool match_mode) {
  match_mode_ = match_mode;
  for (const auto& client : clients_) client->identity.context.match_mode = match_mode;
}

void Hub::leave(Client& client) {
  for (const auto& [subscription, channel] : client.channel_of) end_carrying(client, *channels_.find(channel));
  client.channel_of.clear();
  if (client.own) streams_.discard(std::move(client.own));
  if (!questions_.empty())  // the first is running
    questions_.erase(
        std::remove_if(questions_.begin() + 1, questions_.end(),
                       [&](const PendingCall& question) { return question.client.lock().get() == &client; }),
        questions_.end());
  std::erase_if(clients_, [&](const auto& other) { return other.get() == &client; });
}

void Hub::remove_subscriber(OfferedChannel& channel, Client& client) {
  std::erase(channel.subscribers, &client);
  if (!channel.subscribers.empty() || channel.stream == 0) return;
  streams_.stop(std::exchange(channel.stream, 0));
  channel.newest.reset();
}

void Hub::say(Client& client, std::string_view text) {
  std::string frame;
  append_frame(frame, Opcode::text, text);
  send(client, std::move(frame));
}

void Hub::say_binary(Client& client, std::string_view bytes) {
  std::string frame;
  append_frame(frame, Opcode::binary, bytes);
  send(client, std::move(frame));
}

// the sentence has no room either: only the close frame gets through
void Hub::send(Client& client, std::string frame) {
  if (client.queue.push_control(std::move(frame))) return;
  client.queue.finish(close_frame(kPolicyViolation, "the client does not read the answers to its requests"));
}

void Hub::complain(Client& client, std::string_view sentence) {
  say(client, foxglove::status(foxglove::StatusLevel::error, sentence));
}

/// Reports that the client may not control now.
void Hub::refuse(Client& client, std::string_view sentence) {
  say(client, foxglove::status(foxglove::StatusLevel::error, sentence, {}, client.identity.context.cause()));
}

void Hub::disconnect(Client& client, std::uint16_t close_code, std::string_view sentence) {
  if (client.queue.finished()) return;
  say(client, foxglove::status(foxglove::StatusLevel::error, sentence));
  client.queue.finish(close_frame(close_code, sentence));
}

void Hub::deliver(const Inbox::Item& item) {
  OfferedChannel* channel = channels_.find(item.channel);
  if (!channel) return;
  const std::uint64_t sequence = item.version->sequence();
  const auto missing_after = [&](std::uint64_t& last) {
    const std::uint64_t missing = last != 0 && sequence > last + 1 ? sequence - last - 1 : 0;
    last = sequence;
    return missing;
  };
  if (const auto own = own_streams_.find(item.stream); own != own_streams_.end()) {
    Client& client = *own->second.client;
    if (const auto missing = missing_after(own->second.last_sequence)) note_gap(client, *channel, missing);
    return push(client, channel->id, item.version);
  }
  if (channel->stream != item.stream) return;  // of a stream that has been stopped

  const std::uint64_t missing = missing_after(channel->last_sequence);
  if (channel->derived) channel->newest = item.version;
  for (Client* client : channel->subscribers) {
    if (missing > 0) note_gap(*client, *channel, missing);
    push_shared(*client, channel->id, item.version);
  }
}

void Hub::push(Client& client, std::uint32_t channel, const memory::VersionPtr& version,
               std::optional<std::uint64_t> time_ns) {
  if (client.queue.push(channel, version, time_ns) != ClientQueue::Pushed::overflow) return;
  disconnect(client, kPolicyViolation,
             "the connection is too slow for " + channels_.find(channel)->info.topic +
                 ", whose messages must not be dropped: it is closed, connect again to go on");
}

/// Counts messages that were lost because the logger's queue was full, and disconnects a lossless client.
void Hub::note_gap(Client& client, const OfferedChannel& channel, std::uint64_t missing) {
  client.queue.count_lost(channel.id, missing);
  if (client.identity.lossless)
    disconnect(client, kPolicyViolation,
               std::to_string(missing) + " messages of " + channel.info.topic +
                   " were lost on the robot, but this connection must get all: it is closed, connect again to go on");
}

void Hub::send_time() {
  if (options_.playback && options_.playback->state().status != told_) tell_playback(false, nullptr, "");
  last_time_ns_ = std::max(last_time_ns_, clock_.now_ns());
  for (const auto& client : clients_) {
    if (client->queue.finished()) continue;
    if (client->own) follow_own(*client);
    client->queue.push_time(client->own ? client->own->state().time_ns : last_time_ns_);
  }
}

void Hub::restart_time() {
  session_ = std::max(session_ + 1, system_ns() / kMillisecond);
  last_time_ns_ = 0;
  const std::string info = server_info();
  for (const auto& client : clients_) {
    if (client->own) continue;
    client->queue.forget();
    say(*client, info);
  }
}

void Hub::every_second(std::uint64_t now_ns) {
  for (const auto& client : clients_) {
    if (!client->ping_sent_ns) {
      std::string frame;
      append_frame(frame, Opcode::ping, {});
      client->ping_sent_ns = now_ns;
      send(*client, std::move(frame));
    } else if (now_ns - *client->ping_sent_ns > options_.pong_timeout_ns) {
      disconnect(*client, kPolicyViolation, "the connection has not answered for too long: it is closed");
    }
    tell_drops(*client, now_ns);
  }
}

void Hub::on_pong(Client& client, std::uint64_t now_ns) {
  if (client.ping_sent_ns) client.round_trip_ns = now_ns - *std::exchange(client.ping_sent_ns, std::nullopt);
}

/// Sends a status when a topic that a client watches loses a good part of its messages, and removes it when that has ended.
void Hub::tell_drops(Client& client, std::uint64_t now_ns) {
  if (now_ns - client.drops_counted_ns < kDropsEvery) return;
  client.drops_counted_ns = now_ns;
  std::vector<Loss> losses;
  for (const ClientQueue::Counts& counts : client.queue.counts()) {
    const ClientQueue::Counts before = std::exchange(client.counted[counts.channel], counts);
    const std::uint64_t dropped = counts.dropped - before.dropped, all = dropped + counts.sent - before.sent;
    if (counts.subscribed && dropped >= kDropsWorthTelling && dropped * kPartWorthTelling >= all)
      losses.push_back({channels_.all()[counts.channel - 1]->info.topic, dropped, all});
  }
  if (!losses.empty()) {
    const std::string sentence = text_of(losses) + " were dropped for newer ones in the last " +
                                 std::to_string(kDropsEvery / kSecond) + " s: the connection or the page is too slow";
    say(client, foxglove::status(foxglove::StatusLevel::warning, sentence, kDropsId));
  } else if (client.drops_stand) {
    say(client, foxglove::remove_status(kDropsId));
  }
  client.drops_stand = !losses.empty();
}

void Hub::parameter_changed(const std::string& name) {
  for (const auto& client : clients_)
    if (client->watches_all_parameters || client->watched_parameters.contains(name))
      tell_parameters(*client, {name}, std::nullopt);
}

ServerStatistics Hub::statistics() const {
  ServerStatistics statistics;
  for (const auto& client : clients_) {
    const ClientIdentity& who = client->identity;
    ClientStatistics entry{.id = who.context.id,
                           .address = who.context.address,
                           .user_agent = who.user_agent,
                           .subprotocol = who.subprotocol,
                           .round_trip_ns = client->round_trip_ns,
                           .lossless = who.lossless};
    for (const ClientQueue::Counts& counts : client->queue.counts())
      entry.channels.push_back({channels_.all()[counts.channel - 1]->info.topic, counts.sent, counts.dropped,
                                counts.queued_messages, counts.queued_bytes});
    statistics.clients.push_back(std::move(entry));
  }
  return statistics;
}

}  // namespace robot::net
