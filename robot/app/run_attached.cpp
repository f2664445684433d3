#include "robot/app/run_attached.h"

#include <memory>
#include <utility>

#include "robot/app/runtime.h"
#include "robot/app/services/foresight_service.h"
#include "robot/app/services/parameter_service.h"
#include "robot/body/attached/door.h"

namespace robot::app {

Result<void> run_attached(const RobotOptions& options, const OwnBody& own) {
  const RobotName robot = robot_named_by(options);
  const SessionClock clock;
  const auto memory = std::make_shared<memory::Memory>(robot.text(), clock);
  Runtime runtime(runtime_options(options, robot), clock, own_objects(*memory));
  if (Result<void> listed = list(memory, runtime.channels()); !listed) return listed;
  if (own.add_services) own.add_services(runtime.services());
  const auto foresight = ForesightService::open(foreseer_options(options), options.foresight.value_or(false), runtime,
                                                *memory, robot.text(), [&clock] { return clock.now_ns(); });
  if (!foresight) return foresight.failure();
  if (Result<void> listed = add_parameter_service(runtime.parameters(), robot.text(), runtime.channels(), clock);
      !listed)
    return listed;
  std::unique_ptr<body::Door> door;
  if (!options.plan) {
    body::DoorOptions at{.path = options.door.empty() ? body::default_door() : options.door, .robot = robot.text()};
    at.own_objects.merge(written_by_us(options));
    at.own_objects.insert(own.objects.begin(), own.objects.end());
    auto opened = body::Door::open(std::move(at), clock, runtime.channels(), runtime.board());
    if (!opened) return opened.failure();
    door = std::move(*opened);
  }
  const Result<bool> begun = begin(runtime, options);
  if (!begun) return begun.failure();
  if (!*begun) return {};
  const std::shared_ptr<void> body = own.begin ? own.begin(*memory, clock) : nullptr;
  runtime.run([] { return true; });
  return {};
}

}  // namespace robot::app
