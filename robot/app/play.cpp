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

}  // namespace

Result<void> play(const PlayOptions& options) {
  block_end_signals();
  auto replay = body::Replay::open(options.session, {.speed = options.speed, .loop = options.loop});
  if (!replay) return Error{replay.error()};
  const Clock& clock = (*replay)->clock();
  const auto own = std::make_shared<LabObjects>(clock);
  Runtime runtime({.program = "foresight-lab",
                   .body = "recording",
                   .robot = (*replay)->session().info.robot,
                   .server = options.server,
                   .log_folder = std::filesystem::absolute(options.session).lexically_normal().parent_path(),
                   .log_bytes = std::numeric_limits<std::uint64_t>::max(),
                   .records = false},
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
