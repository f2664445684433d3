#include "robot/logging/recent/recent_past.h"

#include <mutex>
#include <utility>

#include "robot/core/attempt.h"
#include "robot/core/clock.h"
#include "robot/core/thread.h"

namespace robot::logging {
namespace {

// The versions that wait must still be in the caches: a period of 1 s cost the process 10 % instead of 4 %.
constexpr std::uint64_t kPeriodNs = kSecond / 5;

}  // namespace

/// The stream of one channel to the file. It is called with `carrying_` held.
class RecentPast::Provider final : public OutProvider {
 public:
  Provider(RecentFile& file, std::size_t message_bytes) : file_(file), message_bytes_(message_bytes) {}

  Result<void> open(const memory::ChannelInfo& info) override {
    channel_ = file_.add(info);
    return {};
  }
  bool wants(const memory::Version& version) override { return version.size_bytes() <= message_bytes_; }
  Result<void> write(const memory::VersionPtr& version) override {
    return file_.write(channel_, {version->sequence(), version->capture_ns(), version->publish_ns(), version->bytes()});
  }
  Result<void> close() override { return {}; }

 private:
  RecentFile& file_;
  const std::size_t message_bytes_;
  std::size_t channel_ = 0;
};

RecentPast::RecentPast(memory::Channels& channels, const RecentPastLimits& limits)
    : channels_(channels), limits_(limits), file_(limits.file) {
  watcher_ = channels_.watch([this](const std::shared_ptr<memory::Channel>& channel) { add(channel); });
  if (const Result<void> started = start_thread(thread_, "log recent", [this] { run(); }); !started)
    report(Level::error, "logging", started.error() + "; viewers that come late see no past");
}

RecentPast::~RecentPast() {
  channels_.unwatch(watcher_);
  {
    const std::lock_guard guard(lock_);
    ended_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void RecentPast::add(const std::shared_ptr<memory::Channel>& channel) {
  if (channel->info().schema.name.ends_with("Image")) return;
  auto provider = std::make_unique<Provider>(file_, limits_.message_bytes);
  auto carrier = std::make_shared<Carrier>(channel, std::move(provider), limits_.queue_bytes);
  {
    const std::lock_guard guard(lock_);
    carriers_.push_back(carrier);
  }
  carrier->attach();
}

/// Carries all queued versions.
void RecentPast::carry() {
  std::vector<std::shared_ptr<Carrier>> carriers;
  {
    const std::lock_guard guard(lock_);
    carriers = carriers_;
  }
  for (const auto& carrier : carriers) {
    const std::lock_guard guard(carrying_);
    while (carrier->carry_queued()) {
    }
  }
}

std::uint64_t RecentPast::dropped() const {
  const std::lock_guard guard(lock_);
  std::uint64_t dropped = 0;
  for (const auto& carrier : carriers_) dropped += carrier->status().dropped;
  return dropped;
}

void RecentPast::warn_of_drops() {
  const std::uint64_t dropped = this->dropped();
  if (dropped == warned_of_) return;
  warnings_.report(Level::warning, "logging",
                   "the processor is busy: the last minutes that viewers get lack " +
                       std::to_string(dropped - warned_of_) + " more messages; recordings are not affected");
  warned_of_ = dropped;
}

void RecentPast::run() {
  become_background_thread("log recent");
  for (;;) {
    if (const Result<void> done = attempt("keeping the last minutes", [this] { carry(); }); !done)
      report(Level::warning, "logging", done.error());
    warn_of_drops();
    std::unique_lock guard(lock_);
    const std::uint64_t next = monotonic_ns() + kPeriodNs;
    while (!ended_ && monotonic_ns() < next) changed_.wait_until(lock_, next);
    if (ended_) return;
  }
}

Result<std::shared_ptr<const ByteSource>> RecentPast::file(std::span<const std::string> topics) {
  carry();
  const std::lock_guard guard(carrying_);
  return file_.file(topics);
}

}  // namespace robot::logging
