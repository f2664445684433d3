// All messages of one topic of a session.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "robot/bridge/from_messages.h"
#include "robot/logging/sessions/session_provider.h"

namespace robot::app {

/// Reads all messages of `topic`, in the order of writing. Leaves out damaged ones; the report of the session's streams
/// names the damage.
template <class Message>
std::vector<bridge::Remembered<Message>> read_all(const logging::Session& session, const std::string& topic) {
  std::vector<bridge::Remembered<Message>> all;
  const auto file = std::ranges::find(session.streams, topic, &logging::StreamFile::topic);
  if (file == session.streams.end()) return all;
  const auto stream = logging::provider_of(session, *file);
  if (!stream->open()) return all;
  while (true) {
    const Result<std::optional<logging::Record>> record = stream->read();
    if (!record) continue;
    if (!*record) break;
    bridge::Remembered<Message> message{.value = {}, .capture_ns = (*record)->capture_ns};
    if (message.value.ParseFromString((*record)->bytes)) all.push_back(std::move(message));
  }
  return all;
}

/// The same, ordered by the capture times.
template <class Message>
std::vector<bridge::Remembered<Message>> read_in_order(const logging::Session& session, const std::string& topic) {
  auto all = read_all<Message>(session, topic);
  std::ranges::stable_sort(all, {}, &bridge::Remembered<Message>::capture_ns);
  return all;
}

}  // namespace robot::app
