#include "robot/net/foxglove/client_queue.h"

#include <utility>

#include "robot/net/foxglove/to_client.h"
#include "robot/net/websocket/frames.h"

namespace robot::net {
namespace {

constexpr std::size_t kFrameHeaderBytes = 10;

}  // namespace

ClientQueue::Slot* ClientQueue::find(std::uint32_t channel) {
  return channel < slots_.size() ? slots_[channel].get() : nullptr;
}

void ClientQueue::subscribe(std::uint32_t channel, std::uint32_t subscription, memory::Delivery delivery) {
  if (slots_.size() <= channel) slots_.resize(channel + 1);
  if (!slots_[channel]) slots_[channel] = std::make_unique<Slot>();
  Slot& slot = *slots_[channel];
  slot.channel = channel;
  slot.subscription = subscription;
  slot.delivery = delivery;
  slot.subscribed = true;
  slot.last_sequence = 0;
}

void ClientQueue::unsubscribe(std::uint32_t channel) {
  Slot* slot = find(channel);
  if (!slot) return;
  slot->subscribed = false;
  clear(*slot);
}

ClientQueue::Pushed ClientQueue::push(std::uint32_t channel, const memory::VersionPtr& version,
                                      std::optional<std::uint64_t> time_ns) {
  Slot* slot = find(channel);
  if (!slot || !slot->subscribed || finished_ || version->sequence() <= slot->last_sequence) return Pushed::known;
  if (!make_room(*slot, version->size_bytes())) return Pushed::overflow;
  slot->last_sequence = version->sequence();
  slot->waiting.push_back({version, time_ns.value_or(version->capture_ns())});
  slot->bytes += version->size_bytes();
  ++messages_;
  message_bytes_ += version->size_bytes();
  line_up(*slot);
  return Pushed::queued;
}

// a single message that exceeds the limit still passes
bool ClientQueue::make_room(Slot& slot, std::size_t bytes) {
  if (lossless_) return message_bytes_ == 0 || message_bytes_ + bytes <= limits_.lossless_bytes;
  switch (slot.delivery) {
    case memory::Delivery::latest:
      if (!slot.waiting.empty()) drop_oldest(slot);
      return true;
    case memory::Delivery::fifo:
      if (slot.waiting.size() >= limits_.fifo_messages) drop_oldest(slot);
      return true;
    case memory::Delivery::reliable: return slot.waiting.empty() || slot.bytes + bytes <= limits_.reliable_bytes;
  }
  return true;
}

void ClientQueue::drop_oldest(Slot& slot) {
  pop(slot);
  ++slot.dropped;
}

ClientQueue::Waiting ClientQueue::pop(Slot& slot) {
  Waiting first = std::move(slot.waiting.front());
  slot.waiting.pop_front();
  slot.bytes -= first.version->size_bytes();
  message_bytes_ -= first.version->size_bytes();
  --messages_;
  return first;
}

void ClientQueue::clear(Slot& slot) {
  message_bytes_ -= slot.bytes;
  messages_ -= slot.waiting.size();
  slot.bytes = 0;
  slot.waiting.clear();
}

void ClientQueue::count_lost(std::uint32_t channel, std::uint64_t messages) {
  if (Slot* slot = find(channel); slot && slot->subscribed) slot->dropped += messages;
}

bool ClientQueue::push_control(std::string frame) {
  if (finished_) return true;
  if (control_bytes_ + frame.size() > limits_.control_bytes) return false;
  control_bytes_ += frame.size();
  control_.push_back(std::move(frame));
  return true;
}

void ClientQueue::forget() {
  time_ns_.reset();
  if (lossless_) return;
  for (const auto& slot : slots_)
    if (slot && slot->delivery != memory::Delivery::reliable) clear(*slot);
}

void ClientQueue::finish(std::string close_frame) {
  if (finished_) return;
  for (const auto& slot : slots_)
    if (slot) clear(*slot);
  time_ns_.reset();
  control_bytes_ += close_frame.size();
  control_.push_back(std::move(close_frame));
  finished_ = true;
}

bool ClientQueue::fill(Batch& batch) {
  batch.bytes.clear();
  batch.large = {};
  batch.keeper.reset();

  if (!take_control(batch)) return true;
  if (time_ns_) append_frame(batch.bytes, Opcode::binary, foxglove::time(*std::exchange(time_ns_, std::nullopt)));
  for (auto& lane : lanes_)
    while (!lane.empty())
      if (!take_message(batch, lane)) return true;
  return !batch.bytes.empty();
}

/// Returns false when the batch is full.
bool ClientQueue::take_control(Batch& batch) {
  while (!control_.empty()) {
    std::string& frame = control_.front();
    if (!batch.bytes.empty() && batch.bytes.size() + frame.size() > kBatchBytes) return false;
    control_bytes_ -= frame.size();
    batch.bytes.empty() ? batch.bytes.swap(frame) : static_cast<void>(batch.bytes += frame);
    control_.pop_front();
  }
  return batch.bytes.size() < kBatchBytes;
}

/// Puts a slot into the lane of its first message. A newer message of another size may replace that one in the lane.
void ClientQueue::line_up(Slot& slot) {
  if (slot.in_lane) return;
  slot.in_lane = true;
  const bool is_large = slot.waiting.front().version->size_bytes() >= kLargeBytes;
  lanes_[slot.delivery == memory::Delivery::reliable ? events : is_large ? large : small].push_back(&slot);
}

/// Returns false when the batch is full.
bool ClientQueue::take_message(Batch& batch, std::deque<Slot*>& lane) {
  Slot& slot = *lane.front();
  if (!slot.waiting.empty()) {
    const std::size_t size = slot.waiting.front().version->size_bytes();
    const std::size_t copied = kFrameHeaderBytes + foxglove::kNumberedDataHeaderBytes + (size < kLargeBytes ? size : 0);
    if (!batch.bytes.empty() && batch.bytes.size() + copied > kBatchBytes) return false;
    take_front(batch, slot);
  }
  lane.pop_front();
  slot.in_lane = false;
  if (!slot.waiting.empty()) line_up(slot);
  return !batch.keeper;
}

void ClientQueue::take_front(Batch& batch, Slot& slot) {
  const auto [version, time_ns] = pop(slot);
  ++slot.sent;

  const std::string_view payload = version->bytes();
  const std::size_t header = numbered_ ? foxglove::kNumberedDataHeaderBytes : foxglove::kMessageDataHeaderBytes;
  append_frame_header(batch.bytes, Opcode::binary, header + payload.size());
  if (numbered_)
    foxglove::append_numbered_data_header(batch.bytes, slot.subscription, time_ns,
                                          {.sequence = version->sequence(), .publish_ns = version->publish_ns()});
  else
    foxglove::append_message_data_header(batch.bytes, slot.subscription, time_ns);
  if (payload.size() < kLargeBytes) {
    batch.bytes += payload;
    return;
  }
  batch.large = payload;
  batch.keeper = version;
}

std::vector<ClientQueue::Counts> ClientQueue::counts() const {
  std::vector<Counts> counts;
  for (const auto& slot : slots_)
    if (slot)
      counts.push_back({slot->channel, slot->sent, slot->dropped, slot->waiting.size(), slot->bytes, slot->subscribed});
  return counts;
}

std::uint64_t ClientQueue::dropped() const {
  std::uint64_t dropped = 0;
  for (const auto& slot : slots_)
    if (slot) dropped += slot->dropped;
  return dropped;
}

}  // namespace robot::net
