#include "robot/app/recording_playback.h"

#include <string>
#include <utility>

#include "robot/body/replay/topic_player.h"

namespace robot::app {
namespace {

using Status = net::foxglove::Playback;

/// The span of a recording [ns since the epoch].
struct Span {
  std::uint64_t start_ns, end_ns;
};

net::Playhead::State state_of(const body::PlaybackClock& clock, const Span& span) {
  const std::uint64_t now_ns = clock.now_ns();
  const Status running = now_ns < span.end_ns ? Status::playing : Status::ended;
  return {.status = clock.running() ? running : Status::paused,
          .time_ns = now_ns,
          .speed = static_cast<float>(clock.speed())};
}

/// Sets the clock as `wish` says. Returns the place to seek, if any.
std::optional<std::uint64_t> set_clock(body::PlaybackClock& clock, const net::foxglove::PlaybackControl& wish,
                                       const Span& span) {
  // "play" at the end of the recording begins again at its start
  const bool again = wish.play && !wish.seek_ns && clock.now_ns() >= span.end_ns;
  // set before seek: a paused clock then stays exactly at the time of the seek
  clock.set(wish.play, static_cast<double>(wish.speed));
  return again ? span.start_ns : wish.seek_ns;
}

/// A playhead of one client. `counted` has room for it.
class ClientPlayhead final : public net::OwnPlayhead {
 public:
  ClientPlayhead(const body::Replay& replay, double speed, bool loop, std::uint64_t from_ns,
                 std::shared_ptr<std::atomic<int>> counted)
      : span_{replay.start_ns(), replay.end_ns()},
        loop_(loop),
        counted_(std::move(counted)),
        player_(replay, speed, from_ns) {}
  ~ClientPlayhead() override { counted_->fetch_sub(1); }

  Result<void> start() { return player_.start(); }

  State state() const override { return state_of(player_.clock(), span_); }

  bool control(const net::foxglove::PlaybackControl& wish) override {
    const auto seek_ns = set_clock(player_.clock(), wish, span_);
    if (seek_ns) player_.seek(*seek_ns);
    return seek_ns.has_value();
  }

  std::shared_ptr<memory::Channel> watch(const memory::ChannelInfo& info) override { return player_.watch(info); }
  void unwatch(const std::string& topic) override { player_.unwatch(topic); }

  bool loop() override {
    if (!loop_ || !player_.clock().running() || !player_.at_end()) return false;
    player_.seek(span_.start_ns);
    return true;
  }

 private:
  const Span span_;
  const bool loop_;
  const std::shared_ptr<std::atomic<int>> counted_;
  body::TopicPlayer player_;
};

}  // namespace

net::Playhead::State RecordingPlayback::state() const { return state_of(replay_.clock(), {start_ns(), end_ns()}); }

bool RecordingPlayback::control(const net::foxglove::PlaybackControl& wish) {
  const auto seek_ns = set_clock(replay_.clock(), wish, {start_ns(), end_ns()});
  if (seek_ns) replay_.clock().seek(*seek_ns);
  return seek_ns.has_value();
}

Result<std::unique_ptr<net::OwnPlayhead>> RecordingPlayback::own_playhead(std::optional<std::uint64_t> from_ns) {
  if (own_->fetch_add(1) >= kMostOwnPlayheads) {
    own_->fetch_sub(1);
    return Error{std::to_string(kMostOwnPlayheads) +
                 " pages have a playhead of their own, and there are no more: this one follows the shared playback"};
  }
  if (from_ns && (*from_ns < start_ns() || *from_ns > end_ns())) from_ns.reset();
  auto playhead = std::make_unique<ClientPlayhead>(replay_, speed_, loop_, from_ns.value_or(start_ns()), own_);
  if (Result<void> started = playhead->start(); !started) return started.failure();
  return std::unique_ptr<net::OwnPlayhead>(std::move(playhead));
}

}  // namespace robot::app
