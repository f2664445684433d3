#include "robot/body/replay/track.h"

#include <set>
#include <utility>

namespace robot::body {
namespace {

std::set<std::uint16_t> channels_of(const std::vector<logging::TopicStream>& topics) {
  std::set<std::uint16_t> all;
  for (const logging::TopicStream& topic : topics) all.insert(topic.channels.begin(), topic.channels.end());
  return all;
}

}  // namespace

FileTrack::FileTrack(std::shared_ptr<const logging::McapFile> file, const std::vector<logging::TopicStream>& topics,
                     const ClockShift& shift, const std::atomic<bool>& cancelled)
    : shift_(shift), reader_(std::move(file), channels_of(topics), &cancelled) {
  for (std::size_t i = 0; i < topics.size(); ++i) {
    for (const std::uint16_t channel : topics[i].channels) topic_of_[channel] = i;
    if (!shift.is_none()) shifts_.push_back(std::make_unique<memory::TimeShift>(topics[i].info, shift));
  }
}

std::optional<Track::Message> FileTrack::next() {
  if (!ahead_.empty()) {
    Message message = by_our_time(std::move(ahead_.front()));
    ahead_.pop_front();
    return message;
  }
  while (true) {
    Result<std::optional<logging::McapMessage>> message = reader_.next();
    if (!message) continue;
    if (!*message) return std::nullopt;
    return by_our_time(std::move(**message));
  }
}

void FileTrack::seek(std::uint64_t capture_ns) {
  std::vector<logging::McapMessage> newest = reader_.move_to(shift_.back(capture_ns));
  ahead_.assign(std::make_move_iterator(newest.begin()), std::make_move_iterator(newest.end()));
}

Track::Message FileTrack::by_our_time(logging::McapMessage message) {
  Message ours{.topic = topic_of_.at(message.channel_id), .record = std::move(message.record)};
  if (shifts_.empty()) return ours;
  memory::TimeShift& shift = *shifts_[ours.topic];
  ours.record.bytes = shift.moved(std::move(ours.record.bytes), ours.record.capture_ns);
  ours.record.capture_ns = shift(ours.record.capture_ns);
  return ours;
}

std::optional<Track::Message> StreamTrack::next() {
  while (!cancelled_.load(std::memory_order_relaxed)) {
    Result<std::optional<logging::Record>> record = stream_->read();
    if (!record) continue;
    if (!*record) return std::nullopt;
    return Message{.topic = 0, .record = std::move(**record)};
  }
  return std::nullopt;
}

void StreamTrack::seek(std::uint64_t capture_ns) {
  // after an Error the stream goes on where it is
  static_cast<void>(stream_->seek(capture_ns));
}

}  // namespace robot::body
