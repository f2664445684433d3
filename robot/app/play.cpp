#include "robot/app/play.h"

#include <limits>

#include "robot/app/runtime.h"
#include "robot/app/signals.h"
#include "robot/body/replay/replay.h"

namespace robot::app {
namespace {

/// What the lab's own process says of itself; everything else on its channels comes from the recording.
struct LabObjects {
  explicit LabObjects(const Clock& clock) {
    runtime.announce("/lab/1/runtime", memory::Delivery::latest, clock);
    clock_sample.announce("/lab/1/clock", memory::Delivery::reliable, clock);
    log.announce("/lab/1/log", memory::Delivery::reliable, clock);
  }
  memory::MemoryObject<foresight::RuntimeStatistics> runtime;
  memory::MemoryObject<foresight::ClockSample> clock_sample;
  memory::MemoryObject<foresight::LogText> log;
};

class RecordingPlayback final : public net::Playback {
 public:
  explicit RecordingPlayback(body::Replay& replay) : replay_(replay) {}

  std::uint64_t start_ns() const override { return replay_.start_ns(); }
  std::uint64_t end_ns() const override { return replay_.end_ns(); }

  State state() const override {
    using Status = net::foxglove::Playback;
    const body::PlaybackClock& clock = replay_.clock();
    const std::uint64_t now_ns = clock.now_ns();
    const Status running = now_ns < end_ns() ? Status::playing : Status::ended;
    return {.status = clock.running() ? running : Status::paused,
            .time_ns = now_ns,
            .speed = static_cast<float>(clock.speed())};
  }

  bool control(const net::foxglove::PlaybackControl& wish) override {
    body::PlaybackClock& clock = replay_.clock();
    // who wants to play what has ended wants to see it again
    const bool again = wish.play && !wish.seek_ns && clock.now_ns() >= end_ns();
    clock.set(wish.play,
              static_cast<double>(wish.speed));  // first: what is paused stands exactly where it was moved to
    if (wish.seek_ns || again) clock.seek(wish.seek_ns.value_or(start_ns()));
    return wish.seek_ns || again;
  }

 private:
  body::Replay& replay_;
};

}  // namespace

Result<void> play(const PlayOptions& options) {
  block_end_signals();
  auto replay = body::Replay::open(options.sessions, {.speed = options.speed, .loop = options.loop});
  if (!replay) return Error{replay.error()};
  const Clock& clock = (*replay)->clock();
  const auto own = std::make_shared<LabObjects>(clock);
  RecordingPlayback playback(**replay);
  Runtime runtime({.program = "foresight-lab",
                   .body = "recording",
                   .robot = (*replay)->robots().front(),
                   .server = options.server,
                   .log_folder = std::filesystem::absolute(options.sessions.front()).lexically_normal().parent_path(),
                   .log_bytes = std::numeric_limits<std::uint64_t>::max(),
                   .records = false,
                   .playback = &playback},
                  clock, {.runtime = own->runtime, .clock = own->clock_sample, .log = own->log});
  for (memory::Channel* channel : std::initializer_list<memory::Channel*>{&own->runtime, &own->clock_sample, &own->log})
    if (Result<void> listed = runtime.channels().add({own, channel}); !listed) return listed;
  if (Result<void> started = runtime.start(); !started) return started;
  (*replay)->start(runtime.channels(), runtime.board());
  runtime.run([&] {
    if ((*replay)->tick() == body::Replay::Tick::began_again) runtime.server().restart_time();
    return true;  // a recording that has ended still shows its last moment
  });
  (*replay)->stop();
  return {};
}

}  // namespace robot::app
