#include "robot/app/run_replay.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "robot/app/runtime.h"
#include "robot/app/services/foresight_service.h"
#include "robot/body/replay/replay.h"

namespace robot::app {

Result<void> run_replay(const RobotOptions& options) {
  if (options.session.empty()) return Error{"--session: body replay needs the folder of a session, got none"};
  const auto recorded = logging::read_session(options.session);
  if (!recorded) return recorded.failure();
  const RobotName robot{.team = options.team.value_or(recorded->info.team),
                        .player = options.player.value_or(recorded->info.player)};
  // this process writes these objects itself
  std::vector<std::string> skipped{"runtime", "clock", "log", "what_if"};
  for (const std::string& object : written_by_us(options)) skipped.push_back(object);
  auto replay = body::Replay::open(
      {options.session},
      {.speed = options.speed, .loop = options.loop, .robot = robot.text(), .skipped_objects = std::move(skipped)});
  if (!replay) return replay.failure();
  const auto memory = std::make_shared<memory::Memory>(robot.text(), (*replay)->clock());
  RuntimeOptions own = runtime_options(options, robot);
  if (options.rules.empty()) own.rules = (*replay)->rules();
  Runtime runtime(own, (*replay)->clock(), own_objects(*memory));
  if (Result<void> listed = list(memory, runtime.channels()); !listed) return listed;
  const auto foresight =
      ForesightService::open(foreseer_options(options), options.foresight.value_or(false), runtime, *memory,
                             robot.text(), [&clock = (*replay)->clock()] { return clock.now_ns(); });
  if (!foresight) return foresight.failure();
  const Result<bool> begun = begin(runtime, options);
  if (!begun) return begun.failure();
  if (!*begun) return {};
  if (Result<void> started = (*replay)->start(runtime.channels(), runtime.board()); !started) return started;
  runtime.run([&] {
    if ((*replay)->tick() == body::Replay::Tick::began_again) runtime.server().restart_time();
    return true;
  });
  (*replay)->stop();
  return {};
}

}  // namespace robot::app
