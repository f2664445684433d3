#include "robot/memory/channel.h"

#include <algorithm>
#include <cassert>
#include <mutex>
#include <utility>

namespace robot::memory {
namespace {

class RawVersion final : public Version {
 public:
  explicit RawVersion(std::string bytes) : bytes_(std::move(bytes)) {}
  std::string_view bytes() const override { return bytes_; }

 private:
  std::string bytes_;
};

bool is_number(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

ObjectName object_name(std::string_view topic) {
  if (topic.starts_with('/')) topic.remove_prefix(1);
  const std::size_t team_end = topic.find('/');
  const std::size_t player_end = team_end == std::string_view::npos ? team_end : topic.find('/', team_end + 1);
  const bool of_robot = player_end != std::string_view::npos && is_number(topic.substr(0, team_end)) &&
                        is_number(topic.substr(team_end + 1, player_end - team_end - 1));
  if (!of_robot) return {.robot = {}, .object = topic};
  return {.robot = topic.substr(0, player_end), .object = topic.substr(player_end + 1)};
}

std::string_view name(Delivery delivery) {
  switch (delivery) {
    case Delivery::latest: return "latest";
    case Delivery::fifo: return "fifo";
    case Delivery::reliable: return "reliable";
  }
  return "?";
}

VersionPtr with_bytes(const Version& original, std::uint64_t sequence, std::string bytes) {
  auto version = std::make_shared<RawVersion>(std::move(bytes));
  version->sequence_ = sequence;
  version->capture_ns_ = original.capture_ns();
  version->publish_ns_ = original.publish_ns();
  version->size_bytes_ = version->bytes().size();
  return version;
}

void Channel::announce(ChannelInfo info, const Clock& clock) {
  assert(!clock_ && "a channel is announced once");
  info_ = std::move(info);
  clock_ = &clock;
}

VersionPtr Channel::newest() const {
  const std::lock_guard guard(newest_lock_);
  return newest_;
}

void Channel::attach(Listener& listener) {
  const std::lock_guard guard(writers_);
  listeners_.push_back(&listener);
  if (const VersionPtr version = newest()) listener.on_version(version);
}

void Channel::detach(Listener& listener) {
  const std::lock_guard guard(writers_);
  std::erase(listeners_, &listener);
}

VersionPtr Channel::publish(std::shared_ptr<Version> version, std::uint64_t capture_ns, std::size_t size_bytes,
                            const Published* elsewhere) {
  assert(clock_ && "a channel is announced before it is written");
  version->capture_ns_ = capture_ns;
  version->publish_ns_ = elsewhere ? elsewhere->publish_ns : clock_->now_ns();
  version->size_bytes_ = size_bytes;

  const std::lock_guard guard(writers_);
  ++last_sequence_;
  if (elsewhere) last_sequence_ = std::max(last_sequence_, elsewhere->sequence);
  version->sequence_ = last_sequence_;
  VersionPtr shared = std::move(version);
  for (Listener* listener : listeners_) listener->on_version(shared);

  const std::lock_guard newest_guard(newest_lock_);
  newest_.swap(shared);
  return shared;
}

RawChannel::RawChannel(ChannelInfo info, const Clock& clock) { announce(std::move(info), clock); }

Result<void> RawChannel::write_bytes(std::string_view bytes, std::uint64_t capture_ns) {
  publish(std::make_shared<RawVersion>(std::string(bytes)), capture_ns, bytes.size());
  return {};
}

void RawChannel::relay(std::string bytes, std::uint64_t capture_ns, Published published) {
  const std::size_t size_bytes = bytes.size();
  publish(std::make_shared<RawVersion>(std::move(bytes)), capture_ns, size_bytes, &published);
}

}  // namespace robot::memory
