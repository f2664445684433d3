#include "robot/memory/channels.h"

#include <algorithm>
#include <mutex>

namespace robot::memory {
namespace {

std::shared_ptr<Channel> find_in(const std::vector<std::shared_ptr<Channel>>& channels, std::string_view topic) {
  const auto found = std::ranges::find(channels, topic, [](const auto& channel) { return channel->info().topic; });
  return found == channels.end() ? nullptr : *found;
}

}  // namespace

Result<void> Channels::add(std::shared_ptr<Channel> channel) {
  const std::lock_guard adding(adding_);
  {
    const std::lock_guard guard(lock_);
    const std::string& topic = channel->info().topic;
    if (find_in(channels_, topic)) return Error{"channel " + topic + ": the topic is taken by another channel"};
    channels_.push_back(channel);
  }
  for (const auto& [id, watcher] : watchers_) watcher(channel);
  return {};
}

std::vector<std::shared_ptr<Channel>> Channels::all() const {
  const std::lock_guard guard(lock_);
  return channels_;
}

std::shared_ptr<Channel> Channels::find(std::string_view topic) const {
  const std::lock_guard guard(lock_);
  return find_in(channels_, topic);
}

Channels::WatcherId Channels::watch(std::function<void(const std::shared_ptr<Channel>&)> watcher) {
  const std::lock_guard adding(adding_);
  for (const auto& channel : all()) watcher(channel);
  watchers_.emplace(++last_watcher_, std::move(watcher));
  return last_watcher_;
}

void Channels::unwatch(WatcherId watcher) {
  const std::lock_guard adding(adding_);
  watchers_.erase(watcher);
}

}  // namespace robot::memory
