#include "robot/app/run_attached.h"

#include <memory>
#include <optional>
#include <utility>

#include "robot/agent/agent_thread.h"
#include "robot/app/runtime.h"
#include "robot/app/services/foresight_service.h"
#include "robot/app/services/live_parameter_service.h"
#include "robot/app/services/parameter_service.h"
#include "robot/body/attached/door.h"
#include "robot/foresight/following.h"

namespace robot::app {
namespace {

/// Loads our behaviour that decides on the robot. Returns nothing without --behaviour.
Result<std::optional<agent::Agent>> agent_of(const RobotOptions& options) {
  if (options.behaviour.empty()) return std::optional<agent::Agent>();
  const bool chooses = !options.strategies.empty();
  if (chooses && options.strategies.front() != options.behaviour)
    return Error{"--behaviour: expected the first of --strategies, '" + options.strategies.front() + "', got '" +
                 options.behaviour + "'"};
  auto agent = agent::Agent::load({.behaviour = options.behaviour,
                                   .strategies = options.strategies,
                                   .stale = foreseeing::Following::kStaleTicks,
                                   .rules = rules_of(options),
                                   .models = own_models_of(options)});
  if (!agent) return agent.failure("--behaviour");
  return std::optional(std::move(*agent));
}

}  // namespace

Result<void> run_attached(const RobotOptions& options, const OwnBody& own) {
  const RobotName robot = robot_named_by(options);
  Result<std::optional<agent::Agent>> agent = agent_of(options);
  if (!agent) return agent.failure();
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
  const auto live_parameters =
      LiveParameterService::open(runtime.parameters(), robot.text(), runtime.channels(), clock);
  if (!live_parameters) return live_parameters.failure();
  std::unique_ptr<body::Door> door;
  if (!options.plan) {
    body::DoorOptions at{.path = options.door.empty() ? body::default_door() : options.door, .robot = robot.text()};
    at.own_objects.merge(written_by_us(options));
    at.own_objects.insert(own.objects.begin(), own.objects.end());
    at.on_end = [service = live_parameters->get()](const std::string& topic) { service->ended(topic); };
    auto opened = body::Door::open(std::move(at), clock, runtime.channels(), runtime.board());
    if (!opened) return opened.failure();
    door = std::move(*opened);
  }
  const Result<bool> begun = begin(runtime, options);
  if (!begun) return begun.failure();
  if (!*begun) return {};
  const Result<std::shared_ptr<void>> body =
      own.begin ? own.begin(*memory, clock, runtime) : Result<std::shared_ptr<void>>(nullptr);
  if (!body) return body.failure();
  std::optional<agent::AgentThread> deciding;
  if (*agent) {
    deciding.emplace(std::move(**agent), *memory, runtime.channels(), robot.text(), clock);
    if (Result<void> started = deciding->start(); !started) return started;
  }
  runtime.run([] { return true; });
  return {};
}

}  // namespace robot::app
