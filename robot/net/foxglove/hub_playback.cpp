// The hub's playback of a recording: the shared one, and playheads of single clients.
#include <utility>

#include "robot/net/foxglove/hub.h"

namespace robot::net {

std::string playback_state(const Playhead& playhead, bool did_seek, std::string_view request_id) {
  const Playhead::State state = playhead.state();
  return foxglove::playback_state(state.status, state.time_ns, state.speed, did_seek, request_id);
}

// the streams of a subscribed channel

/// Begins to carry a subscribed channel to the client: from its own playhead, else together with others. A new stream
/// begins with the newest message; for a running one it is sent here.
void Hub::begin_carrying(Client& client, OfferedChannel& channel) {
  const Derived* const derived = channel.derived ? &*channel.derived : nullptr;
  if (client.own)
    if (const auto source = client.own->watch(channel.source->info())) {
      const std::uint64_t stream = streams_.start(channel.id, source, derived);
      client.own_streams[channel.id] = stream;
      own_streams_[stream] = {.client = &client, .channel = channel.id};
      return;
    }
  channel.subscribers.push_back(&client);
  if (channel.stream == 0) {
    channel.last_sequence = 0;
    channel.stream = streams_.start(channel.id, channel.source, derived);
  } else if (const memory::VersionPtr newest = channel.last_value()) {
    push_shared(client, channel.id, newest);
  }
}

void Hub::end_carrying(Client& client, OfferedChannel& channel) {
  const auto own = client.own_streams.extract(channel.id);
  if (!own) return remove_subscriber(channel, client);
  own_streams_.erase(own.mapped());
  streams_.stop(own.mapped());
  client.own->unwatch(channel.source->info().topic);
}

/// Queues a version of a channel that clients share. To a client with a playhead of its own it comes with that playhead's
/// time, because an object of this process itself has no time in the recording.
void Hub::push_shared(Client& client, std::uint32_t channel, const memory::VersionPtr& version) {
  if (!client.own) return push(client, channel, version);
  push(client, channel, version, client.own->state().time_ns);
}

// playheads

/// Returns a new playhead for the client, or null after a sentence if there are too many.
std::unique_ptr<OwnPlayhead> Hub::own_playhead(Client& client, std::optional<std::uint64_t> from_ns) {
  auto own = options_.playback->own_playhead(from_ns);
  if (own) return std::move(*own);
  say(client, foxglove::status(foxglove::StatusLevel::warning, own.error(), "playhead"));
  return nullptr;
}

/// Gives the client another playhead, or the shared playback if `own` is null. Its subscriptions continue, except those
/// that only the shared playback has.
void Hub::change_playhead(Client& client, std::unique_ptr<OwnPlayhead> own) {
  for (const auto& [subscription, channel] : client.channel_of) end_carrying(client, *channels_.find(channel));
  if (client.own) streams_.discard(std::move(client.own));
  client.own = std::move(own);
  client.queue.forget();
  for (const auto& [subscription, id] : std::map(client.channel_of)) {
    client.queue.unsubscribe(id);
    client.channel_of.erase(subscription);
    subscribe(client, {.subscription = subscription, .channel = id});
  }
}

void Hub::handle(Client& client, const foxglove::ChoosePlayhead& message) {
  if (!options_.playback) return complain(client, "playhead: this server does not play a recording");
  client.identity.playback = true;  // a client that asks for a playhead understands its state
  if (message.own != (client.own != nullptr)) {
    const Playhead::State shared = options_.playback->state();
    auto own = message.own ? own_playhead(client, shared.time_ns) : nullptr;
    if (own)
      own->control({.play = shared.status == foxglove::Playback::playing,
                    .speed = shared.speed,
                    .seek_ns = {},
                    .request_id = {}});
    if (own || !message.own) change_playhead(client, std::move(own));
  }
  say(client, foxglove::playhead(client.own != nullptr));
  if (client.own) return tell_own(client, true, "");
  say_binary(client, playback_state(*options_.playback, true, ""));
}

void Hub::handle(Client& client, const foxglove::PlaybackControl& message) {
  if (!options_.playback) return complain(client, "playback: this server does not play a recording");
  // a playhead of one's own disturbs nobody
  if (const std::string refusal = client.identity.context.refusal(); !client.own && !refusal.empty())
    return refuse(client, "playback: " + refusal);
  if (!(message.speed >= 0.01F && message.speed <= 1000))
    return complain(client, "playback: expected a speed of 0.01 .. 1000, got " + std::to_string(message.speed));
  client.identity.playback = true;  // a client that controls the playback understands its state
  // after a move, waiting messages are from the time before it
  if (client.own) {
    const bool did_seek = client.own->control(message);
    if (did_seek) client.queue.forget();
    return tell_own(client, did_seek, message.request_id);
  }
  const bool did_seek = options_.playback->control(message);
  if (did_seek) {
    last_time_ns_ = 0;
    for (const auto& each : clients_)
      if (!each->own) each->queue.forget();
  }
  tell_playback(did_seek, &client, message.request_id);
}

/// Sends the state of the shared playback to clients that understand it. The message to `asker` carries the request's id.
void Hub::tell_playback(bool did_seek, const Client* asker, const std::string& request_id) {
  told_ = options_.playback->state().status;
  for (const auto& client : clients_)
    if (client->identity.playback && !client->own)
      say_binary(*client,
                 playback_state(*options_.playback, did_seek, client.get() == asker ? request_id : std::string_view()));
}

/// Sends a client the state of its own playhead.
void Hub::tell_own(Client& client, bool did_seek, std::string_view request_id) {
  client.told = client.own->state().status;
  say_binary(client, playback_state(*client.own, did_seek, request_id));
}

/// Reports the end of a client's own playhead, or its new begin in a loop.
void Hub::follow_own(Client& client) {
  if (client.own->loop()) {
    client.queue.forget();
    tell_own(client, true, "");
  } else if (client.own->state().status != client.told) {
    tell_own(client, false, "");
  }
}

}  // namespace robot::net
