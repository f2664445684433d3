// Reading of a whole recording, or of a range of it, for answers about all of it.
#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "robot/body/replay/replay.h"
#include "robot/logging/mcap/ordered_reader.h"
#include "robot/logging/mcap/topic_streams.h"

namespace robot::body {
namespace {

using Visit = std::function<bool(const Replay::Message&)>;

/// A range of capture times, both included.
struct Range {
  std::uint64_t from_ns, to_ns;
};

/// Returns whether `visit` wants more.
bool read_stream(logging::InProvider& stream, std::size_t topic, Range range, const Visit& visit,
                 std::uint64_t& damages) {
  if (!stream.open()) return ++damages, true;
  // 1 ns earlier, because a seek finds the last of several messages of one time
  if (range.from_ns > 0 && !stream.seek(range.from_ns - 1)) return ++damages, true;
  while (true) {
    const auto record = stream.read();
    if (!record) {
      ++damages;
      continue;
    }
    if (!*record || (*record)->capture_ns > range.to_ns) return true;
    const logging::Record& message = **record;
    if (message.capture_ns < range.from_ns) continue;
    if (!visit({.topic = topic, .capture_ns = message.capture_ns, .bytes = message.bytes})) return false;
  }
}

/// As before, for several topics of one file: `topic_of` gives the topic of each channel.
bool read_file(std::shared_ptr<const logging::McapFile> file, const std::map<std::uint16_t, std::size_t>& topic_of,
               const ClockShift& shift, Range range, const Visit& visit, std::uint64_t& damages) {
  std::set<std::uint16_t> channels;
  for (const auto& [channel, topic] : topic_of) channels.insert(channel);
  logging::OrderedReader reader(std::move(file), channels);
  if (range.from_ns > 0) reader.seek(shift.back(range.from_ns));
  while (true) {
    const auto message = reader.next();
    if (!message) {
      ++damages;
      continue;
    }
    if (!*message) return true;
    const std::uint64_t capture_ns = shift((*message)->record.capture_ns);
    if (capture_ns > range.to_ns) return true;
    if (capture_ns < range.from_ns) continue;
    const std::size_t topic = topic_of.at((*message)->channel_id);
    if (!visit({.topic = topic, .capture_ns = capture_ns, .bytes = (*message)->record.bytes})) return false;
  }
}

}  // namespace

std::uint64_t Replay::read(const std::vector<std::string>& topics, std::uint64_t from_ns, std::uint64_t to_ns,
                           const Visit& visit) const {
  const Range range{from_ns, to_ns};
  std::uint64_t damages = 0;
  std::map<const Recording*, std::map<std::uint16_t, std::size_t>> of_files;  // topics by channel
  for (const Played& stream : played()) {
    const auto topic = static_cast<std::size_t>(std::ranges::find(topics, name_of(stream)) - topics.begin());
    if (topic == topics.size()) continue;
    const Recording& recording = *stream.recording;
    if (recording.session.one_file && !stream.made) {
      for (const logging::TopicStream& of_topic : logging::topic_streams(recording.session.one_file->index()))
        if (of_topic.info.topic == stream.file->topic)
          for (const std::uint16_t channel : of_topic.channels) of_files[&recording][channel] = topic;
    } else if (!read_stream(*open_stream(stream), topic, range, visit, damages)) {
      return damages;
    }
  }
  for (const auto& [recording, topic_of] : of_files)
    if (!read_file(recording->session.one_file, topic_of, recording->shift, range, visit, damages)) return damages;
  return damages;
}

}  // namespace robot::body
