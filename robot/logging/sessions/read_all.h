// All messages of one topic of a session.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "robot/logging/sessions/session_provider.h"

namespace robot::logging {

/// A recorded message and its capture time.
template <class Message>
struct Recorded {
  Message value;
  std::uint64_t capture_ns = 0;  // [ns since the epoch]
};

/// Passes each message of `topic` and its record, with both times, to `visit`, in the order of writing. Leaves out
/// damaged ones; the report of the session's streams names the damage.
template <class Message, class Visit>
void read_records(const Session& session, const std::string& topic, Visit&& visit) {
  const auto file = std::ranges::find(session.streams, topic, &StreamFile::topic);
  if (file == session.streams.end()) return;
  const auto stream = provider_of(session, *file);
  if (!stream->open()) return;
  Message message;
  while (true) {
    const Result<std::optional<Record>> record = stream->read();
    if (!record) continue;
    if (!*record) break;
    if (message.ParseFromString((*record)->bytes)) visit(message, **record);
  }
}

/// Passes each message of `topic` and its capture time [ns since the epoch] to `visit`, as read_records() does.
template <class Message, class Visit>
void read_each(const Session& session, const std::string& topic, Visit&& visit) {
  read_records<Message>(session, topic,
                        [&](Message& message, const Record& record) { visit(message, record.capture_ns); });
}

/// Reads all messages of `topic`, in the order of writing, as read_each() does.
template <class Message>
std::vector<Recorded<Message>> read_all(const Session& session, const std::string& topic) {
  std::vector<Recorded<Message>> all;
  read_each<Message>(session, topic, [&](Message& message, std::uint64_t capture_ns) {
    all.push_back({.value = std::move(message), .capture_ns = capture_ns});
  });
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
