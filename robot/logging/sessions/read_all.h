// All messages of one topic of a session.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "robot/logging/sessions/session_provider.h"

namespace robot::logging {

/// A recorded message and its capture time.
template <class Message>
struct Recorded {
  Message value;
  std::uint64_t capture_ns = 0;  // [ns since the epoch]
};

/// Reads all messages of `topic`, in the order of writing. Leaves out damaged ones; the report of the session's streams
/// names the damage.
template <class Message>
std::vector<Recorded<Message>> read_all(const Session& session, const std::string& topic) {
  std::vector<Recorded<Message>> all;
  const auto file = std::ranges::find(session.streams, topic, &StreamFile::topic);
  if (file == session.streams.end()) return all;
  const auto stream = provider_of(session, *file);
  if (!stream->open()) return all;
  while (true) {
    const Result<std::optional<Record>> record = stream->read();
    if (!record) continue;
    if (!*record) break;
    Recorded<Message> message{.value = {}, .capture_ns = (*record)->capture_ns};
    if (message.value.ParseFromString((*record)->bytes)) all.push_back(std::move(message));
  }
  return all;
}

/// The same, ordered by the capture times.
template <class Message>
std::vector<Recorded<Message>> read_in_order(const Session& session, const std::string& topic) {
  auto all = read_all<Message>(session, topic);
  std::ranges::stable_sort(all, {}, &Recorded<Message>::capture_ns);
  return all;
}

}  // namespace robot::logging
