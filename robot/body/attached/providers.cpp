#include "robot/body/attached/providers.h"

#include <utility>

#include "robot/core/clock.h"

namespace robot::body {
namespace {

/// Largest lead of a capture time over now. Times of another clock are wrong by far more.
constexpr std::uint64_t kToleranceNs = kSecond;

}  // namespace

DoorInProvider::DoorInProvider(std::shared_ptr<Connection> connection, memory::ChannelInfo info,
                               std::uint64_t epoch_offset_ns, Turns& turns)
    : connection_(std::move(connection)), info_(std::move(info)), epoch_offset_ns_(epoch_offset_ns), turns_(turns) {}

DoorInProvider::~DoorInProvider() { give_back_turn(); }

void DoorInProvider::give_back_turn() {
  if (std::exchange(has_turn_, false)) turns_.give_back(info_.topic);
}

Result<memory::ChannelInfo> DoorInProvider::open() {
  has_turn_ = turns_.take(info_.topic, "process " + std::to_string(connection_->peer().process), cancelled_);
  if (!has_turn_) return Error{"door: " + info_.topic + ": cancelled before its turn came"};
  return info_;
}

/// Ends the connection and sends the reason to the other side.
Error DoorInProvider::refuse(std::string sentence) {
  ended_ = true;
  connection_->send(logging::refused_frame({sentence}));
  connection_->end();
  return Error{"door: " + std::move(sentence)};
}

Result<std::optional<logging::Record>> DoorInProvider::read() {
  while (!ended_) {
    Result<std::optional<logging::Frame>> frame = connection_->next();
    if (!frame) return refuse(info_.topic + ": " + frame.error());
    if (*frame) {
      Result<std::optional<logging::Record>> record = take(std::move(**frame));
      if (!record || *record) return record;
      continue;
    }
    connection_->wait();
    ended_ = cancelled_ || !connection_->receive();
  }
  give_back_turn();
  return std::optional<logging::Record>();
}

/// Returns the message in `frame`, or nothing if it holds none.
Result<std::optional<logging::Record>> DoorInProvider::take(logging::Frame frame) {
  if (auto* record = std::get_if<logging::Record>(&frame)) return checked(std::move(*record));
  if (std::holds_alternative<logging::SharedMemory>(frame)) return std::optional<logging::Record>();
  const auto* shared = std::get_if<logging::SharedMessage>(&frame);
  if (!shared) return refuse(info_.topic + ": expected a message, got something else");
  Result<std::string> bytes = connection_->copy(*shared);
  if (!bytes) return refuse(info_.topic + ": " + bytes.error());
  // frees the message's place; a failure is ignored: a process that has disconnected or does not read loses only its
  // own places
  connection_->send(logging::taken_frame({shared->sequence}));
  return checked({.sequence = shared->sequence,
                  .capture_ns = shared->capture_ns,
                  .publish_ns = shared->publish_ns,
                  .bytes = std::move(*bytes)});
}

Result<std::optional<logging::Record>> DoorInProvider::checked(logging::Record record) {
  if (record.sequence <= last_sequence_)
    return refuse(info_.topic + ": expected sequence numbers that rise, got " + std::to_string(record.sequence) +
                  " after " + std::to_string(last_sequence_));
  if (const std::uint64_t now_ns = monotonic_ns(); record.capture_ns > now_ns + kToleranceNs)
    return refuse(info_.topic + ": expected capture times of the monotonic clock, now " + std::to_string(now_ns) +
                  " ns, got " + std::to_string(record.capture_ns) + " ns");
  if (last_sequence_ != 0) lost_ += record.sequence - last_sequence_ - 1;
  last_sequence_ = record.sequence;
  record.capture_ns += epoch_offset_ns_;
  record.publish_ns += epoch_offset_ns_;
  return std::optional<logging::Record>(std::move(record));
}

void DoorInProvider::cancel() {
  cancelled_ = true;
  turns_.wake();
  connection_->end();
}

Result<void> DoorOutProvider::open(const memory::ChannelInfo& info) {
  send(logging::channel_frame(info));
  return {};
}

Result<void> DoorOutProvider::write(const memory::VersionPtr& version) {
  send(logging::message_frame_head(*version, epoch_offset_ns_));
  send(version->bytes());
  return {};
}

void DoorOutProvider::send(std::string_view bytes) { gone_ = gone_ || !connection_->send_waiting(bytes); }

Result<void> DoorOutProvider::close() {
  connection_->end();
  return {};
}

}  // namespace robot::body
